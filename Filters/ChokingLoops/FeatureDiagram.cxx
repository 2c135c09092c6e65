#include "ChokingLoops/FeatureDiagram.h"

#include "Core/Index.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// EnclosureTest
namespace
{

/// A fixed rotation by arbitrary angles, so that rays along x meet no axis-parallel edge.
Point3 Turned(const Point3& p)
{
  const Point3 a{ 0.8127, 0.3391, -0.4738 };
  const Point3 b{ -0.5129, 0.7793, -0.3600 };
  return { Dot(p, a), Dot(p, b), Dot(p, Cross(a, b)) };
}

/// Twice the area of (a, b, p) seen along x.
double Area(const Point3& a, const Point3& b, const Point3& p)
{
  return (b[1] - a[1]) * (p[2] - a[2]) - (b[2] - a[2]) * (p[1] - a[1]);
}

}

EnclosureTest::EnclosureTest(const SurfaceView& mesh, const SurfaceHomology& homology)
  : Mesh(mesh)
  , Homology(homology)
{
  this->Box.Min = { HUGE_VAL, HUGE_VAL, HUGE_VAL };
  this->Box.Max = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
  for (const Point3& p : mesh.Points)
  {
    this->Box.Add(Turned(p));
  }
  this->Bins = std::clamp<std::size_t>(
    static_cast<std::size_t>(0.5 * std::sqrt(static_cast<double>(mesh.Triangles.size()))), 1, 2048);
  const auto forEachBin = [this](const Triangle& t, auto&& visit)
  {
    const auto corner = this->Corners(t);
    Bounds3 box{ corner[0], corner[0] };
    box.Add(corner[1]);
    box.Add(corner[2]);
    for (std::size_t j = this->Bin(box.Min[1], 1); j <= this->Bin(box.Max[1], 1); ++j)
    {
      for (std::size_t k = this->Bin(box.Min[2], 2); k <= this->Bin(box.Max[2], 2); ++k)
      {
        visit(j * this->Bins + k);
      }
    }
  };
  this->First.assign(this->Bins * this->Bins + 1, 0);
  for (const Triangle& t : mesh.Triangles)
  {
    forEachBin(t, [this](std::size_t bin) { ++this->First[bin + 1]; });
  }
  for (std::size_t i = 1; i < this->First.size(); ++i)
  {
    this->First[i] += this->First[i - 1];
  }
  this->Inside.resize(At(this->First.back()));
  std::vector<SimplexId> next(this->First.begin(), this->First.end() - 1);
  for (std::size_t i = 0; i < mesh.Triangles.size(); ++i)
  {
    forEachBin(mesh.Triangles[i],
      [&](std::size_t bin) { this->Inside[At(next[bin]++)] = static_cast<SimplexId>(i); });
  }
}

std::array<Point3, 3> EnclosureTest::Corners(const Triangle& t) const
{
  return { Turned(this->Mesh.Points[At(t[0])]), Turned(this->Mesh.Points[At(t[1])]),
    Turned(this->Mesh.Points[At(t[2])]) };
}

std::size_t EnclosureTest::Bin(double v, std::size_t axis) const
{
  const double width = this->Box.Max[axis] - this->Box.Min[axis];
  const double scaled =
    width > 0.0 ? (v - this->Box.Min[axis]) / width * static_cast<double>(this->Bins) : 0.0;
  // Written so that a NaN goes to the first bin: std::clamp would pass it on to the cast.
  return scaled > 0.0
    ? static_cast<std::size_t>(std::min(scaled, static_cast<double>(this->Bins - 1)))
    : 0;
}

