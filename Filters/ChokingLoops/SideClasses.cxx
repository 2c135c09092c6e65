#include "ChokingLoops/SideClasses.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <map>
#include <optional>
#include <stdexcept>

namespace isthmus
{
namespace
{

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

void Add(HomologyClass& sum, const HomologyClass& c)
{
  std::transform(sum.begin(), sum.end(), c.begin(), sum.begin(), std::bit_xor<>());
}

template <typename Work>
void ForEachBit(const HomologyClass& c, const Work& work)
{
  for (std::size_t w = 0; w < c.size(); ++w)
  {
    for (std::uint64_t bits = c[w], bit = 0; bits != 0; bits >>= 1, ++bit)
    {
      if (bits & 1U)
      {
        work(64 * w + bit);
      }
    }
  }
}

/// Integers, so that sixfold midpoints and centroids are exact as well; turned by arbitrary angles,
/// so that no edge is vertical and no two of a regular grid coincide in projection.
std::vector<Point3> SixfoldIntegers(const View<Point3>& points)
{
  const Point3 a{ 0.7513, -0.4127, 0.5150 };
  const Point3 b{ 0.6061, 0.7391, -0.2917 };
  Bounds3 box{ points.front(), points.front() };
  for (const Point3& p : points)
  {
    box.Add(p);
  }
  const double scale = std::ldexp(1.0, 45) / std::max(box.Diagonal(), 1e-300);
  std::vector<Point3> turned;
  turned.reserve(points.size());
  for (const Point3& p : points)
  {
    const Point3 d = scale * (p - box.Min);
    turned.push_back({ 6.0 * std::round(Dot(d, a)), 6.0 * std::round(Dot(d, b)),
      6.0 * std::round(Dot(d, Cross(a, b))) });
  }
  return turned;
}

CGAL::Sign Turn(const Point3& a, const Point3& b, const Point3& p)
{
  return CGAL::orientation(
    Kernel::Point_2(a[0], a[1]), Kernel::Point_2(b[0], b[1]), Kernel::Point_2(p[0], p[1]));
}

CGAL::Sign Orientation(const Point3& a, const Point3& b, const Point3& p, const Point3& q)
{
  return CGAL::orientation(Kernel::Point_3(a[0], a[1], a[2]), Kernel::Point_3(b[0], b[1], b[2]),
    Kernel::Point_3(p[0], p[1], p[2]), Kernel::Point_3(q[0], q[1], q[2]));
}

/// True if segment ab passes above segment pq. @pre No two of these points coincide in projection.
bool IsAbove(const Point3& a, const Point3& b, const Point3& p, const Point3& q)
{
  const CGAL::Sign side = Turn(a, b, q);
  return side != Turn(a, b, p) && Turn(p, q, a) != Turn(p, q, b) && Orientation(a, b, p, q) == side;
}

/// The segments across an edge that join its midpoint to the centroids of its triangles.
struct DualEdge
{
  SurfaceEdgeId Edge;
  std::array<Point3, 3> Points;
  Bounds3 Box;
};

/// Linking numbers of the dual loops, pushed off to the outside, with the basis loops.
class Crossings
{
public:
  Crossings(const SurfaceAdjacency& surface, const SurfaceHomology& homology)
    : Surface(surface)
    , Homology(homology)
    , Points(SixfoldIntegers(surface.Mesh().Points))
    , Box{ Points.front(), Points.front() }
  {
    for (const Point3& p : this->Points)
    {
      this->Box.Add(p);
    }
    this->FindDualEdges();
    for (const DualEdge& dual : this->Dual)
    {
      const SurfaceTriangleId t = SurfaceAdjacency::Triangle(surface.GetHalfEdge(dual.Edge));
      const int component = this->ComponentOf(t);
      if (this->FacesOutward.count(component) == 0)
      {
        this->FacesOutward[component] = this->IsOutward(t);
      }
    }
  }

