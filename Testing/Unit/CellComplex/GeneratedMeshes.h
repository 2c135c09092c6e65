/**
 * @file GeneratedMeshes.h
 * @brief Volume meshes of each cell type, made on a grid of unit cubes.
 */
#ifndef isthmus_GeneratedMeshes_h
#define isthmus_GeneratedMeshes_h

#include "CellComplex/CellType.h"

#include <array>
#include <cstdint>
#include <initializer_list>
#include <vector>

namespace isthmus::testing
{

/// A mesh that owns its lists.
struct GeneratedMesh
{
  std::vector<CellType> Types;
  std::vector<CellRun> Runs;
  std::vector<std::int64_t> CellVertices;
  std::vector<std::array<double, 3>> Points;

  CellList List() const
  {
    return { static_cast<std::int64_t>(this->Points.size()), this->Types, this->Runs,
      { this->CellVertices.data(), this->CellVertices.size() } };
  }

  void Add(std::size_t type, std::initializer_list<std::int64_t> vertices)
  {
    if (this->Runs.empty() || this->Runs.back().Type != type)
    {
      this->Runs.push_back({ type, 0 });
    }
    ++this->Runs.back().NumberOfCells;
    this->CellVertices.insert(this->CellVertices.end(), vertices);
  }
};

/// Places of the built-in types in GeneratedMesh::Types.
enum BuiltIn : std::size_t
{
  Tetrahedron,
  Prism,
  Pyramid,
  Hexahedron
};

inline GeneratedMesh EmptyMesh()
{
  GeneratedMesh mesh;
  mesh.Types = { CellType::Tetrahedron(), CellType::Prism(), CellType::Pyramid(),
    CellType::Hexahedron() };
  return mesh;
}

/// The eight corners of a cube, numbered as a hexahedron's.
using Cube = std::array<std::int64_t, 8>;

/// Adds the corners of n^3 cubes, then calls `fill(mesh, cube, i, j, k)` for each cube.
template <typename Fill>
GeneratedMesh OnCubes(std::int64_t n, Fill&& fill)
{
  GeneratedMesh mesh = EmptyMesh();
  const std::int64_t m = n + 1;
  mesh.Points.reserve(static_cast<std::size_t>(m * m * m));
  for (std::int64_t k = 0; k < m; ++k)
  {
    for (std::int64_t j = 0; j < m; ++j)
    {
      for (std::int64_t i = 0; i < m; ++i)
      {
        mesh.Points.push_back(
          { static_cast<double>(i), static_cast<double>(j), static_cast<double>(k) });
      }
    }
  }
  for (std::int64_t k = 0; k < n; ++k)
  {
    for (std::int64_t j = 0; j < n; ++j)
    {
      for (std::int64_t i = 0; i < n; ++i)
      {
        const std::int64_t v = i + m * (j + m * k), up = m * m;
        fill(mesh,
          Cube{ v, v + 1, v + 1 + m, v + m, v + up, v + up + 1, v + up + 1 + m, v + up + m }, i, j,
          k);
      }
    }
  }
  return mesh;
}

inline void AddHexahedron(GeneratedMesh& mesh, const Cube& c)
{
  mesh.Add(Hexahedron, { c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7] });
}

/// Two prisms with axes along z, split along the diagonal from corner 0 to corner 2.
inline void AddPrisms(GeneratedMesh& mesh, const Cube& c)
{
  mesh.Add(Prism, { c[0], c[1], c[2], c[4], c[5], c[6] });
  mesh.Add(Prism, { c[0], c[2], c[3], c[4], c[6], c[7] });
}

/// Six pyramids around a new vertex in the middle.
inline void AddPyramids(GeneratedMesh& mesh, const Cube& c)
{
  const auto apex = static_cast<std::int64_t>(mesh.Points.size());
  const auto& low = mesh.Points[static_cast<std::size_t>(c[0])];
  mesh.Points.push_back({ low[0] + 0.5, low[1] + 0.5, low[2] + 0.5 });
  for (const std::vector<int>& face : CellType::Hexahedron().Faces())
  {
    const auto at = [&](std::size_t i) { return c[static_cast<std::size_t>(face[i])]; };
    mesh.Add(Pyramid, { at(0), at(3), at(2), at(1), apex });
  }
}

/// Six tetrahedra around the diagonal from corner 0 to corner 6; neighbouring cubes fit.
inline void AddTetrahedra(GeneratedMesh& mesh, const Cube& c)
{
  constexpr std::size_t ring[7] = { 1, 2, 3, 7, 4, 5, 1 };
  for (std::size_t i = 0; i < 6; ++i)
  {
    mesh.Add(Tetrahedron, { c[0], c[ring[i]], c[ring[i + 1]], c[6] });
  }
}

inline GeneratedMesh Tetrahedra(std::int64_t n)
{
  return OnCubes(n, [](GeneratedMesh& mesh, const Cube& c, auto...) { AddTetrahedra(mesh, c); });
}

inline GeneratedMesh Prisms(std::int64_t n)
{
  return OnCubes(n, [](GeneratedMesh& mesh, const Cube& c, auto...) { AddPrisms(mesh, c); });
}

inline GeneratedMesh Pyramids(std::int64_t n)
{
  return OnCubes(n, [](GeneratedMesh& mesh, const Cube& c, auto...) { AddPyramids(mesh, c); });
}

inline GeneratedMesh Hexahedra(std::int64_t n)
{
  return OnCubes(n, [](GeneratedMesh& mesh, const Cube& c, auto...) { AddHexahedron(mesh, c); });
}

/// Columns of prisms with a roof of tetrahedra, between columns of hexahedra and pyramids.
inline GeneratedMesh MixedCells(std::int64_t n)
{
  return OnCubes(n,
    [n](GeneratedMesh& mesh, const Cube& c, std::int64_t i, std::int64_t j, std::int64_t k)
    {
      if ((i + j) % 3 == 0)
      {
        AddPrisms(mesh, c);
        if (k == n - 1)
        {
          const auto apex = static_cast<std::int64_t>(mesh.Points.size());
          mesh.Points.push_back({ static_cast<double>(i) + 0.6, static_cast<double>(j) + 0.3,
            static_cast<double>(n) + 1.0 });
          mesh.Add(Tetrahedron, { c[4], c[5], c[6], apex });
        }
      }
      else if ((i + j + k) % 2)
      {
        AddHexahedron(mesh, c);
      }
      else
      {
        AddPyramids(mesh, c);
      }
    });
}

/// The three cells of the thesis' Figure 3.1: two tetrahedra on the ends of a prism.
inline GeneratedMesh ThreeCells()
{
  GeneratedMesh mesh = EmptyMesh();
  mesh.Types.resize(2, CellType::Tetrahedron());
  mesh.Points = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 }, { 1, 0, 1 }, { 0, 1, 1 },
    { 0.3, 0.3, -1 }, { 0.3, 0.3, 2 } };
  mesh.Add(Tetrahedron, { 1, 0, 2, 6 });
  mesh.Add(Tetrahedron, { 3, 4, 5, 7 });
  mesh.Add(Prism, { 0, 1, 2, 3, 4, 5 });
  return mesh;
}

}

#endif