std::vector<int> EnclosureTest::Enclosing(const Point3& point) const
{
  const Point3 p = Turned(point);
  std::vector<int> crossed;
  for (std::size_t axis = 1; axis < 3; ++axis)
  {
    if (p[axis] < this->Box.Min[axis] || p[axis] > this->Box.Max[axis])
    {
      return crossed;
    }
  }
  const std::size_t bin = this->Bin(p[1], 1) * this->Bins + this->Bin(p[2], 2);
  for (SimplexId i = this->First[bin]; i < this->First[bin + 1]; ++i)
  {
    const Triangle& t = this->Mesh.Triangles[At(this->Inside[At(i)])];
    const auto corner = this->Corners(t);
    std::array<double, 3> area; // of p with the edge opposite to corner k
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t a = (k + 1) % 3, b = (k + 2) % 3;
      area[k] = t[a] < t[b] ? Area(corner[a], corner[b], p) : -Area(corner[b], corner[a], p);
    }
    // "Positive" for an edge in one direction must be "not positive" in the other direction.
    const auto left = [&](std::size_t k)
    { return t[(k + 1) % 3] < t[(k + 2) % 3] ? area[k] > 0.0 : area[k] >= 0.0; };
    if (left(0) != left(1) || left(1) != left(2))
    {
      continue;
    }
    const double sum = area[0] + area[1] + area[2];
    const double x =
      (area[0] * corner[0][0] + area[1] * corner[1][0] + area[2] * corner[2][0]) / sum;
    if (x > p[0])
    {
      crossed.push_back(this->Homology.GetComponent(static_cast<SimplexId>(t[0])));
    }
  }
  std::sort(crossed.begin(), crossed.end());
  std::vector<int> odd;
  for (std::size_t i = 0; i < crossed.size(); ++i)
  {
    if (i + 1 < crossed.size() && crossed[i] == crossed[i + 1])
    {
      ++i;
      continue;
    }
    odd.push_back(crossed[i]);
  }
  return odd;
}

// ------------------------------------------------------------------------------------------
// SpaceRegions
SpaceRegions::SpaceRegions(const FeatureContext& context, const ProgressCallback& progress)
  : Context(context)
  , Groups(context.Filtration.Tetrahedra.size())
  , Test(context.Surface.Mesh(), context.Homology)
{
  const CellFiltration& f = context.Filtration;
  for (const TriangleId t : f.Triangles())
  {
    if (t.Index() % (1U << 18) == 0)
    {
      Report(progress, static_cast<double>(t.Index()) / static_cast<double>(f.TriangleCount()));
    }
    const auto sides = f.TriangleSides(t);
    if (sides[0].Exists() && sides[1].Exists() && !context.IsWall(t))
    {
      const TetrahedronId a = this->Groups.Find(sides[0]);
      const TetrahedronId b = this->Groups.Find(sides[1]);
      const bool later = f.EntersLater(a, b);
      this->Groups.JoinUnder(later ? b : a, later ? a : b);
    }
  }
}

const std::vector<int>& SpaceRegions::Of(TetrahedronId cell)
{
  static const std::vector<int> none;
  if (!cell.Exists())
  {
    return none;
  }
  const TetrahedronId group = this->Groups.Find(cell);
  auto known = this->Known.find(group);
  if (known == this->Known.end())
  {
    known = this->Known.emplace(group, this->Test.Enclosing(this->Inner(group))).first;
  }
  return known->second;
}

// In a Delaunay triangulation the side is decided by the circumcenter, which has a distance from M;
// in a mesh that conforms to M the tetrahedron itself lies on one side.
Point3 SpaceRegions::Inner(TetrahedronId deepest) const
{
  const CellFiltration& f = this->Context.Filtration;
  const auto& t = f.Tetrahedra[deepest];
  const Point3& p = f.Points[At(t[0])];
  const Point3& q = f.Points[At(t[1])];
  const Point3& r = f.Points[At(t[2])];
  const Point3& s = f.Points[At(t[3])];
  return this->Context.Errors.Point.empty() ? 0.25 * (p + q + r + s) : Circumcenter(p, q, r, s);
}

Point3 Circumcenter(const Point3& p, const Point3& q, const Point3& r)
{
  const Point3 a = q - p;
  const Point3 b = r - p;
  const Point3 n = Cross(a, b);
  const Point3 towards = Dot(a, a) * Cross(b, n) + Dot(b, b) * Cross(n, a);
  return p + (0.5 / Dot(n, n)) * towards;
}

Point3 Circumcenter(const Point3& p, const Point3& q, const Point3& r, const Point3& s)
{
  const Point3 a = q - p;
  const Point3 b = r - p;
  const Point3 c = s - p;
  const Point3 sum = Dot(a, a) * Cross(b, c) + Dot(b, b) * Cross(c, a) + Dot(c, c) * Cross(a, b);
  return p + (0.5 / Dot(a, Cross(b, c))) * sum;
}

