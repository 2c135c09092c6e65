/**
 * @file BlockMeshes.h
 * @brief Tetrahedral meshes of cubes, and the persistence of functions on them by plain reduction.
 */
#ifndef isthmus_BlockMeshes_h
#define isthmus_BlockMeshes_h

#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <tuple>

namespace isthmus::testing
{

/// A box of cubes, each cut into six tetrahedra along its diagonal, some cubes solid.
struct Blocks
{
  std::array<std::int64_t, 3> Size;
  std::function<bool(std::int64_t, std::int64_t, std::int64_t)> Solid;
  TetrahedralMesh Mesh;
  TriangleMesh Surface;

  std::int64_t Point(const std::array<std::int64_t, 3>& p) const
  {
    return p[0] + (this->Size[0] + 1) * (p[1] + (this->Size[1] + 1) * p[2]);
  }

  Blocks(std::array<std::int64_t, 3> size, decltype(Solid) solid, bool withOutside)
    : Size(size)
    , Solid(std::move(solid))
  {
    for (std::int64_t k = 0; k <= size[2]; ++k)
    {
      for (std::int64_t j = 0; j <= size[1]; ++j)
      {
        for (std::int64_t i = 0; i <= size[0]; ++i)
        {
          this->Mesh.Points.push_back(
            { static_cast<double>(i), static_cast<double>(j), static_cast<double>(k) });
        }
      }
    }
    std::map<std::set<std::int64_t>, Triangle> open; // faces of solid tetrahedra seen once
    std::set<std::set<std::int64_t>> empty;          // faces of the others
    for (std::int64_t k = 0; k < size[2]; ++k)
    {
      for (std::int64_t j = 0; j < size[1]; ++j)
      {
        for (std::int64_t i = 0; i < size[0]; ++i)
        {
          this->AddCube({ i, j, k }, withOutside, open, empty);
        }
      }
    }
    for (const auto& [face, triangle] : open)
    {
      if (empty.count(face) > 0)
      {
        this->Surface.Triangles.push_back(triangle);
      }
    }
    this->Surface.Points = this->Mesh.Points;
    this->DropUnused();
  }

private:
  void AddCube(const std::array<std::int64_t, 3>& at, bool withOutside,
    std::map<std::set<std::int64_t>, Triangle>& open, std::set<std::set<std::int64_t>>& empty)
  {
    const bool solid = this->Solid(at[0], at[1], at[2]);
    std::array<std::size_t, 3> axes{ 0, 1, 2 };
    do
    {
      Tetrahedron t;
      std::array<std::int64_t, 3> p = at;
      t[0] = this->Point(p);
      for (std::size_t a = 0; a < 3; ++a)
      {
        ++p[axes[a]];
        t[a + 1] = this->Point(p);
      }
      const auto& x = this->Mesh.Points;
      const auto point = [&](std::int64_t id) { return x[static_cast<std::size_t>(id)]; };
      if (Dot(Cross(point(t[1]) - point(t[0]), point(t[2]) - point(t[0])),
            point(t[3]) - point(t[0])) < 0.0)
      {
        std::swap(t[2], t[3]);
      }
      if (solid || withOutside)
      {
        this->Mesh.Tetrahedra.push_back(t);
      }
      const std::array<Triangle, 4> outward{ { { t[0], t[2], t[1] }, { t[0], t[1], t[3] },
        { t[0], t[3], t[2] }, { t[1], t[2], t[3] } } };
      for (const Triangle& face : outward)
      {
        const std::set<std::int64_t> key(face.begin(), face.end());
        if (solid)
        {
          open.emplace(key, face);
        }
        else
        {
          empty.insert(key);
        }
      }
    } while (std::next_permutation(axes.begin(), axes.end()));
  }

