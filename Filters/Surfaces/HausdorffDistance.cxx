#include "Surfaces/HausdorffDistance.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Surfaces/TriangleTree.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace isthmus
{
namespace
{

/// A face, its corners sorted, and where it comes from.
struct SortedFace
{
  Triangle Corners;
  Triangle Outward;

  bool operator<(const SortedFace& o) const { return this->Corners < o.Corners; }
};

/// Calls visit(SortedFace) for the faces of the tetrahedra of positive region.
template <typename Visit>
void ForEachFaceOfSolids(const TetrahedralMesh& mesh, Visit&& visit)
{
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const Tetrahedron& t = mesh.Tetrahedra[i];
    if (mesh.Regions[i] <= 0)
    {
      continue;
    }
    for (const Triangle& face : { Triangle{ t[0], t[2], t[1] }, Triangle{ t[0], t[1], t[3] },
           Triangle{ t[1], t[2], t[3] }, Triangle{ t[0], t[3], t[2] } })
    {
      Triangle sorted = face;
      std::sort(sorted.begin(), sorted.end());
      visit(SortedFace{ sorted, face });
    }
  }
}

struct Largest
{
  double Value = 0.0;
  Largest& operator+=(const Largest& o)
  {
    this->Value = std::max(this->Value, o.Value);
    return *this;
  }
};

/// Square of the largest distance of corners, middles of sides and middle of triangle `t` of
/// `from`.
double ComputeSquaredDistance(
  const Triangle& t, const SurfaceView& from, const TriangleTree& to, std::int64_t& guess)
{
  const auto at = [&](std::size_t c) { return from.Points[static_cast<std::size_t>(t[c])]; };
  double largest = 0.0;
  for (const Point3& p : { at(0), at(1), at(2), 0.5 * (at(0) + at(1)), 0.5 * (at(1) + at(2)),
         0.5 * (at(2) + at(0)), (1.0 / 3.0) * (at(0) + at(1) + at(2)) })
  {
    const auto nearest = to.Find(p, guess);
    guess = nearest.Guess;
    largest = std::max(largest, nearest.Squared);
  }
  return largest;
}

double LargestDistance(const SurfaceView& from, const TriangleTree& to)
{
  const Largest squared = ParallelReduce(static_cast<std::int64_t>(from.Triangles.size()), 1024,
    Largest{},
    [&](Largest& largest, std::int64_t first, std::int64_t last)
    {
      std::int64_t guess = -1;
      for (std::int64_t i = first; i < last; ++i)
      {
        largest +=
          { ComputeSquaredDistance(from.Triangles[static_cast<std::size_t>(i)], from, to, guess) };
      }
    });
  return std::sqrt(squared.Value);
}

}

TriangleMesh BoundarySurface(const TetrahedralMesh& mesh)
{
  // Bucketed by their first corner; each bucket is sorted in place.
  std::vector<std::size_t> first(mesh.Points.size() + 2, 0);
  ForEachFaceOfSolids(mesh, [&first](const SortedFace& face) { ++first[At(face.Corners[0]) + 2]; });
  std::partial_sum(first.begin(), first.end(), first.begin());
  std::vector<SortedFace> faces(first.back());
  ForEachFaceOfSolids(
    mesh, [&](const SortedFace& face) { faces[first[At(face.Corners[0]) + 1]++] = face; });
  TriangleMesh skin;
  skin.Points = mesh.Points;
  for (std::size_t p = 0; p < mesh.Points.size(); ++p)
  {
    const auto at = [&faces](std::size_t i)
    { return faces.begin() + static_cast<std::ptrdiff_t>(i); };
    std::sort(at(first[p]), at(first[p + 1]));
    for (std::size_t i = first[p]; i < first[p + 1]; ++i)
    {
      const bool sameAsNext = i + 1 < first[p + 1] && faces[i].Corners == faces[i + 1].Corners;
      if (sameAsNext)
      {
        ++i;
      }
      else
      {
        skin.Triangles.push_back(faces[i].Outward);
      }
    }
  }
  return skin;
}

std::vector<std::int64_t> TrianglesFartherThan(
  const SurfaceView& a, const SurfaceView& b, double distance)
{
  const auto count = static_cast<std::int64_t>(a.Triangles.size());
  std::vector<char> isFar(a.Triangles.size(), 1);
  if (!b.Triangles.empty())
  {
    const TriangleTree tree(b);
    ParallelFor(0, count, 1024,
      [&](std::int64_t first, std::int64_t last)
      {
        std::int64_t guess = -1;
        for (std::int64_t i = first; i < last; ++i)
        {
          const auto at = static_cast<std::size_t>(i);
          isFar[at] =
            ComputeSquaredDistance(a.Triangles[at], a, tree, guess) > distance * distance ? 1 : 0;
        }
      });
  }
  std::vector<std::int64_t> ids;
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (isFar[static_cast<std::size_t>(i)])
    {
      ids.push_back(i);
    }
  }
  return ids;
}

double OneSidedDistance(const SurfaceView& a, const SurfaceView& b)
{
  return a.Triangles.empty() || b.Triangles.empty() ? std::numeric_limits<double>::infinity()
                                                    : LargestDistance(a, TriangleTree(b));
}

double HausdorffDistance(const SurfaceView& a, const SurfaceView& b)
{
  return std::max(OneSidedDistance(a, b), OneSidedDistance(b, a));
}

}
