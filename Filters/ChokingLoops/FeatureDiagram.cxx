#include "ChokingLoops/FeatureDiagram.h"

#include "ChokingLoops/SpaceRegions.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace isthmus
{
namespace
{

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
  {
  }

  void AddVoids();
  void AddLoops(const std::vector<SurfaceGenerator>& generators);
  FeatureDiagram Finish(std::size_t expected);

private:
  ShapeFeature Make(
    int dimension, TriangleId choke, double birth, double death, double error2) const
  {
    ShapeFeature feature;
    feature.Dimension = dimension;
    feature.Choke = choke;
    feature.Birth = std::sqrt(std::max(birth, 0.0));
    feature.Death = std::sqrt(death);
    feature.Error = std::sqrt(error2);
    feature.Trusted = death - birth > error2;
    return feature;
  }

  const FeatureContext& Context;
  const CellFiltration& F;
  SpaceRegions& Regional;
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
    const double error2 = std::max(this->Context.SquaredError(this->F.TrianglePoints(t)),
      this->Context.SquaredError(this->F.Tetrahedra[filler]));
    if (death <= error2)
    {
      continue;
    }
    const std::vector<int>& region = this->Regional.Of(filler);
    ShapeFeature feature = this->Make(2, t, birth, death, error2);
    feature.Side = SpaceRegions::SideOf(region);
    feature.Fill = feature.Death;
    feature.Kind = feature.Trusted ? FeatureKind::Additional : FeatureKind::Noise;
    this->Found.emplace_back(feature, region);
    if (!region.empty() && birth <= error2)
    {
      const auto best = own.emplace(region, this->Found.size() - 1).first;
      if (this->Found[best->second].first.Death < feature.Death)
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
    const double error2 = this->Context.SquaredError(this->F.TrianglePoints(t));
    if (generator == byFiller.end() && death <= error2)
    {
      continue;
    }
    const std::vector<int>& region = this->Regional.OfTriangle(t);
    ShapeFeature feature = this->Make(1, t, birth, death, error2);
    feature.Side = SpaceRegions::SideOf(region);
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
  std::map<std::vector<int>, double> fill; // per region: the last thing filled
  for (const auto& [feature, region] : this->Found)
  {
    double& reference = diagram.Reference[static_cast<std::size_t>(feature.Side)];
    reference = std::max(reference, feature.Trusted ? feature.Death : 0.0);
    double& last = fill.emplace(region, 0.0).first->second;
    last = std::max(last, feature.Trusted ? feature.Death : 0.0);
  }
  for (auto& [feature, region] : this->Found)
  {
    if (feature.Dimension == 1)
    {
      feature.Fill = std::max(fill[region], feature.Death);
    }
    diagram.Features.push_back(std::move(feature));
  }
  std::sort(diagram.Features.begin(), diagram.Features.end(),
    [](const ShapeFeature& a, const ShapeFeature& b)
    {
      return a.Distance() != b.Distance() ? a.Distance() < b.Distance()
        : a.Dimension != b.Dimension      ? a.Dimension < b.Dimension
                                          : a.Choke < b.Choke;
    });
  return diagram;
}

}

FeatureDiagram ShapeFeatures(
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

}