  /// The dual loops that pass below an edge, once more than an even number of times.
  HomologyClass Below(SurfaceEdgeId edge) const;

private:
  void FindDualEdges();
  Point3 Centroid(SurfaceTriangleId t) const;
  bool IsOutward(SurfaceTriangleId t) const;
  bool IsOutsideBelow(HalfEdgeId h) const;

  int ComponentOf(SurfaceTriangleId t) const
  {
    return this->Homology.GetComponent(
      static_cast<SimplexId>(this->Surface.Mesh().Triangles[t.Index()][0]));
  }

  std::array<std::size_t, 2> Bin(const Point3& p) const
  {
    std::array<std::size_t, 2> bin{};
    for (std::size_t k = 0; k < 2; ++k)
    {
      const double width = this->Box.Max[k] - this->Box.Min[k];
      const double place = (p[k] - this->Box.Min[k]) / width * static_cast<double>(this->Bins);
      bin[k] =
        static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(this->Bins - 1)));
    }
    return bin;
  }

  template <typename Work>
  void ForEachBin(const Bounds3& box, const Work& work) const
  {
    const auto from = this->Bin(box.Min), to = this->Bin(box.Max);
    for (std::size_t i = from[0]; i <= to[0]; ++i)
    {
      for (std::size_t j = from[1]; j <= to[1]; ++j)
      {
        work(i, j);
      }
    }
  }

  const SurfaceAdjacency& Surface;
  const SurfaceHomology& Homology;
  std::vector<Point3> Points;
  Bounds3 Box;
  std::map<int, bool> FacesOutward; ///< by component; of those with dual loops
  std::size_t Bins = 1;             ///< of the projection, each way
  std::vector<DualEdge> Dual;       ///< those that dual loops use
  std::vector<std::vector<std::size_t>> InBin;
};

Point3 Crossings::Centroid(SurfaceTriangleId t) const
{
  const Triangle& c = this->Surface.Mesh().Triangles[t.Index()];
  // The coordinates are multiples of 6.
  return (1.0 / 3.0) * (this->Points[At(c[0])] + this->Points[At(c[1])] + this->Points[At(c[2])]);
}

/// Whether the normal of a triangle, by the order of its corners, points outside: above it is
/// outside if an even number of triangles lie above.
bool Crossings::IsOutward(SurfaceTriangleId t) const
{
  const Point3 p = this->Centroid(t);
  bool isOutside = true;
  bool facesUp = false;
  for (std::size_t i = 0; i < this->Surface.Mesh().Triangles.size(); ++i)
  {
    const Triangle& c = this->Surface.Mesh().Triangles[i];
    const Point3& a = this->Points[At(c[0])];
    const Point3& b = this->Points[At(c[1])];
    const Point3& d = this->Points[At(c[2])];
    if (p[0] < std::min({ a[0], b[0], d[0] }) || p[0] > std::max({ a[0], b[0], d[0] }) ||
      p[1] < std::min({ a[1], b[1], d[1] }) || p[1] > std::max({ a[1], b[1], d[1] }))
    {
      continue;
    }
    const CGAL::Sign turn = Turn(a, b, d);
    if (i == t.Index())
    {
      facesUp = turn == CGAL::POSITIVE;
    }
    else if (Turn(a, b, p) == turn && Turn(b, d, p) == turn && Turn(d, a, p) == turn &&
      Orientation(a, b, d, p) != turn)
    {
      isOutside = !isOutside;
    }
  }
  return facesUp == isOutside;
}

