/**
 * @file ChokingSurfaces.h
 * @brief Surfaces for the tests of choking loops: read from files, or level sets of formulas.
 */
#ifndef isthmus_ChokingSurfaces_h
#define isthmus_ChokingSurfaces_h

#include "Core/PolyDataTriangles.h"
#include "SharedData.h"

#include <vtkCleanPolyData.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>

namespace isthmus::testing
{

/// An OFF file, polygons cut into fans.
inline TriangleMesh ReadOFF(const std::string& path)
{
  std::ifstream in(path);
  std::string line;
  const auto next = [&in, &line] { // colours at the end of a line are ignored
    std::getline(in, line);
    return std::istringstream(line);
  };
  next();
  std::size_t points = 0;
  std::size_t faces = 0;
  next() >> points >> faces;
  TriangleMesh mesh;
  mesh.Points.resize(points);
  for (Point3& p : mesh.Points)
  {
    next() >> p[0] >> p[1] >> p[2];
  }
  for (std::size_t f = 0; f < faces; ++f)
  {
    std::istringstream words = next();
    std::size_t count = 0;
    words >> count;
    std::vector<std::int64_t> ids(count);
    for (std::int64_t& id : ids)
    {
      words >> id;
    }
    for (std::size_t k = 2; k < count; ++k)
    {
      mesh.Triangles.push_back({ ids[0], ids[k - 1], ids[k] });
    }
  }
  return mesh;
}

/// A file of the shared surfaces by its name.
inline TriangleMesh ReadSurface(const std::string& name)
{
  const std::string path = (SharedDataFolder() / "surfaces" / name).string();
  if (name.find(".off") != std::string::npos)
  {
    return ReadOFF(path);
  }
  if (name.find(".stl") != std::string::npos)
  {
    vtkNew<vtkSTLReader> reader;
    reader->SetFileName(path.c_str());
    reader->Update();
    return ToTriangleMesh(reader->GetOutput());
  }
  vtkNew<vtkOBJReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return ToTriangleMesh(reader->GetOutput());
}

/// The surface f = 0 in the box from `low` to `high`, f being negative inside; cells[k] cells along
/// axis k.
inline TriangleMesh LevelSet(const std::function<double(double, double, double)>& f,
  const Point3& low, const Point3& high, const std::array<int, 3>& cells)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(cells[0] + 1, cells[1] + 1, cells[2] + 1);
  image->SetOrigin(low.data());
  image->SetSpacing(
    (high[0] - low[0]) / cells[0], (high[1] - low[1]) / cells[1], (high[2] - low[2]) / cells[2]);
  vtkNew<vtkDoubleArray> values;
  values->SetNumberOfValues(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    values->SetValue(i, f(p[0], p[1], p[2]));
  }
  image->GetPointData()->SetScalars(values);
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputData(image);
  contour->SetValue(0, 0.0);
  contour->ComputeNormalsOff();
  contour->ComputeScalarsOff();
  vtkNew<vtkCleanPolyData> clean; // slivers of nodes that lie on the surface
  clean->SetInputConnection(contour->GetOutputPort());
  clean->SetTolerance(1e-6);
  clean->Update();
  return ToTriangleMesh(clean->GetOutput());
}

/// The same in the cube [-size, size]^3, n cells along a side.
inline TriangleMesh LevelSet(
  const std::function<double(double, double, double)>& f, double size, int n)
{
  return LevelSet(f, { -size, -size, -size }, { size, size, size }, { n, n, n });
}

/// The tangle cube, x^4 - 5 x^2 + y^4 - 5 y^2 + z^4 - 5 z^2 + 11.8 = 0.
inline TriangleMesh TangleCube(int n = 60)
{
  const auto term = [](double x) { return x * x * x * x - 5.0 * x * x; };
  return LevelSet([term](double x, double y, double z)
    { return term(x) + term(y) + term(z) + 11.8; },
    2.6 + 0.0137, n);
}

/// Surface of revolution round z of radius(z), from z0 to z1, closed by a point at either end.
inline TriangleMesh Revolution(
  const std::function<double(double)>& radius, double z0, double z1, int around, int along)
{
  TriangleMesh mesh;
  mesh.Points.push_back({ 0.0, 0.0, z0 });
  for (int j = 1; j < along; ++j)
  {
    // Rings close up towards the ends.
    const double z = 0.5 * (z0 + z1) - 0.5 * (z1 - z0) * std::cos(M_PI * j / along);
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * M_PI * (i + 0.5 * (j % 2)) / around;
      mesh.Points.push_back({ radius(z) * std::cos(angle), radius(z) * std::sin(angle), z });
    }
  }
  mesh.Points.push_back({ 0.0, 0.0, z1 });
  const auto id = [around](int i, int j) -> std::int64_t
  { return 1 + (j - 1) * around + (i + around) % around; };
  const auto last = static_cast<std::int64_t>(mesh.Points.size()) - 1;
  for (int i = 0; i < around; ++i)
  {
    mesh.Triangles.push_back({ 0, id(i + 1, 1), id(i, 1) });
    for (int j = 1; j + 1 < along; ++j)
    {
      const int s = j % 2;
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j), id(i + s, j + 1) });
      mesh.Triangles.push_back({ id(i + 1 - s, j), id(i + 1, j + 1), id(i, j + 1) });
    }
    mesh.Triangles.push_back({ id(i, along - 1), id(i + 1, along - 1), last });
  }
  return mesh;
}

/// Two balls of radius 1 joined by a neck of radius `neck` at the origin: the curve
/// r^2 = neck^2 + 1.69 z^2 - 0.9 z^4 ... closed smoothly, see the formula.
inline double DumbbellRadius(double z, double neck)
{
  const double end = 2.0;
  const double u = z / end;
  return std::sqrt(std::max(0.0, 1.0 - u * u)) *
    (neck + (1.0 - neck) * 4.0 * u * u * (1.0 - 0.25 * u * u) / 1.75);
}

/// Ring torus round z.
inline TriangleMesh Torus(double large, double small, int around, int across)
{
  TriangleMesh mesh;
  for (int i = 0; i < around; ++i)
  {
    for (int j = 0; j < across; ++j)
    {
      const double u = 2.0 * M_PI * i / around;
      const double v = 2.0 * M_PI * (j + 0.5 * (i % 2)) / across;
      mesh.Points.push_back({ (large + small * std::cos(v)) * std::cos(u),
        (large + small * std::cos(v)) * std::sin(u), small * std::sin(v) });
    }
  }
  const auto id = [=](int i, int j) -> std::int64_t
  { return (i + around) % around * across + (j + across) % across; };
  for (int i = 0; i < around; ++i)
  {
    const int s = i % 2;
    for (int j = 0; j < across; ++j)
    {
      mesh.Triangles.push_back({ id(i, j), id(i + 1, j + s), id(i, j + 1) });
      mesh.Triangles.push_back({ id(i, j + 1 - s), id(i + 1, j), id(i + 1, j + 1) });
    }
  }
  return mesh;
}

/// Numbers of selected features by side and kind.
template <typename Loops, typename Selection>
std::array<int, 4> CountFeatures(const Loops& loops, const Selection& selection)
{
  std::array<int, 4> counts{ 0, 0, 0, 0 }; // handles, tunnels, additional inside and outside
  for (const std::size_t i : loops.Select(selection))
  {
    const auto& f = loops.Diagram().Features[i];
    const auto kind = static_cast<std::size_t>(f.Kind);
    ++counts[kind < 2 ? kind : 2 + static_cast<std::size_t>(f.Side)];
  }
  return counts;
}

}

#endif
