/**
 * @file LoopChecks.h
 * @brief Checks that reported loops have the claimed properties. Checked without the library's
 * homology.
 */
#ifndef isthmus_LoopChecks_h
#define isthmus_LoopChecks_h

#include "ChokingLoops/ChokingLoops.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace isthmus::testing
{

using Bits = std::vector<std::vector<int>>; ///< a matrix over Z/2

inline std::size_t RankOfBits(Bits rows)
{
  std::size_t rank = 0;
  for (std::size_t column = 0; !rows.empty() && column < rows[0].size(); ++column)
  {
    std::size_t pivot = rank;
    while (pivot < rows.size() && !rows[pivot][column])
    {
      ++pivot;
    }
    if (pivot == rows.size())
    {
      continue;
    }
    std::swap(rows[pivot], rows[rank]);
    for (std::size_t r = 0; r < rows.size(); ++r)
    {
      if (r != rank && rows[r][column])
      {
        for (std::size_t k = 0; k < rows[r].size(); ++k)
        {
          rows[r][k] ^= rows[rank][k];
        }
      }
    }
    ++rank;
  }
  return rank;
}

/// Loops are closed walks along edges of M, simple, and the boundary of their membrane.
inline void ExpectSound(ChokingLoops& loops, std::size_t feature)
{
  const Membrane& membrane = loops.GetMembrane(feature);
  ASSERT_FALSE(membrane.Loops.empty());
  std::map<std::pair<SimplexId, SimplexId>, int> boundary;
  const auto toggle = [&boundary](SimplexId a, SimplexId b) {
    boundary[{ std::min(a, b), std::max(a, b) }] ^= 1;
  };
  for (const auto& t : membrane.Triangles)
  {
    toggle(t[0], t[1]);
    toggle(t[1], t[2]);
    toggle(t[2], t[0]);
  }
  for (const auto& loop : membrane.Loops)
  {
    std::vector<SimplexId> sorted = loop;
    std::sort(sorted.begin(), sorted.end());
    EXPECT_EQ(std::unique(sorted.begin(), sorted.end()), sorted.end()) << "a point twice";
    ASSERT_GE(loop.size(), 3U);
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      EXPECT_TRUE(loops.Adjacency().Find(loop[i], loop[(i + 1) % loop.size()]).Exists());
      toggle(loop[i], loop[(i + 1) % loop.size()]);
    }
  }
  for (const auto& edge : boundary)
  {
    EXPECT_EQ(edge.second, 0) << "an edge of the membrane's boundary is not in the loop";
  }
}

/// Edges of M that a loop of points crosses when it is pushed to its left.
inline std::map<SurfaceEdgeId, int> CrossedOnTheLeft(
  const SurfaceAdjacency& surface, const std::vector<SimplexId>& loop)
{
  std::map<SurfaceEdgeId, int> crossed;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i)
  {
    const HalfEdgeId in = surface.Find(loop[(i + n - 1) % n], loop[i]);
    const HalfEdgeId out = surface.Find(loop[i], loop[(i + 1) % n]);
    for (HalfEdgeId h = surface.Next(in); h != out; h = surface.Next(surface.Opposite(h)))
    {
      crossed[surface.Edge(h)] ^= 1;
    }
  }
  return crossed;
}