void Crossings::FindDualEdges()
{
  for (const SurfaceEdgeId e : this->Surface.Edges())
  {
    HomologyClass loops = this->Homology.GetClass({ e });
    if (IsZero(loops))
    {
      continue;
    }
    const HalfEdgeId h = this->Surface.GetHalfEdge(e);
    DualEdge dual{ e,
      { this->Centroid(SurfaceAdjacency::Triangle(h)),
        0.5 * (this->Points[At(this->Surface.From(h))] + this->Points[At(this->Surface.To(h))]),
        this->Centroid(SurfaceAdjacency::Triangle(this->Surface.Opposite(h))) },
      {} };
    dual.Box = { dual.Points[0], dual.Points[0] };
    dual.Box.Add(dual.Points[1]);
    dual.Box.Add(dual.Points[2]);
    this->Dual.push_back(dual);
  }
  this->Bins = std::clamp<std::size_t>(
    static_cast<std::size_t>(std::sqrt(static_cast<double>(this->Dual.size()))), 1, 1024);
  this->InBin.resize(this->Bins * this->Bins);
  for (std::size_t d = 0; d < this->Dual.size(); ++d)
  {
    this->ForEachBin(this->Dual[d].Box,
      [&](std::size_t i, std::size_t j) { this->InBin[i * this->Bins + j].push_back(d); });
  }
}

/// Where a dual edge crosses its own edge, it is pushed off: it passes below if the place just
/// below the edge is outside.
bool Crossings::IsOutsideBelow(HalfEdgeId h) const
{
  const HalfEdgeId other = this->Surface.Opposite(h);
  const auto third = [this](HalfEdgeId half) -> const Point3&
  { return this->Points[At(this->Surface.From(SurfaceAdjacency::Previous(half)))]; };
  const Point3& a = this->Points[At(this->Surface.From(h))];
  const Point3& b = this->Points[At(this->Surface.To(h))];
  const bool outward = this->FacesOutward.at(this->ComponentOf(SurfaceAdjacency::Triangle(h)));
  const auto facesDown = [outward](CGAL::Sign up)
  { return up == (outward ? CGAL::NEGATIVE : CGAL::POSITIVE); };
  const bool one = facesDown(Turn(a, b, third(h)));
  const bool two = facesDown(Turn(b, a, third(other)));
  const bool isConvex = facesDown(Orientation(a, b, third(h), third(other)));
  return isConvex ? one || two : one && two;
}

HomologyClass Crossings::Below(SurfaceEdgeId edge) const
{
  const HalfEdgeId h = this->Surface.GetHalfEdge(edge);
  const Point3& a = this->Points[At(this->Surface.From(h))];
  const Point3& b = this->Points[At(this->Surface.To(h))];
  HomologyClass below = this->Homology.GetClass({});
  Bounds3 box{ a, a };
  box.Add(b);
  this->ForEachBin(box,
    [&](std::size_t i, std::size_t j)
    {
      for (const std::size_t d : this->InBin[i * this->Bins + j])
      {
        const DualEdge& dual = this->Dual[d];
        const auto first = this->Bin(
          { std::max(box.Min[0], dual.Box.Min[0]), std::max(box.Min[1], dual.Box.Min[1]), 0.0 });
        if (first[0] != i || first[1] != j) // counted in one bin only
        {
          continue;
        }
        const bool isBelow = dual.Edge == edge ? this->IsOutsideBelow(h)
                                               : IsAbove(a, b, dual.Points[0], dual.Points[1]) !=
            IsAbove(a, b, dual.Points[1], dual.Points[2]);
        if (isBelow)
        {
          this->Homology.AddTo(below, dual.Edge);
        }
      }
    });
  return below;
}

}

