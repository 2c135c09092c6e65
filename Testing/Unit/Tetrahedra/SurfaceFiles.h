/**
 * @file SurfaceFiles.h
 * @brief Surfaces for the tests: those of the shared data, and generated ones.
 */
#ifndef isthmus_SurfaceFiles_h
#define isthmus_SurfaceFiles_h

#include "Core/TriangleMesh.h"

#include <vtkCellArray.h>
#include <vtkCleanPolyData.h>
#include <vtkNew.h>
#include <vtkOBJReader.h>
#include <vtkPLYReader.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cctype>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <string>

namespace isthmus::testing
{

/// OFF, COFF and NOFF files; colours and normals are left out. (VTK 9.2 reads none of them.)
inline vtkSmartPointer<vtkPolyData> ReadOFF(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::stringstream words;
  for (std::string line; std::getline(file, line); words << '\n')
  {
    words << line.substr(0, line.find('#'));
  }
  std::string magic;
  vtkIdType points = 0, faces = 0, edges = 0;
  words >> magic >> points >> faces >> edges;
  if (!words || magic.find("OFF") == std::string::npos)
  {
    throw std::runtime_error("not an OFF file: " + path.string());
  }
  const auto nextLine = [&words]
  {
    std::string line;
    while (std::getline(words, line) && line.find_first_not_of(" \t\r") == std::string::npos)
    {
    }
    return std::stringstream(line);
  };
  vtkNew<vtkPoints> coordinates;
  coordinates->SetDataTypeToDouble();
  for (vtkIdType i = 0; i < points; ++i)
  {
    double p[3];
    nextLine() >> p[0] >> p[1] >> p[2];
    coordinates->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> polygons;
  for (vtkIdType i = 0; i < faces; ++i)
  {
    std::stringstream line = nextLine();
    vtkIdType corners = 0;
    line >> corners;
    polygons->InsertNextCell(static_cast<int>(corners));
    for (vtkIdType c = 0, id = 0; c < corners && line >> id; ++c)
    {
      polygons->InsertCellPoint(id);
    }
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(coordinates);
  surface->SetPolys(polygons);
  return surface;
}

/// The one .vtu of the shared data (casting_ttk.vtu), whose raw blocks VTK's own reader refuses:
/// float points and 64 bit triangles at the offsets given in its header.
inline vtkSmartPointer<vtkPolyData> ReadTTKSurface(const std::filesystem::path& path)
{
  std::ifstream file(path, std::ios::binary);
  std::stringstream text;
  text << file.rdbuf();
  const std::string bytes = text.str();
  const std::size_t raw = bytes.find('_', bytes.find("<AppendedData")) + 1;
  const auto block = [&](const std::string& name)
  {
    const std::size_t at = bytes.find("offset=\"", bytes.find("Name=\"" + name + "\"")) + 8;
    return bytes.data() + raw + std::stoul(bytes.substr(at, 20));
  };
  const auto read = [](const char* from, auto& value) { std::memcpy(&value, from, sizeof value); };
  std::uint64_t size = 0;
  vtkNew<vtkPoints> coordinates;
  read(block("Points"), size);
  for (std::uint64_t i = 0; i < size / 12; ++i)
  {
    float p[3];
    read(block("Points") + 8 + 12 * i, p);
    coordinates->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> triangles;
  read(block("connectivity"), size);
  for (std::uint64_t i = 0; i < size / 24; ++i)
  {
    std::int64_t ids[3];
    read(block("connectivity") + 8 + 24 * i, ids);
    triangles->InsertNextCell({ ids[0], ids[1], ids[2] });
  }
  auto surface = vtkSmartPointer<vtkPolyData>::New();
  surface->SetPoints(coordinates);
  surface->SetPolys(triangles);
  return surface;
}

template <typename Reader>
vtkSmartPointer<vtkPolyData> ReadWith(const std::filesystem::path& path)
{
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  return reader->GetOutput();
}

/// Points and polygons of a surface file, by its extension; OBJ points used by several texture
/// corners, and STL points, are merged where they coincide exactly.
inline vtkSmartPointer<vtkPolyData> ReadSurface(const std::filesystem::path& path)
{
  std::string kind = path.extension().string();
  std::transform(kind.begin(), kind.end(), kind.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (kind == ".off")
  {
    return ReadOFF(path);
  }
  vtkSmartPointer<vtkPolyData> surface;
  if (kind == ".vtu")
  {
    return ReadTTKSurface(path);
  }
  surface = kind == ".obj" ? ReadWith<vtkOBJReader>(path)
    : kind == ".stl"       ? ReadWith<vtkSTLReader>(path)
                           : ReadWith<vtkPLYReader>(path);
  vtkNew<vtkPolyData> bare;
  bare->SetPoints(surface->GetPoints());
  bare->SetPolys(surface->GetPolys());
  vtkNew<vtkCleanPolyData> clean;
  clean->SetInputData(bare);
  clean->SetTolerance(0.0);
  clean->ConvertLinesToPointsOff();
  clean->ConvertPolysToLinesOff();
  clean->Update();
  return clean->GetOutput();
}

/// Axis-aligned cube as 12 triangles facing outward.
inline TriangleMesh Cube(const Point3& low, double side)
{
  TriangleMesh mesh;
  for (int corner = 0; corner < 8; ++corner)
  {
    mesh.Points.push_back({ low[0] + (corner & 1 ? side : 0.0), low[1] + (corner & 2 ? side : 0.0),
      low[2] + (corner & 4 ? side : 0.0) });
  }
  mesh.Triangles = { { 0, 2, 3 }, { 0, 3, 1 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 6, 7 }, { 2, 7, 3 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return mesh;
}

/// Appends `other` to `mesh`.
inline void Append(TriangleMesh& mesh, const TriangleMesh& other)
{
  const auto first = static_cast<std::int64_t>(mesh.Points.size());
  mesh.Points.insert(mesh.Points.end(), other.Points.begin(), other.Points.end());
  for (const Triangle& t : other.Triangles)
  {
    mesh.Triangles.push_back({ first + t[0], first + t[1], first + t[2] });
  }
}

}

#endif