/// Loops as polygons beside M: moved along the normals of their points by a small part of the
/// shortest edge there.
class PushedLoops
{
public:
  explicit PushedLoops(const SurfaceAdjacency& surface)
    : Points(surface.Mesh().Points)
    , Normals(surface.Mesh().Points.size(), Point3{ 0, 0, 0 })
  {
    std::vector<double> shortest(this->Points.size(), HUGE_VAL);
    double volume = 0.0;
    for (const Triangle& t : surface.Mesh().Triangles)
    {
      volume += Dot(this->At(t[0]), Cross(this->At(t[1]), this->At(t[2])));
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Point3 u = this->At(t[(k + 1) % 3]) - this->At(t[k]);
        const Point3 v = this->At(t[(k + 2) % 3]) - this->At(t[k]);
        const Point3 n = Cross(u, v);
        const double size = std::sqrt(Dot(n, n));
        const double angle = std::atan2(size, Dot(u, v));
        const auto p = static_cast<std::size_t>(t[k]);
        this->Normals[p] = this->Normals[p] + (angle / size) * n;
        shortest[p] = std::min(shortest[p], std::sqrt(std::min(Dot(u, u), Dot(v, v))));
      }
    }
    for (std::size_t p = 0; p < shortest.size(); ++p)
    {
      const double length = std::sqrt(Dot(this->Normals[p], this->Normals[p]));
      this->Normals[p] = (std::copysign(1e-3, volume) * shortest[p] / length) * this->Normals[p];
    }
  }

  /// `way` 1: outward, -1: inward.
  std::vector<Point3> Of(const std::vector<SimplexId>& loop, double way) const
  {
    std::vector<Point3> polygon;
    for (const SimplexId p : loop)
    {
      polygon.push_back(this->At(p) + way * this->Normals[static_cast<std::size_t>(p)]);
    }
    return polygon;
  }

private:
  const Point3& At(std::int64_t p) const { return this->Points[static_cast<std::size_t>(p)]; }

  View<Point3> Points;
  std::vector<Point3> Normals;
};

/// Linking number of two closed polygons: Gauss' integral, each pair of segments in closed form
/// (K. Klenin, J. Langowski, Biopolymers 54 (2000) 307, method 1a).
inline double LinkingNumber(const std::vector<Point3>& a, const std::vector<Point3>& b)
{
  const auto unit = [](const Point3& v)
  {
    const double length = std::sqrt(Dot(v, v));
    return length > 0.0 ? (1.0 / length) * v : Point3{ 0, 0, 0 };
  };
  const auto arc = [](const Point3& u, const Point3& v)
  { return std::asin(std::clamp(Dot(u, v), -1.0, 1.0)); };
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    const Point3& p = a[i];
    const Point3& q = a[(i + 1) % a.size()];
    for (std::size_t j = 0; j < b.size(); ++j)
    {
      const Point3& r = b[j];
      const Point3& s = b[(j + 1) % b.size()];
      const Point3 n1 = unit(Cross(r - p, s - p));
      const Point3 n2 = unit(Cross(s - p, s - q));
      const Point3 n3 = unit(Cross(s - q, r - q));
      const Point3 n4 = unit(Cross(r - q, r - p));
      const double area = arc(n1, n2) + arc(n2, n3) + arc(n3, n4) + arc(n4, n1);
      sum += std::copysign(area, Dot(Cross(s - r, q - p), r - p));
    }
  }
  return sum / (4.0 * M_PI);
}

/// True for polygons whose boxes are disjoint: a plane separates them, so they are not linked.
inline bool AreApart(const std::vector<Point3>& a, const std::vector<Point3>& b)
{
  Bounds3 boxA{ a.front(), a.front() };
  Bounds3 boxB{ b.front(), b.front() };
  std::for_each(a.begin(), a.end(), [&boxA](const Point3& p) { boxA.Add(p); });
  std::for_each(b.begin(), b.end(), [&boxB](const Point3& p) { boxB.Add(p); });
  bool apart = false;
  for (std::size_t k = 0; k < 3; ++k)
  {
    apart = apart || boxA.Max[k] < boxB.Min[k] || boxB.Max[k] < boxA.Min[k];
  }
  return apart;
}

/// Linking number mod 2 of two families of loops; -1 if the integral is not an integer.
inline int LinkingParity(
  const std::vector<std::vector<Point3>>& a, const std::vector<std::vector<Point3>>& b)
{
  double sum = 0.0;
  for (const auto& loop : a)
  {
    for (const auto& other : b)
    {
      sum += AreApart(loop, other) ? 0.0 : LinkingNumber(loop, other);
    }
  }
  const double whole = std::round(sum);
  return std::abs(sum - whole) < 0.01 ? static_cast<int>(std::abs(whole)) % 2 : -1;
}