SideClasses::SideClasses(const SurfaceAdjacency& surface, const SurfaceHomology& homology)
{
  if (homology.Rank() == 0)
  {
    return;
  }
  std::vector<SurfaceChain> loops(homology.Rank());
  std::vector<SurfaceEdgeId> edges;
  HandleVector<SurfaceEdgeId, SimplexId> place(surface.EdgeCount(), -1);
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    loops[i] = homology.Loop(i);
    for (const SurfaceEdgeId e : loops[i])
    {
      if (place[e] < 0)
      {
        place[e] = static_cast<SimplexId>(edges.size());
        edges.push_back(e);
      }
    }
  }
  const Crossings crossings(surface, homology);
  std::vector<HomologyClass> below(edges.size());
  ParallelFor(0, static_cast<std::int64_t>(edges.size()), 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      {
        below[i] = crossings.Below(edges[i]);
      }
    });
  this->Outside.assign(loops.size(), homology.GetClass({}));
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    for (const SurfaceEdgeId e : loops[i])
    {
      Add(this->Outside[i], below[At(place[e])]);
    }
  }
  HomologySpan inside, outside;
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    if (!this->Bounds(this->Outside[i], SpaceSide::Outside))
    {
      throw std::runtime_error("The sides of its loops contradict each other, as where a surface "
                               "crosses itself: repair the surface.");
    }
    HomologyClass basis = homology.GetClass({});
    basis[i / 64] = std::uint64_t{ 1 } << (i % 64);
    inside.Add(this->Part(basis, SpaceSide::Inside));
    outside.Add(this->Outside[i]);
  }
  if (inside.Rank() != outside.Rank())
  {
    throw std::runtime_error("The surface has different numbers of handles and tunnels, as where "
                             "it crosses itself: repair the surface.");
  }
}

HomologyClass SideClasses::Part(const HomologyClass& c, SpaceSide side) const
{
  HomologyClass part(c.size(), 0);
  ForEachBit(c, [&](std::size_t i) { Add(part, this->Outside[i]); });
  if (side == SpaceSide::Inside)
  {
    Add(part, c);
  }
  return part;
}

// ------------------------------------------------------------------------------------------
// CompleteGenerators
namespace
{

bool IsResolved(const ShapeFeature& feature, const std::optional<Membrane>& membrane)
{
  return feature.Trusted && membrane && !membrane->Loops.empty();
}

/// Number of handles and tunnels that are not above the sampling error, or without a loop.
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

/// Handles and tunnels in ascending order, each independent of the others on its side.
class Completion
{
public:
  Completion(const FeatureContext& context, const LocatedFeatures& features)
    : Context(context)
    , Features(features)
    , Sides(context.Surface, context.Homology)
    , IsKept(features.Membranes.size(), 0)
  {
    for (std::size_t i = 0; i < this->IsKept.size(); ++i)
    {
      const ShapeFeature& f = features.Diagram.Features[i];
      if (IsGenerator(f) && IsResolved(f, features.Membranes[i]))
      {
        const HomologyClass c = MembraneClass(context, *features.Membranes[i]);
        this->IsKept[i] = this->Sides.Bounds(c, f.Side) && this->All[IndexOf(f.Side)].Add(c);
      }
    }
  }

  /// True if the given handles and tunnels are g each already.
  bool IsComplete() const
  {
    const std::size_t genus = this->Context.Homology.Rank() / 2;
    return this->All[0].Rank() == genus && this->All[1].Rank() == genus &&
      CountUnresolved(this->Features) == 0;
  }

  LocatedFeatures Complete();

private:
  static std::size_t IndexOf(SpaceSide side) { return static_cast<std::size_t>(side); }

  void Keep(ShapeFeature f, std::optional<Membrane> membrane, const Point3& center)
  {
    this->Kept.Diagram.Features.push_back(std::move(f));
    this->Kept.Membranes.push_back(std::move(membrane));
    this->Kept.Centers.push_back(center);
  }

  void AddPart(std::size_t i, const HomologyClass& c, SpaceSide side);
  Membrane MakeMembrane(std::size_t i, const HomologyClass& part, SpaceSide side) const;