// ------------------------------------------------------------------------------------------
// FeatureDiagram
namespace
{

/**
 * The largest error of a function on a mesh at all values up to a given one, on each side.
 *
 * Where f and g differ by at most e in all cells that reach below a level r, a class that dies at r
 * by f dies in [r - e, r + e] by g: its chain below r lies below r + e by g, and a chain by g below
 * some s < r - e would lie below s + e < r by f (H. Edelsbrunner, J. Harer, Computational
 * Topology, section VIII.2).
 */
class ErrorsByLevel
{
public:
  ErrorsByLevel(const FeatureContext& context, SpaceRegions& regions)
  {
    if (context.CellErrors.empty())
    {
      return;
    }
    for (const TetrahedronId cell : context.Filtration.Tetrahedra.Keys())
    {
      const SpaceSide side = SpaceRegions::SideFrom(regions.Of(cell));
      this->Errors[static_cast<std::size_t>(side)].push_back(context.CellErrors[cell.Index()]);
    }
    for (std::vector<CellError>& side : this->Errors)
    {
      std::sort(side.begin(), side.end(),
        [](const CellError& a, const CellError& b) { return a.Least < b.Least; });
      double largest = 0.0;
      for (CellError& error : side)
      {
        largest = std::max(largest, error.Error);
        error.Error = largest;
      }
    }
  }

  /// 0 if there are no cell errors.
  double UpTo(double level, SpaceSide side) const
  {
    const std::vector<CellError>& errors = this->Errors[static_cast<std::size_t>(side)];
    const auto end = std::upper_bound(errors.begin(), errors.end(), level,
      [](double value, const CellError& error) { return value < error.Least; });
    return end == errors.begin() ? 0.0 : (end - 1)->Error;
  }

private:
  std::array<std::vector<CellError>, 2>
    Errors; ///< sorted by Least; each has the largest error up to it
};

/// Relative difference of squared radii that rounding may make.
constexpr double Rounding = 1e-7;

bool Differ(double birth, double death)
{
  return death - birth > Rounding * death;
}

/// Collects the features of one diagram.
class Collector
{
public:
  Collector(const FeatureContext& context, SpaceRegions& regions)
    : Context(context)
    , F(context.Filtration)
    , Regional(regions)
    , Levels(context, regions)
  {
  }

  void AddVoids();
  void AddLoops(const std::vector<SurfaceGenerator>& generators);
  FeatureDiagram Finish(std::size_t expected);

private:
  /// `birth` and `death` are squares. `error2` is the squared error at a squared radius.
  ShapeFeature Make(int dimension, TriangleId choke, SpaceSide side, double birth, double death,
    const std::function<double(double)>& error2) const
  {
    ShapeFeature feature;
    feature.Dimension = dimension;
    feature.Choke = choke;
    feature.Side = side;
    feature.PairBirth = std::sqrt(std::max(birth, 0.0));
    feature.PairDeath = std::sqrt(death);
    const double radius2 = dimension == 1 ? death : birth;
    feature.Error = std::sqrt(this->Context.SquaredError(this->F.TrianglePoints(choke), radius2));
    feature.FunctionError = this->Levels.UpTo(feature.PairDeath, side);
    // A handle or tunnel exists at birth, without an error.
    const double errors = (birth > 0.0 ? 2.0 : 1.0) * feature.FunctionError;
    feature.Trusted =
      death - birth > error2(birth) && feature.PairDeath - feature.PairBirth > errors;
    return feature;
  }