/// Handles, then tunnels: indices of features.
inline std::array<std::vector<std::size_t>, 2> Generators(const ChokingLoops& loops)
{
  std::array<std::vector<std::size_t>, 2> found;
  for (std::size_t i = 0; i < loops.Diagram().Features.size(); ++i)
  {
    const auto kind = static_cast<std::size_t>(loops.Diagram().Features[i].Kind);
    if (kind < 2)
    {
      found[kind].push_back(i);
    }
  }
  return found;
}

/// Intersection numbers on M of the loops of features, mod 2: one loop is pushed to its left and
/// crosses the other along its edges.
inline Bits Intersections(ChokingLoops& loops, const std::vector<std::size_t>& rows,
  const std::vector<std::size_t>& columns)
{
  Bits numbers;
  for (const std::size_t r : rows)
  {
    std::map<SurfaceEdgeId, int> left;
    for (const auto& loop : loops.GetMembrane(r).Loops)
    {
      for (const auto& [edge, odd] : CrossedOnTheLeft(loops.Adjacency(), loop))
      {
        left[edge] ^= odd;
      }
    }
    numbers.emplace_back();
    for (const std::size_t c : columns)
    {
      int number = 0;
      for (const auto& loop : loops.GetMembrane(c).Loops)
      {
        for (const SurfaceEdgeId e : LoopEdges(loops.Adjacency(), loop))
        {
          const auto crossed = left.find(e);
          number ^= crossed == left.end() ? 0 : crossed->second;
        }
      }
      numbers.back().push_back(number);
    }
  }
  return numbers;
}

/**
 * `genus` handles that are independent in H1(M) and bound inside, as many tunnels that bound
 * outside.
 *
 * On M, intersection numbers of handles with tunnels have full rank: so each kind is independent.
 * In space, a class c of M bounds inside if and only if c pushed inward links no loop of M pushed
 * outward (Alexander duality), and bounds outside if and only if, pushed outward, it is not linked
 * by any pushed inward. Handles and tunnels together generate H1(M) once they are independent, so
 * testing these loops suffices.
 */
inline void ExpectGenerators(ChokingLoops& loops, std::size_t genus)
{
  const auto [handles, tunnels] = Generators(loops);
  ASSERT_EQ(handles.size(), genus);
  ASSERT_EQ(tunnels.size(), genus);
  EXPECT_EQ(RankOfBits(Intersections(loops, handles, tunnels)), genus);
  const PushedLoops pushed(loops.Adjacency());
  std::vector<std::size_t> all = handles;
  all.insert(all.end(), tunnels.begin(), tunnels.end());
  std::vector<std::vector<std::vector<Point3>>> inward;
  std::vector<std::vector<std::vector<Point3>>> outward;
  for (const std::size_t i : all)
  {
    inward.emplace_back();
    outward.emplace_back();
    for (const auto& loop : loops.GetMembrane(i).Loops)
    {
      inward.back().push_back(pushed.Of(loop, -1.0));
      outward.back().push_back(pushed.Of(loop, 1.0));
    }
  }
  Bits seifert; // tunnels pushed inward, handles outward
  for (std::size_t i = 0; i < all.size(); ++i)
  {
    std::vector<int> row;
    for (std::size_t j = 0; j < all.size(); ++j)
    {
      const int linked = LinkingParity(inward[i], outward[j]);
      if (i < genus || j >= genus)
      {
        EXPECT_EQ(linked, 0) << (i < genus ? "handle " : "tunnel ") << all[i] << " pushed inward, "
                             << (j < genus ? "handle " : "tunnel ") << all[j] << " outward";
      }
      else
      {
        row.push_back(linked);
      }
    }
    if (i >= genus)
    {
      seifert.push_back(row);
    }
  }
  EXPECT_EQ(RankOfBits(seifert), genus);
}

}

#endif