  const FeatureContext& Context;
  const LocatedFeatures& Features;
  SideClasses Sides;
  std::vector<char> IsKept;
  std::array<HomologySpan, 2> All;      ///< the classes of all that are kept or added
  std::array<HomologySpan, 2> Narrower; ///< of those passed
  LocatedFeatures Kept;
};

LocatedFeatures Completion::Complete()
{
  this->Kept.Diagram.Reference = this->Features.Diagram.Reference;
  this->Kept.Diagram.ExpectedGenerators = this->Features.Diagram.ExpectedGenerators;
  for (std::size_t i = 0; i < this->IsKept.size(); ++i)
  {
    const ShapeFeature& f = this->Features.Diagram.Features[i];
    if (!IsGenerator(f) || this->IsKept[i])
    {
      if (this->IsKept[i])
      {
        this->Narrower[IndexOf(f.Side)].Add(
          MembraneClass(this->Context, *this->Features.Membranes[i]));
      }
      this->Keep(f, this->Features.Membranes[i], this->Features.Centers[i]);
      continue;
    }
    HomologyClass c = this->Context.Homology.GetClass({});
    for (const std::size_t k : f.Sum)
    {
      c[k / 64] ^= std::uint64_t{ 1 } << (k % 64);
    }
    this->AddPart(i, c, SpaceSide::Inside);
    this->AddPart(i, c, SpaceSide::Outside);
  }
  return std::move(this->Kept);
}

void Completion::AddPart(std::size_t i, const HomologyClass& c, SpaceSide side)
{
  const HomologyClass part = this->Sides.Part(c, side);
  if (!this->All[IndexOf(side)].Add(part))
  {
    return;
  }
  ShapeFeature f = this->Features.Diagram.Features[i];
  f.Side = side;
  f.Kind = side == SpaceSide::Inside ? FeatureKind::Handle : FeatureKind::Tunnel;
  f.Trusted = false;
  f.Error = f.Radius();
  f.Death = std::max(f.Radius(), this->Kept.Diagram.Reference[IndexOf(side)]);
  Membrane membrane = this->MakeMembrane(i, part, side);
  this->Narrower[IndexOf(side)].Add(MembraneClass(this->Context, membrane));
  this->Keep(std::move(f), std::move(membrane), this->Features.Centers[i]);
}

/// With loops of the part's class, or of one that differs by classes of narrower features.
Membrane Completion::MakeMembrane(std::size_t i, const HomologyClass& part, SpaceSide side) const
{
  const auto accepts = [&](const HomologyClass& c)
  {
    HomologyClass difference = c;
    Add(difference, part);
    return this->Narrower[IndexOf(side)].Contains(difference);
  };
  const std::optional<Membrane>& own = this->Features.Membranes[i];
  if (own && !own->Loops.empty() && accepts(MembraneClass(this->Context, *own)))
  {
    return *own;
  }
  SurfaceChain sum;
  ForEachBit(part,
    [&](std::size_t k)
    {
      const SurfaceChain loop = this->Context.Homology.Loop(k);
      SurfaceChain both;
      std::set_symmetric_difference(
        sum.begin(), sum.end(), loop.begin(), loop.end(), std::back_inserter(both));
      sum = std::move(both);
    });
  double length = 0.0;
  for (const SurfaceEdgeId e : sum)
  {
    length += this->Context.Surface.Length(this->Context.Surface.GetHalfEdge(e));
  }
  if (std::optional<Membrane> shortest = EncirclingMembrane(this->Context,
        this->Features.Diagram.Features[i], this->Features.Centers[i], accepts, length))
  {
    return std::move(*shortest);
  }
  Membrane membrane;
  membrane.Loops = SimpleLoops(this->Context.Surface, sum);
  for (const auto& loop : membrane.Loops)
  {
    AddFan(loop, membrane.Triangles);
  }
  return membrane;
}

}

bool CompleteGenerators(const FeatureContext& context, LocatedFeatures& features)
{
  if (context.Homology.Rank() == 0)
  {
    return false;
  }
  Completion completion(context, features);
  if (completion.IsComplete())
  {
    return false;
  }
  features = completion.Complete();
  return true;
}

}
