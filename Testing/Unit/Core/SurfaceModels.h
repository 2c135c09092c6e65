/**
 * @file SurfaceModels.h
 * @brief Surfaces with known geometry for the tests, and a reader for OFF files.
 */
#ifndef isthmus_SurfaceModels_h
#define isthmus_SurfaceModels_h

#include "Core/TriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

namespace isthmus::testing
{

using Vector = std::array<double, 3>;

/// A triangle surface to build.
struct Model : TriangleMesh
{
  SurfaceView View() const { return *this; }

  vtkIdType AddPoint(double x, double y, double z)
  {
    this->Points.push_back({ x, y, z });
    return static_cast<vtkIdType>(this->Points.size()) - 1;
  }
};

inline vtkSmartPointer<vtkPolyData> ToPolyData(const Model& model)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  for (const Vector& p : model.Points)
  {
    points->InsertNextPoint(p.data());
  }
  auto polygons = vtkSmartPointer<vtkCellArray>::New();
  for (const auto& triangle : model.Triangles)
  {
    polygons->InsertNextCell(3, triangle.data());
  }
  auto result = vtkSmartPointer<vtkPolyData>::New();
  result->SetPoints(points);
  result->SetPolys(polygons);
  return result;
}

/// Icosahedron with each edge divided into `frequency` parts, pushed out to the sphere about the
/// origin: 10 frequency^2 + 2 points, triangles counter-clockwise seen from outside.
inline Model Icosphere(int frequency, double radius)
{
  const double g = (1.0 + std::sqrt(5.0)) / 2.0;
  const double corners[12][3] = { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
    { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
    { -g, 0, -1 }, { -g, 0, 1 } };
  const int faces[20][3] = { { 0, 11, 5 }, { 0, 5, 1 }, { 0, 1, 7 }, { 0, 7, 10 }, { 0, 10, 11 },
    { 1, 5, 9 }, { 5, 11, 4 }, { 11, 10, 2 }, { 10, 7, 6 }, { 7, 1, 8 }, { 3, 9, 4 }, { 3, 4, 2 },
    { 3, 2, 6 }, { 3, 6, 8 }, { 3, 8, 9 }, { 4, 9, 5 }, { 2, 4, 11 }, { 6, 2, 10 }, { 8, 6, 7 },
    { 9, 8, 1 } };
  Model model;
  // Points on shared edges are found again by their (corner, weight) lists.
  std::map<std::vector<std::pair<int, int>>, vtkIdType> known;
  const auto point = [&](const int* face, int i, int j)
  {
    const int weights[3] = { frequency - i - j, i, j };
    std::vector<std::pair<int, int>> key;
    Vector p{ 0, 0, 0 };
    for (int c = 0; c < 3; ++c)
    {
      if (weights[c] > 0)
      {
        key.emplace_back(face[c], weights[c]);
      }
    }
    std::sort(key.begin(), key.end());
    for (const auto& [corner, weight] : key)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        p[a] += weight * corners[corner][a];
      }
    }
    const auto [entry, isNew] = known.emplace(key, 0);
    if (isNew)
    {
      const double scale = radius / std::hypot(p[0], p[1], p[2]);
      entry->second = model.AddPoint(scale * p[0], scale * p[1], scale * p[2]);
    }
    return entry->second;
  };
  for (const auto& face : faces)
  {
    for (int i = 0; i < frequency; ++i)
    {
      for (int j = 0; i + j < frequency; ++j)
      {
        model.Triangles.push_back(
          { point(face, i, j), point(face, i + 1, j), point(face, i, j + 1) });
        if (i + j + 1 < frequency)
        {
          model.Triangles.push_back(
            { point(face, i + 1, j), point(face, i + 1, j + 1), point(face, i, j + 1) });
        }
      }
    }
  }
  return model;
}

/// Sheet of (n + 1)^2 points `at(u, v)`, u and v in steps of 1/n from 0 to 1; each square is cut
/// along the same diagonal. The normal is on the side of at_u x at_v.
template <typename At>
Model Sheet(int n, At&& at)
{
  Model model;
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      model.Points.push_back(at(static_cast<double>(i) / n, static_cast<double>(j) / n));
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      const vtkIdType a = i + j * (n + 1);
      const vtkIdType b = a + n + 1;
      model.Triangles.push_back({ a, a + 1, b + 1 });
      model.Triangles.push_back({ a, b + 1, b });
    }
  }
  return model;
}

/// Torus about the z axis, `major` x `minor` points, outward.
inline Model Torus(int major, int minor, double ringRadius, double tubeRadius)
{
  Model model;
  const double turn = 8.0 * std::atan(1.0);
  for (int i = 0; i < major; ++i)
  {
    for (int j = 0; j < minor; ++j)
    {
      const double u = turn * i / major;
      const double v = turn * j / minor;
      const double r = ringRadius + tubeRadius * std::cos(v);
      model.AddPoint(r * std::cos(u), r * std::sin(u), tubeRadius * std::sin(v));
      const auto id = [&](int a, int b)
      { return static_cast<vtkIdType>((a % major) * minor + b % minor); };
      model.Triangles.push_back({ id(i, j), id(i + 1, j), id(i + 1, j + 1) });
      model.Triangles.push_back({ id(i, j), id(i + 1, j + 1), id(i, j + 1) });
    }
  }
  return model;
}

/// Appends `other`, moved by `shift`.
inline void Append(Model& model, const Model& other, const Vector& shift)
{
  const auto base = static_cast<vtkIdType>(model.Points.size());
  for (const Vector& p : other.Points)
  {
    model.AddPoint(p[0] + shift[0], p[1] + shift[1], p[2] + shift[2]);
  }
  for (const auto& t : other.Triangles)
  {
    model.Triangles.push_back({ t[0] + base, t[1] + base, t[2] + base });
  }
}

inline void TurnInsideOut(Model& model)
{
  for (auto& triangle : model.Triangles)
  {
    std::swap(triangle[1], triangle[2]);
  }
}

/// Triangles of an OFF file.
inline Model ReadOFF(const std::string& path)
{
  std::ifstream file(path);
  std::string magic;
  std::size_t points = 0, faces = 0, edges = 0;
  file >> magic >> points >> faces >> edges;
  if (magic != "OFF")
  {
    throw std::runtime_error(path + " is not an OFF file");
  }
  Model model;
  model.Points.resize(points);
  model.Triangles.resize(faces);
  for (Vector& p : model.Points)
  {
    file >> p[0] >> p[1] >> p[2];
  }
  for (auto& triangle : model.Triangles)
  {
    int corners = 0;
    file >> corners >> triangle[0] >> triangle[1] >> triangle[2];
    if (!file || corners != 3)
    {
      throw std::runtime_error(path + " is damaged or has polygons");
    }
  }
  return model;
}

}

#endif