  /// The mesh of the solid alone does not use the points of the rest.
  void DropUnused()
  {
    std::map<std::int64_t, std::int64_t> kept;
    std::vector<Point3> points;
    for (Tetrahedron& t : this->Mesh.Tetrahedra)
    {
      for (vtkIdType& p : t)
      {
        const auto made = kept.emplace(p, static_cast<std::int64_t>(points.size()));
        if (made.second)
        {
          points.push_back(this->Mesh.Points[static_cast<std::size_t>(p)]);
        }
        p = made.first->second;
      }
    }
    this->Mesh.Points = points;
  }
};

/// A pair as (dimension, birth, death); handles and tunnels are born with the surface, at 0.
using Pair = std::tuple<int, double, double>;

/// Reduces the boundary matrix of the whole complex, column by column, without optimizations.
inline std::multiset<Pair> PairsByReduction(const Blocks& blocks, const std::vector<double>& values)
{
  using Simplex = std::vector<std::int64_t>;
  std::map<Point3, std::int64_t> ids;
  for (std::size_t i = 0; i < blocks.Mesh.Points.size(); ++i)
  {
    ids[blocks.Mesh.Points[i]] = static_cast<std::int64_t>(i);
  }
  std::set<Simplex> all;
  std::set<Simplex> surface;
  const auto addFaces = [](const Simplex& corners, std::set<Simplex>& to)
  {
    for (unsigned bits = 1; bits < (1U << corners.size()); ++bits)
    {
      Simplex face;
      for (std::size_t k = 0; k < corners.size(); ++k)
      {
        if (bits >> k & 1U)
        {
          face.push_back(corners[k]);
        }
      }
      to.insert(face);
    }
  };
  for (const Tetrahedron& t : blocks.Mesh.Tetrahedra)
  {
    Simplex corners(t.begin(), t.end());
    std::sort(corners.begin(), corners.end());
    addFaces(corners, all);
  }
  for (const Triangle& t : blocks.Surface.Triangles)
  {
    Simplex corners;
    for (const std::int64_t p : t)
    {
      corners.push_back(ids.at(blocks.Surface.Points[static_cast<std::size_t>(p)]));
    }
    std::sort(corners.begin(), corners.end());
    addFaces(corners, surface);
  }
  const auto value = [&values](const Simplex& s)
  {
    double latest = 0.0;
    for (const std::int64_t p : s)
    {
      latest = std::max(latest, values[static_cast<std::size_t>(p)]);
    }
    return latest;
  };
  std::vector<Simplex> order(all.begin(), all.end());
  std::stable_sort(order.begin(), order.end(),
    [&](const Simplex& a, const Simplex& b)
    {
      const auto key = [&](const Simplex& s)
      { return std::make_tuple(surface.count(s) == 0, value(s), s.size()); };
      return key(a) < key(b);
    });
  std::map<Simplex, std::size_t> position;
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    position[order[i]] = i;
  }
  std::map<std::size_t, std::set<std::size_t>> columns; // by their lowest entry
  std::multiset<Pair> pairs;
  for (const Simplex& s : order)
  {
    std::set<std::size_t> column;
    for (std::size_t k = 0; s.size() > 1 && k < s.size(); ++k)
    {
      Simplex face = s;
      face.erase(face.begin() + static_cast<std::ptrdiff_t>(k));
      column.insert(position.at(face));
    }
    for (auto other = columns.end();
         !column.empty() && (other = columns.find(*column.rbegin())) != columns.end();)
    {
      for (const std::size_t entry : other->second)
      {
        if (!column.erase(entry))
        {
          column.insert(entry);
        }
      }
    }
    if (column.empty())
    {
      continue;
    }
    const Simplex& born = order[*column.rbegin()];
    const int dimension = static_cast<int>(born.size()) - 1;
    const bool generator = dimension == 1 && surface.count(born) > 0 && surface.count(s) == 0;
    if (dimension > 0 && (generator || value(s) > value(born)))
    {
      pairs.emplace(dimension, generator ? 0.0 : value(born), value(s));
    }
    columns.emplace(*column.rbegin(), std::move(column));
  }
  return pairs;
}

}

#endif
