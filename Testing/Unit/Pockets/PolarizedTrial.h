/**
 * @file PolarizedTrial.h
 * @brief Ellipsoids with their exact curvatures in potentials that are formulas.
 */
#ifndef isthmus_PolarizedTrial_h
#define isthmus_PolarizedTrial_h

#include "vtkPolarizedCurvature.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTestErrorObserver.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace isthmus::testing
{

using Field = std::function<double(const double*)>;

/// A point array of doubles with the values of `f` at the points.
inline void AddArray(vtkDataSet* data, const char* name, const Field& f)
{
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    array->InsertNextValue(f(data->GetPoint(i)));
  }
  data->GetPointData()->AddArray(array);
}

/// Ellipsoid with these half axes and its exact curvatures: a fine triangulation by latitude.
inline vtkSmartPointer<vtkPolyData> Ellipsoid(double a, double b, double c, int rings = 240)
{
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> triangles;
  const int around = 2 * rings;
  const auto id = [&](int ring, int j) -> vtkIdType
  {
    return ring == 0
      ? 0
      : (ring == rings ? 1 : 2 + static_cast<vtkIdType>(ring - 1) * around + j % around);
  };
  points->InsertNextPoint(0, 0, c);
  points->InsertNextPoint(0, 0, -c);
  for (int ring = 1; ring < rings; ++ring)
  {
    for (int j = 0; j < around; ++j)
    {
      const double theta = M_PI * ring / rings, phi = 2.0 * M_PI * j / around;
      points->InsertNextPoint(a * std::sin(theta) * std::cos(phi),
        b * std::sin(theta) * std::sin(phi), c * std::cos(theta));
    }
  }
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int j = 0; j < around; ++j)
    {
      const vtkIdType low[3] = { id(ring, j), id(ring + 1, j), id(ring + 1, j + 1) };
      const vtkIdType high[3] = { id(ring, j), id(ring + 1, j + 1), id(ring, j + 1) };
      if (ring + 1 < rings)
      {
        triangles->InsertNextCell(3, low);
      }
      if (ring > 0)
      {
        triangles->InsertNextCell(3, high);
      }
    }
  }
  surface->SetPoints(points);
  surface->SetPolys(triangles);
  // Support distance h = 1 / |grad|: K = h^4 / (abc)^2, H from the trace of the shape operator.
  const auto principal = [=](const double* p, int which)
  {
    const double a2 = a * a, b2 = b * b, c2 = c * c;
    const double g = p[0] * p[0] / (a2 * a2) + p[1] * p[1] / (b2 * b2) + p[2] * p[2] / (c2 * c2);
    const double gaussian = 1.0 / (a2 * b2 * c2 * g * g);
    const double mean = (a2 + b2 + c2 - p[0] * p[0] - p[1] * p[1] - p[2] * p[2]) /
      (2.0 * a2 * b2 * c2 * std::pow(g, 1.5));
    const double d = std::sqrt(std::max(0.0, mean * mean - gaussian));
    return which == 1 ? mean + d : mean - d;
  };
  AddArray(surface, "MaximumCurvature", [=](const double* p) { return principal(p, 1); });
  AddArray(surface, "MinimumCurvature", [=](const double* p) { return principal(p, 2); });
  return surface;
}

inline vtkSmartPointer<vtkImageData> Image(double half, int nodes, const Field& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(-3, nodes - 4, 0, nodes - 1, 5, nodes + 4); // extents need not begin at 0
  const double h = 2.0 * half / (nodes - 1);
  image->SetSpacing(h, h, h);
  image->SetOrigin(-half + 3 * h, -half, -half - 5 * h);
  AddArray(image, "Potential", f);
  image->GetPointData()->SetActiveScalars("Potential");
  return image;
}

/// A filter whose messages are kept.
struct Trial
{
  Trial(vtkPolyData* surface, vtkImageData* image)
  {
    this->Filter->SetInputData(surface);
    if (image)
    {
      this->Filter->SetPotentialData(image);
    }
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filter->AddObserver(vtkCommand::WarningEvent, this->Observer);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->PipelineObserver);
  }
  vtkPolyData* Update()
  {
    this->Filter->Update();
    return this->Filter->GetOutput();
  }
  std::string Error() const { return this->Observer->GetErrorMessage(); }

  vtkNew<vtkPolarizedCurvature> Filter;
  vtkNew<vtkTest::ErrorObserver> Observer;
  vtkNew<vtkTest::ErrorObserver> PipelineObserver;
};

inline double Value(vtkPolyData* surface, const char* name, vtkIdType point)
{
  return surface->GetPointData()->GetArray(name)->GetComponent(point, 0);
}

/// Potential of a dipole of moment m along z at the origin, Phi = m z / r^3.
inline double Dipole(const double* p)
{
  const double r2 = p[0] * p[0] + p[1] * p[1] + p[2] * p[2];
  return 30.0 * p[2] / std::max(std::pow(r2, 1.5), 1e-3);
}

inline vtkImageData* DipoleImage()
{
  static const vtkSmartPointer<vtkImageData> image = Image(8.0, 161, Dipole);
  return image;
}

}

#endif