  const FeatureContext& Context;
  const CellFiltration& F;
  SpaceRegions& Regional;
  ErrorsByLevel Levels;
  std::vector<std::pair<ShapeFeature, std::vector<int>>> Found; ///< with the region
};

void Collector::AddVoids()
{
  std::map<std::vector<int>, std::size_t> own; // per bounded region: its deepest pair
  for (const TriangleId t : this->F.Triangles())
  {
    const TetrahedronId filler = this->Context.Pairs.VoidFilled(t);
    if (!filler.Exists())
    {
      continue;
    }
    const double birth = this->F.TriangleValue[t];
    const double death = this->F.TetrahedronValue[filler];
    if (!Differ(birth, death)) // most of all
    {
      continue;
    }
    const auto error2 = [&](double squared)
    {
      return std::max(this->Context.SquaredError(this->F.TrianglePoints(t), squared),
        this->Context.SquaredError(this->F.Tetrahedra[filler], squared));
    };
    if (death <= error2(0.0))
    {
      continue;
    }
    const std::vector<int>& region = this->Regional.Of(filler);
    ShapeFeature feature = this->Make(2, t, SpaceRegions::SideFrom(region), birth, death, error2);
    feature.Death = feature.PairDeath;
    feature.Kind = feature.Trusted ? FeatureKind::Additional : FeatureKind::Noise;
    this->Found.emplace_back(feature, region);
    if (!region.empty() && birth <= error2(0.0))
    {
      const auto best = own.emplace(region, this->Found.size() - 1).first;
      if (this->Found[best->second].first.PairDeath < feature.PairDeath)
      {
        best->second = this->Found.size() - 1;
      }
    }
  }
  for (const auto& entry : own)
  {
    this->Found[entry.second].first.Kind = FeatureKind::Noise;
  }
}

void Collector::AddLoops(const std::vector<SurfaceGenerator>& generators)
{
  std::map<TriangleId, const SurfaceGenerator*> byFiller;
  for (const SurfaceGenerator& g : generators)
  {
    byFiller[g.Filler] = &g;
  }
  for (const TriangleId t : this->F.Triangles())
  {
    const EdgeId closer = this->Context.Pairs.LoopClosed(t);
    if (!closer.Exists())
    {
      continue;
    }
    const auto generator = byFiller.find(t);
    const double death = this->F.TriangleValue[t];
    const double birth = generator != byFiller.end() ? 0.0 : this->F.EdgeValue[closer];
    if (generator == byFiller.end() && !Differ(birth, death)) // most of all
    {
      continue;
    }
    const auto error2 = [&](double squared)
    { return this->Context.SquaredError(this->F.TrianglePoints(t), squared); };
    if (generator == byFiller.end() && death <= error2(0.0))
    {
      continue;
    }
    const std::vector<int>& region = this->Regional.OfTriangle(t);
    ShapeFeature feature = this->Make(1, t, SpaceRegions::SideFrom(region), birth, death, error2);
    if (generator != byFiller.end())
    {
      feature.Kind = feature.Side == SpaceSide::Inside ? FeatureKind::Handle : FeatureKind::Tunnel;
      feature.Sum = generator->second->Sum;
    }
    this->Found.emplace_back(feature, region);
  }
}

FeatureDiagram Collector::Finish(std::size_t expected)
{
  FeatureDiagram diagram;
  diagram.ExpectedGenerators = expected;
  std::map<std::vector<int>, double> last; // per region: the last death
  // On a mesh the space is filled at the end whether or not the mesh is fine enough for features.
  const auto counts = [](const ShapeFeature& feature)
  { return feature.Trusted || feature.FunctionError > 0.0; };
  for (const auto& [feature, region] : this->Found)
  {
    double& reference = diagram.Reference[static_cast<std::size_t>(feature.Side)];
    reference = std::max(reference, counts(feature) ? feature.PairDeath : 0.0);
    double& death = last.emplace(region, 0.0).first->second;
    death = std::max(death, counts(feature) ? feature.PairDeath : 0.0);
  }
  for (auto& [feature, region] : this->Found)
  {
    if (feature.Dimension == 1)
    {
      feature.Death = std::max(last[region], feature.PairDeath);
    }
    diagram.Features.push_back(std::move(feature));
  }
  std::sort(diagram.Features.begin(), diagram.Features.end(),
    [](const ShapeFeature& a, const ShapeFeature& b)
    {
      return a.Radius() != b.Radius() ? a.Radius() < b.Radius()
        : a.Dimension != b.Dimension  ? a.Dimension < b.Dimension
                                      : a.Choke < b.Choke;
    });
  return diagram;
}

}

