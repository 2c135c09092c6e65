/**
 * @file DualContours.h
 * @brief Volumes and surfaces for the tests of dual contouring, and their contours.
 */
#ifndef isthmus_DualContours_h
#define isthmus_DualContours_h

#include "Core/PolyDataTriangles.h"
#include "vtkDualContouring.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>

namespace isthmus::testing
{

/// `f` on n^3 nodes from -1 to 1.
template <typename Function>
vtkSmartPointer<vtkImageData> SampleImage(int n, Function&& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  const double h = 2.0 / (n - 1);
  image->SetSpacing(h, h, h);
  image->SetOrigin(-1, -1, -1);
  vtkNew<vtkDoubleArray> values;
  values->SetName("Density");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    image->GetPoint(i, p.data());
    values->InsertNextValue(f(p));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// The contour with properties set by `change`.
template <typename Change>
TriangleMesh ComputeContour(vtkDataObject* input, Change&& change)
{
  vtkNew<vtkDualContouring> filter;
  filter->SetInputDataObject(input);
  filter->SetLevel(0.0);
  change(filter.Get());
  filter->Update();
  return ToTriangleMesh(filter->GetOutput());
}

inline TriangleMesh ComputeContour(vtkDataObject* input)
{
  return ComputeContour(input, [](vtkDualContouring*) {});
}

template <typename Change>
TriangleMesh ComputeContour(const TriangleMesh& mesh, Change&& change)
{
  vtkNew<vtkPolyData> surface;
  SetMesh(mesh, surface);
  return ComputeContour(surface, change);
}

inline TriangleMesh Octahedron(double r)
{
  TriangleMesh mesh;
  mesh.Points = { { r, 0, 0 }, { -r, 0, 0 }, { 0, r, 0 }, { 0, -r, 0 }, { 0, 0, r }, { 0, 0, -r } };
  mesh.Triangles = { { 0, 2, 4 }, { 2, 1, 4 }, { 1, 3, 4 }, { 3, 0, 4 }, { 2, 0, 5 }, { 1, 2, 5 },
    { 3, 1, 5 }, { 0, 3, 5 } };
  return mesh;
}

/// A turned copy, so that nothing is aligned with the grid.
inline TriangleMesh Rotate(TriangleMesh mesh)
{
  const double c = std::cos(0.4), s = std::sin(0.4);
  for (Point3& p : mesh.Points)
  {
    p = { c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
    p = { p[0], c * p[1] - s * p[2], s * p[1] + c * p[2] };
  }
  return mesh;
}

}

#endif
