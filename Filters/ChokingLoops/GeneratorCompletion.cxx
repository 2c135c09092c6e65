#include "ChokingLoops/GeneratorCompletion.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/TetrahedralMesh.h"
#include "Persistence/LowerStarFiltration.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <functional>
#include <numeric>
#include <unordered_map>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// ConformingGenerators
namespace
{

/// TetGen needs seconds if it succeeds; on meshes of needles it may never end.
constexpr double MostSeconds = 120.0;

/// Square of the radius of the smallest ball around three points.
double SquaredBall(const Point3& p, const Point3& q, const Point3& r)
{
  const std::array<double, 3> s{ Dot(q - p, q - p), Dot(r - q, r - q), Dot(p - r, p - r) };
  const double longest = *std::max_element(s.begin(), s.end());
  if (2.0 * longest >= s[0] + s[1] + s[2])
  {
    return 0.25 * longest; // not an acute triangle: half the longest side
  }
  const Point3 towards = Circumcenter(p, q, r) - p;
  return Dot(towards, towards);
}

Point3 BallCenter(const Point3& p, const Point3& q, const Point3& r)
{
  const std::array<double, 3> s{ Dot(q - p, q - p), Dot(r - q, r - q), Dot(p - r, p - r) };
  const auto longest = std::max_element(s.begin(), s.end());
  if (2.0 * *longest < s[0] + s[1] + s[2])
  {
    return Circumcenter(p, q, r);
  }
  return 0.5 * (longest == s.begin() ? p + q : longest == s.begin() + 1 ? q + r : p + r);
}

/// The squared ball of a triangle whose points ascend: rounding depends on their order.
double SquaredBall(const CellFiltration& f, const std::array<SimplexId, 3>& p)
{
  return SquaredBall(f.Points[At(p[0])], f.Points[At(p[1])], f.Points[At(p[2])]);
}

/// Calls work(id) for the ids below `count`, in parallel.
template <typename Id, typename Work>
void ForEach(std::size_t count, const Work& work)
{
  ParallelFor(0, static_cast<std::int64_t>(count), 1 << 14,
    [&work](std::int64_t begin, std::int64_t end)
    {
      for (const Id id : HandleRange<Id>(begin, end))
      {
        work(id);
      }
    });
}

/// The complex grows with the balls around its simplices; `surface` gets the ids of its points.
/// Only tetrahedra keep their values, since those of faces take as long to read as to compute.
CellFiltration FiltrationByBalls(TetrahedralMesh&& mesh, TriangleMesh& surface)
{
  CellFiltration f = ComplexAround(std::move(mesh), surface);
  f.TetrahedronValue.resize(f.Tetrahedra.size());
  ForEach<TetrahedronId>(f.Tetrahedra.size(),
    [&f](TetrahedronId cell)
    {
      auto p = f.Tetrahedra[cell];
      std::sort(p.begin(), p.end());
      f.TetrahedronValue[cell] =
        std::max({ SquaredBall(f, { p[1], p[2], p[3] }), SquaredBall(f, { p[0], p[2], p[3] }),
          SquaredBall(f, { p[0], p[1], p[3] }), SquaredBall(f, { p[0], p[1], p[2] }) });
    });
  f.TriangleValue.resize(f.TriangleCount());
  ForEach<TriangleId>(f.TriangleCount(),
    [&f](TriangleId t) { f.TriangleValue[t] = SquaredBall(f, f.TrianglePoints(t)); });
  f.TrianglesInOrder = SimplexOrder(f.TriangleValue, f.TriangleFirst, f.RankOfTriangle);
  HandleVector<TriangleId, double>().swap(f.TriangleValue);
  HandleVector<EdgeId, double> edgeValue(f.Edges.size());
  ForEach<EdgeId>(f.Edges.size(),
    [&](EdgeId e)
    {
      const Point3 d = f.Points[At(f.Edges[e][1])] - f.Points[At(f.Edges[e][0])];
      edgeValue[e] = 0.25 * Dot(d, d);
    });
  f.EdgesInOrder = SimplexOrder(edgeValue, f.EdgeFirst, f.RankOfEdge);
  return f;
}

/// Maps points of the complex to those of the given surface; points added by TetGen follow.
class Renamer
{
public:
  Renamer(const SurfaceView& surface, const SurfaceView& embedded)
    : Embedded(embedded)
    , First(static_cast<SimplexId>(surface.Points.size()))
    , Own(embedded.Points.size(), -1)
  {
    for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        this->Own[At(embedded.Triangles[t][k])] = static_cast<SimplexId>(surface.Triangles[t][k]);
      }
    }
  }

  void Rename(Membrane& membrane) const
  {
    std::unordered_map<SimplexId, SimplexId> extra;
    const auto rename = [&](SimplexId& p)
    {
      if (this->Own[At(p)] >= 0)
      {
        p = this->Own[At(p)];
        return;
      }
      const auto next = this->First + static_cast<SimplexId>(membrane.Extra.size());
      const auto made = extra.emplace(p, next);
      if (made.second)
      {
        membrane.Extra.push_back(this->Embedded.Points[At(p)]);
      }
      p = made.first->second;
    };
    for (auto& loop : membrane.Loops)
    {
      std::for_each(loop.begin(), loop.end(), rename);
    }
    for (auto& t : membrane.Triangles)
    {
      std::for_each(t.begin(), t.end(), rename);
    }
  }