FeatureDiagram FindFeatures(
  const FeatureContext& context, SpaceRegions& regions, const ProgressCallback& progress)
{
  const std::vector<SurfaceGenerator> generators = SurfaceGenerators(context.Homology,
    context.Embedding, context.Filtration, context.Pairs, Between(progress, 0.0, 0.6));
  Collector collector(context, regions);
  Report(progress, 0.7);
  collector.AddVoids();
  Report(progress, 0.85);
  collector.AddLoops(generators);
  return collector.Finish(context.Homology.Rank());
}

// ------------------------------------------------------------------------------------------
// FeatureSelection
namespace
{

/// Gaps narrower than this part of the reference length do not count.
constexpr double NarrowestGap = 0.01;

double InUnitOfPoints(double length, LengthUnit unit, double reference)
{
  return unit == LengthUnit::Percent ? 0.01 * length * reference : length;
}

bool IsWantedKind(const FeatureSelection& selection, FeatureKind kind)
{
  switch (kind)
  {
    case FeatureKind::Handle:
      return selection.IncludeHandles;
    case FeatureKind::Tunnel:
      return selection.IncludeTunnels;
    case FeatureKind::Additional:
      return selection.IncludeBottlenecks;
    default:
      return false;
  }
}

bool IsWanted(const FeatureDiagram& diagram, const FeatureSelection& selection,
  const std::array<double, 2>& leastPersistence, const ShapeFeature& f)
{
  const auto side = static_cast<std::size_t>(f.Side);
  const double most =
    InUnitOfPoints(selection.MaximumRadius, selection.MaximumRadiusUnit, diagram.Reference[side]);
  const bool near = f.Radius() <= most * (1.0 + 1e-9);
  if (selection.Side ==
      (f.Side == SpaceSide::Inside ? SideSelection::Outside : SideSelection::Inside) ||
    (selection.TrustedOnly && !f.Trusted) || !IsWantedKind(selection, f.Kind))
  {
    return false;
  }
  return IsGenerator(f) ? near || selection.AlwaysIncludeHandles
                        : near && f.Persistence() >= leastPersistence[side];
}

}

PersistenceGap LargestGap(const FeatureDiagram& diagram, SpaceSide side)
{
  std::vector<double> bars{ 0.0 };
  for (const ShapeFeature& f : diagram.Features)
  {
    if (f.Side == side && f.Kind == FeatureKind::Additional)
    {
      bars.push_back(f.Persistence());
    }
  }
  std::sort(bars.begin(), bars.end(), std::greater<>());
  const double least = NarrowestGap * diagram.Reference[static_cast<std::size_t>(side)];
  PersistenceGap gap{ least, 0.0 };
  for (std::size_t i = 0; i + 1 < bars.size(); ++i)
  {
    const double width = bars[i] - bars[i + 1];
    if (width > std::max(gap.Width, least))
    {
      gap = { 0.5 * (bars[i] + bars[i + 1]), width };
    }
  }
  return gap;
}

std::vector<std::size_t> SelectFeatures(
  const FeatureDiagram& diagram, const FeatureSelection& selection)
{
  Check(selection);
  std::array<double, 2> least{};
  for (const SpaceSide side : { SpaceSide::Inside, SpaceSide::Outside })
  {
    const auto s = static_cast<std::size_t>(side);
    least[s] = selection.ThresholdMode == ThresholdMode::LargestGap
      ? LargestGap(diagram, side).Threshold
      : InUnitOfPoints(
          selection.MinimumPersistence, selection.MinimumPersistenceUnit, diagram.Reference[s]);
  }
  std::vector<std::size_t> chosen;
  for (std::size_t i = 0; i < diagram.Features.size(); ++i)
  {
    if (IsWanted(diagram, selection, least, diagram.Features[i]))
    {
      chosen.push_back(i);
    }
  }
  const auto most = static_cast<std::size_t>(selection.MaximumNumberOfLoops);
  if (most > 0 && chosen.size() > most)
  {
    std::stable_sort(chosen.begin(), chosen.end(),
      [&diagram](std::size_t a, std::size_t b)
      { return diagram.Features[a].Persistence() > diagram.Features[b].Persistence(); });
    chosen.resize(most);
    std::sort(chosen.begin(), chosen.end());
  }
  return chosen;
}

}
