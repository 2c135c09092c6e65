/**
 * @file CGALPeer.h
 * @brief The same mesh in CGAL's linear cell complex, for comparison.
 */
#ifndef isthmus_CGALPeer_h
#define isthmus_CGALPeer_h

#include "GeneratedMeshes.h"

#include <CGAL/Linear_cell_complex_for_combinatorial_map.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <type_traits>
#include <unordered_map>
#include <vector>

namespace isthmus::peers
{

/// Points at the vertices and nothing else: CGAL's smallest map of a mesh.
struct CGALPlainItems
{
  template <typename Refs>
  struct Dart_wrapper
  {
    using Attributes = std::tuple<CGAL::Cell_attribute_with_point<Refs>>;
  };
};

/// The same with numbered edges and cells, as the queries need.
struct CGALNumberedItems
{
  template <typename Refs>
  struct Dart_wrapper
  {
    using Numbered = CGAL::Cell_attribute<Refs, std::uint32_t>;
    using Attributes = std::tuple<CGAL::Cell_attribute_with_point<Refs>, Numbered, void, Numbered>;
  };
};

using CGALTraits = CGAL::Linear_cell_complex_traits<3, CGAL::Simple_cartesian<double>>;

/// The half face that waits for the cell beyond it, found by its vertices.
struct FaceHash
{
  std::size_t operator()(const std::array<std::int64_t, 3>& face) const
  {
    std::size_t hash = 0;
    for (const std::int64_t vertex : face)
    {
      hash = (hash ^ static_cast<std::size_t>(vertex)) * 0x9E3779B97F4A7C15u;
    }
    return hash ^ (hash >> 32);
  }
};

template <typename Items>
class CGALTetrahedra
{
public:
  using CGALMap = CGAL::Linear_cell_complex_for_combinatorial_map<3, 3, CGALTraits, Items>;
  using CGALDart = typename CGALMap::Dart_handle;
  static constexpr bool IsNumbered = std::is_same_v<Items, CGALNumberedItems>;

  explicit CGALTetrahedra(const testing::GeneratedMesh& mesh)
  {
    // Links are set directly, which is many times faster than make_tetrahedron and sew.
    this->Map.set_automatic_attributes_management(false);
    this->Vertices.reserve(mesh.Points.size());
    for (const auto& p : mesh.Points)
    {
      this->Vertices.push_back(
        this->Map.create_vertex_attribute(CGALTraits::Point(p[0], p[1], p[2])));
    }
    WaitingFaces waiting;
    for (std::size_t c = 0; 4 * c < mesh.CellVertices.size(); ++c)
    {
      this->AddTetrahedron(
        mesh.CellVertices.data() + 4 * c, static_cast<std::uint32_t>(c), waiting);
    }
    if constexpr (IsNumbered)
    {
      this->NumberEdges();
    }
  }

  CGALMap Map;
  std::vector<typename CGALMap::Vertex_attribute_handle> Vertices;
  std::vector<CGALDart> EdgeDarts;

private:
  using WaitingFaces = std::unordered_map<std::array<std::int64_t, 3>, CGALDart, FaceHash>;

  void AddTetrahedron(const std::int64_t* vertices, std::uint32_t cell, WaitingFaces& waiting)
  {
    const CellType& type = CellType::Tetrahedron();
    std::array<CGALDart, 13> darts;
    for (unsigned d = 1; d <= 12; ++d)
    {
      darts[d] =
        this->Map.create_dart(this->Vertices[static_cast<std::size_t>(vertices[type.At(d).Start])]);
    }
    if constexpr (IsNumbered)
    {
      const auto volume = this->Map.template create_attribute<3>(cell);
      for (unsigned d = 1; d <= 12; ++d)
      {
        this->Map.template set_dart_attribute<3>(darts[d], volume);
      }
    }
    for (unsigned d = 1; d <= 12; ++d)
    {
      this->Map.basic_link_beta_1(darts[d], darts[type.At(d).Next]);
      if (d % 2)
      {
        this->Map.template basic_link_beta_for_involution<2>(darts[d], darts[d + 1]);
      }
    }
    for (unsigned f = 0; f < 4; ++f)
    {
      std::array<std::int64_t, 3> key;
      for (unsigned i = 0; i < 3; ++i)
      {
        key[i] = vertices[type.At(type.FaceDart(f, i)).Start];
      }
      const auto smallest = std::min_element(key.begin(), key.end()) - key.begin();
      CGALDart dart = darts[type.FaceDart(f, static_cast<unsigned>(smallest))];
      std::sort(key.begin(), key.end());
      const auto found = waiting.find(key);
      if (found == waiting.end())
      {
        waiting.emplace(key, dart);
        continue;
      }
      // Both begin at the smallest vertex, and run in opposite directions.
      CGALDart other = this->Map.template beta<0>(found->second);
      for (unsigned i = 0; i < 3; ++i)
      {
        this->Map.template basic_link_beta_for_involution<3>(dart, other);
        dart = this->Map.template beta<1>(dart);
        other = this->Map.template beta<0>(other);
      }
      waiting.erase(found);
    }
  }

  void NumberEdges()
  {
    for (auto dart = this->Map.darts().begin(); dart != this->Map.darts().end(); ++dart)
    {
      if (this->Map.template attribute<1>(dart) == nullptr)
      {
        const auto edge = this->Map.template create_attribute<1>(
          static_cast<std::uint32_t>(this->EdgeDarts.size()));
        for (auto at = this->Map.template darts_of_cell<1>(dart).begin(); at.cont(); ++at)
        {
          this->Map.template set_dart_attribute<1>(at, edge);
        }
        this->EdgeDarts.push_back(dart);
      }
    }
  }
};

}

#endif