private:
  SurfaceView Embedded;
  SimplexId First;
  std::vector<SimplexId> Own; ///< -1 for TetGen's
};

}

ConformingMesh::ConformingMesh(const SurfaceView& surface)
  : Mesh(std::async(
      [this, surface]
      {
        TetrahedralParameters parameters;
        parameters.Side = MeshedSide::Both;
        parameters.TetGen.RadiusEdgeRatio = 0.0; // no refinement: M's own points and those of a box
        parameters.TetGen.Limits.TimeLimit = MostSeconds;
        return MeshTetrahedra(surface, parameters,
          [this](double done)
          {
            this->Done = done;
            return !this->Stopped;
          });
      }))
{
}

ConformingMesh::~ConformingMesh()
{
  this->Stopped = true;
}

TetrahedralMesh ConformingMesh::Take(const ProgressCallback& progress)
{
  constexpr auto pause = std::chrono::milliseconds(20);
  while (this->Mesh.wait_for(pause) == std::future_status::timeout)
  {
    Report(progress, this->Done);
  }
  return this->Mesh.get();
}

std::vector<ConformingGenerator> ConformingGenerators(
  const SurfaceView& surface, const ProgressCallback& progress, ConformingMesh* mesh)
{
  std::optional<ConformingMesh> made;
  TriangleMesh embedded = CopyMesh(surface);
  CellFiltration f = FiltrationByBalls(
    (mesh ? *mesh : made.emplace(surface)).Take(Between(progress, 0.0, 0.6)), embedded);
  std::vector<Point3>().swap(embedded.Points); // those of f
  const Renamer renamer(surface, SurfaceView(f.Points, embedded.Triangles));
  const FiltrationPairs pairs(f, Between(progress, 0.6, 0.8));
  f.DropTriangleRanks();
  const SurfaceAdjacency adjacency(SurfaceView(f.Points, embedded.Triangles));
  const SurfaceHomology homology(adjacency);
  const SurfaceInComplex embedding(adjacency, f);
  const FeatureContext context{ f, pairs, homology, embedding, adjacency, {}, {} };
  SpaceRegions regions(context);
  f.DropEdgeAndCellValues();
  std::vector<ConformingGenerator> found;
  HomologySpan span;
  for (const SurfaceGenerator& generator :
    SurfaceGenerators(homology, embedding, f, pairs, Between(progress, 0.8, 1.0)))
  {
    ShapeFeature feature;
    feature.Dimension = 1;
    feature.Choke = generator.Filler;
    feature.Side = SpaceRegions::SideFrom(regions.OfTriangle(generator.Filler));
    feature.Sum = generator.Sum;
    const auto t = f.TrianglePoints(generator.Filler);
    ConformingGenerator conforming;
    conforming.Side = feature.Side;
    conforming.Radius = std::sqrt(SquaredBall(f, t));
    conforming.Center = BallCenter(f.Points[At(t[0])], f.Points[At(t[1])], f.Points[At(t[2])]);
    conforming.Shape = FeatureMembrane(context, regions, feature, &span);
    renamer.Rename(conforming.Shape);
    found.push_back(std::move(conforming));
  }
  return found;
}

SplitSurface::SplitSurface(const SurfaceView& surface, const SurfaceAdjacency& samples)
  : Samples(samples)
  , Original(surface)
{
  const View<Point3>& points = samples.Mesh().Points;
  for (std::size_t i = surface.Points.size(); i < points.size(); ++i)
  {
    this->Added.emplace(points[i], static_cast<SimplexId>(i));
  }
}

bool SplitSurface::IsSplit(SimplexId a, SimplexId b) const
{
  return this->Original.Find(a, b).Exists() && !this->Samples.Find(a, b).Exists();
}

// The points from a (included) to b (not included). Midpoints were computed by the same formula.
void SplitSurface::AddPieces(SimplexId a, SimplexId b, std::vector<SimplexId>& points) const
{
  if (this->Samples.Find(a, b).Exists())
  {
    points.push_back(a);
    return;
  }
  const View<Point3>& at = this->Samples.Mesh().Points;
  const SimplexId middle = this->Added.at(0.5 * (at[At(a)] + at[At(b)]));
  this->AddPieces(a, middle, points);
  this->AddPieces(middle, b, points);
}

