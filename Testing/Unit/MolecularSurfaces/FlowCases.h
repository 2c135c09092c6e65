/**
 * @file FlowCases.h
 * @brief Atoms whose surfaces are known, and measures of the surfaces that filters make of them.
 */
#ifndef isthmus_FlowCases_h
#define isthmus_FlowCases_h

#include "BallPoints.h"
#include "Core/Geometry.h"
#include "Core/PolyDataTriangles.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"
#include "Surfaces/SurfaceMeasures.h"
#include "vtkMolecularFlowSurface.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <fstream>
#include <random>
#include <sstream>
#include <string>
#include <vector>

namespace isthmus::testing
{

/// Two balls of radius R, centers at +-`distance` R: the minimal surface around them.
struct Catenoid
{
  double Radius = 2.0;
  double Distance = 1.1;

  /// The angle at which the neck leaves the ball: cos t + sin^2 t asinh(cot t) = distance.
  double Angle() const
  {
    double low = 0.7; // where the larger of both solutions begins
    double high = 0.5 * Pi;
    for (int i = 0; i < 100; ++i)
    {
      const double t = 0.5 * (low + high);
      (Reach(t) > this->Distance ? low : high) = t;
    }
    return 0.5 * (low + high);
  }
  static double Reach(double t)
  {
    return std::cos(t) + std::sin(t) * std::sin(t) * std::asinh(1.0 / std::tan(t));
  }
  // Caps of both balls, and the catenoid r = c cosh(x / c) between x = -+c u.
  double Area() const
  {
    const double t = this->Angle();
    const double c = this->Radius * std::sin(t) * std::sin(t);
    const double u = std::asinh(1.0 / std::tan(t));
    const double cap = 2.0 * Pi * this->Radius * this->Radius * (1.0 + std::cos(t));
    return 2.0 * cap + 2.0 * Pi * c * c * (u + 0.5 * std::sinh(2.0 * u));
  }
  double Volume() const
  {
    const double t = this->Angle();
    const double c = this->Radius * std::sin(t) * std::sin(t);
    const double u = std::asinh(1.0 / std::tan(t));
    const double k = std::cos(t);
    const double cap = Pi * std::pow(this->Radius, 3) * (2.0 + 3.0 * k - k * k * k) / 3.0;
    return 2.0 * cap + Pi * c * c * c * (u + 0.5 * std::sinh(2.0 * u));
  }
  std::vector<Ball> Balls() const
  {
    const double x = this->Distance * this->Radius;
    return { { { -x, 0.0, 0.0 }, this->Radius }, { { x, 0.0, 0.0 }, this->Radius } };
  }
};

inline std::vector<Ball> RandomBalls(int count, double box)
{
  std::mt19937 random(11);
  std::uniform_real_distribution<double> place(0.0, box);
  std::uniform_real_distribution<double> radius(1.2, 2.0);
  std::vector<Ball> balls;
  for (int i = 0; i < count; ++i)
  {
    const double x = place(random);
    const double y = place(random);
    const double z = place(random);
    balls.push_back({ { x, y, z }, radius(random) });
  }
  return balls;
}

/// The atoms of a PQR file that have a radius.
inline std::vector<Ball> BallsOfPQR(const std::string& file)
{
  std::vector<Ball> balls;
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line))
  {
    std::istringstream words(line);
    std::vector<std::string> all;
    for (std::string word; words >> word;)
    {
      all.push_back(word);
    }
    const std::size_t n = all.size();
    if (n > 9 && (all[0] == "ATOM" || all[0] == "HETATM") && std::stod(all[n - 1]) > 0.0)
    {
      balls.push_back({ { std::stod(all[n - 5]), std::stod(all[n - 4]), std::stod(all[n - 3]) },
        std::stod(all[n - 1]) });
    }
  }
  return balls;
}

inline vtkSmartPointer<vtkMolecularFlowSurface> MakeFilter(vtkDataObject* atoms)
{
  auto filter = vtkSmartPointer<vtkMolecularFlowSurface>::New();
  filter->SetInputDataObject(atoms);
  return filter;
}

inline SurfaceMeasures MeasureFlowSurface(vtkPolyData* surface)
{
  return MeasureSurface(PolyDataTriangles(surface).View());
}

}

#endif