Membrane SplitSurface::Of(const Membrane& membrane) const
{
  Membrane split;
  split.OnSurface = membrane.OnSurface;
  split.Extra = membrane.Extra;
  const auto own = static_cast<SimplexId>(this->Original.Mesh().Points.size());
  const auto all = static_cast<SimplexId>(this->Samples.Mesh().Points.size());
  for (const auto& loop : membrane.Loops)
  {
    std::vector<SimplexId> points;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      this->AddPieces(loop[i], loop[(i + 1) % loop.size()], points);
    }
    split.Loops.push_back(std::move(points));
  }
  for (const auto& t : membrane.Triangles)
  {
    std::vector<SimplexId> points;
    for (std::size_t k = 0; k < 3; ++k)
    {
      const SimplexId a = t[k];
      const SimplexId b = t[(k + 1) % 3];
      if (a < own && b < own && this->IsSplit(a, b))
      {
        this->AddPieces(a, b, points);
      }
      else
      {
        points.push_back(a < own ? a : a - own + all);
      }
    }
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
    {
      split.Triangles.push_back({ points[0], points[i], points[i + 1] });
    }
  }
  return split;
}

// ------------------------------------------------------------------------------------------
// GeneratorCompletion
namespace
{

bool IsResolved(const ShapeFeature& feature, const std::optional<Membrane>& membrane)
{
  return feature.Trusted && membrane && !membrane->Loops.empty();
}

ShapeFeature MakeFeature(const ConformingGenerator& generator, double reference)
{
  ShapeFeature feature;
  feature.Dimension = 1;
  feature.Side = generator.Side;
  feature.Kind = generator.Side == SpaceSide::Inside ? FeatureKind::Handle : FeatureKind::Tunnel;
  feature.PairDeath = generator.Radius;
  feature.Error = generator.Radius;
  feature.Death = std::max(generator.Radius, reference);
  return feature;
}

/// A copy in ascending order of Radius().
LocatedFeatures Sorted(const LocatedFeatures& features)
{
  const std::vector<ShapeFeature>& all = features.Diagram.Features;
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&all](std::size_t a, std::size_t b) { return all[a].Radius() < all[b].Radius(); });
  LocatedFeatures sorted;
  sorted.Diagram.Reference = features.Diagram.Reference;
  sorted.Diagram.ExpectedGenerators = features.Diagram.ExpectedGenerators;
  for (const std::size_t i : order)
  {
    sorted.Diagram.Features.push_back(all[i]);
    sorted.Membranes.push_back(features.Membranes[i]);
    sorted.Centers.push_back(features.Centers[i]);
  }
  return sorted;
}

}

std::size_t CountUnresolved(const LocatedFeatures& features)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < features.Membranes.size(); ++i)
  {
    const ShapeFeature& f = features.Diagram.Features[i];
    count += IsGenerator(f) && !IsResolved(f, features.Membranes[i]) ? 1 : 0;
  }
  return count;
}

void CompleteGenerators(const FeatureContext& context, const SurfaceView& surface,
  LocatedFeatures& features, const ProgressCallback& progress, ConformingMesh* mesh)
{
  const std::vector<ConformingGenerator> conforming = ConformingGenerators(surface, progress, mesh);
  const SplitSurface split(surface, context.Surface);
  std::vector<Membrane> shapes;
  std::array<HomologySpan, 2> bounding; // the classes that bound on each side
  for (const ConformingGenerator& generator : conforming)
  {
    shapes.push_back(split.Of(generator.Shape));
    bounding[static_cast<std::size_t>(generator.Side)].Add(MembraneClass(context, shapes.back()));
  }
  LocatedFeatures kept;
  kept.Diagram.Reference = features.Diagram.Reference;
  kept.Diagram.ExpectedGenerators = features.Diagram.ExpectedGenerators;
  const auto keep = [&kept](ShapeFeature f, std::optional<Membrane> membrane, const Point3& center)
  {
    kept.Diagram.Features.push_back(std::move(f));
    kept.Membranes.push_back(std::move(membrane));
    kept.Centers.push_back(center);
  };
  std::array<HomologySpan, 2> spans;
  for (std::size_t i = 0; i < features.Membranes.size(); ++i)
  {
    const ShapeFeature& f = features.Diagram.Features[i];
    const std::optional<Membrane>& membrane = features.Membranes[i];
    const auto side = static_cast<std::size_t>(f.Side);
    const auto isTrue = [&]
    {
      const HomologyClass c = MembraneClass(context, *membrane);
      return bounding[side].Contains(c) && spans[side].Add(c);
    };
    if (!IsGenerator(f) || (IsResolved(f, membrane) && isTrue()))
    {
      keep(f, membrane, features.Centers[i]);
    }
  }
  for (std::size_t i = 0; i < conforming.size(); ++i)
  {
    const auto side = static_cast<std::size_t>(conforming[i].Side);
    if (spans[side].Add(MembraneClass(context, shapes[i])))
    {
      keep(MakeFeature(conforming[i], kept.Diagram.Reference[side]), std::move(shapes[i]),
        conforming[i].Center);
    }
  }
  features = Sorted(kept);
}

}
