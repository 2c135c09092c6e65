#include "ChokingLoops/GeneratorCompletion.h"

#include "ChokingLoops/ConformingGenerators.h"

#include <algorithm>
#include <functional>
#include <numeric>

namespace isthmus
{
namespace
{

bool IsSettled(const ShapeFeature& feature, const std::optional<Membrane>& membrane)
{
  return feature.Trusted && membrane && !membrane->Loops.empty();
}

/// The sum of the classes of a membrane's loops.
HomologyClass ClassOf(const FeatureContext& context, const Membrane& membrane)
{
  HomologyClass sum = context.Homology.ClassOf({});
  for (const auto& loop : membrane.Loops)
  {
    const HomologyClass c = context.Homology.ClassOf(LoopEdges(context.Surface, loop));
    std::transform(c.begin(), c.end(), sum.begin(), sum.begin(), std::bit_xor<>());
  }
  return sum;
}

ShapeFeature FeatureOf(const ConformingGenerator& generator, double reference)
{
  ShapeFeature feature;
  feature.Dimension = 1;
  feature.Side = generator.Side;
  feature.Kind = generator.Side == SpaceSide::Inside ? FeatureKind::Handle : FeatureKind::Tunnel;
  feature.Death = generator.Radius;
  feature.Error = generator.Radius;
  feature.Fill = std::max(generator.Radius, reference);
  return feature;
}

/// A copy in ascending order of Distance().
LocatedFeatures Sorted(const LocatedFeatures& features)
{
  const std::vector<ShapeFeature>& all = features.Diagram.Features;
  std::vector<std::size_t> order(all.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&all](std::size_t a, std::size_t b) { return all[a].Distance() < all[b].Distance(); });
  LocatedFeatures sorted;
  sorted.Diagram.Reference = features.Diagram.Reference;
  sorted.Diagram.ExpectedGenerators = features.Diagram.ExpectedGenerators;
  for (const std::size_t i : order)
  {
    sorted.Diagram.Features.push_back(all[i]);
    sorted.Membranes.push_back(features.Membranes[i]);
    sorted.Centres.push_back(features.Centres[i]);
  }
  return sorted;
}

}

std::size_t CountUnsettled(const LocatedFeatures& features)
{
  std::size_t count = 0;
  for (std::size_t i = 0; i < features.Membranes.size(); ++i)
  {
    const ShapeFeature& f = features.Diagram.Features[i];
    count += IsGenerator(f) && !IsSettled(f, features.Membranes[i]) ? 1 : 0;
  }
  return count;
}

bool IsInterchangeable(const FeatureContext& context, const LocatedFeatures& features,
  std::size_t feature, const Membrane& other)
{
  const ShapeFeature& f = features.Diagram.Features[feature];
  if (!IsGenerator(f) || !features.Membranes[feature])
  {
    return !IsGenerator(f);
  }
  HomologyClass difference = ClassOf(context, *features.Membranes[feature]);
  const HomologyClass c = ClassOf(context, other);
  std::transform(c.begin(), c.end(), difference.begin(), difference.begin(), std::bit_xor<>());
  HomologySpan before;
  for (std::size_t i = 0; i < feature; ++i)
  {
    const ShapeFeature& earlier = features.Diagram.Features[i];
    if (IsGenerator(earlier) && earlier.Side == f.Side && features.Membranes[i])
    {
      before.Add(ClassOf(context, *features.Membranes[i]));
    }
  }
  return before.Contains(difference);
}

HomologySpan BoundingClasses(
  const FeatureContext& context, const LocatedFeatures& features, SpaceSide side)
{
  HomologySpan span;
  for (std::size_t i = 0; i < features.Membranes.size(); ++i)
  {
    const ShapeFeature& f = features.Diagram.Features[i];
    if (IsGenerator(f) && f.Side == side && features.Membranes[i])
    {
      span.Add(ClassOf(context, *features.Membranes[i]));
    }
  }
  return span;
}

void CompleteGenerators(const FeatureContext& context, const SurfaceView& surface,
  LocatedFeatures& features, const ProgressCallback& progress)
{
  const std::vector<ConformingGenerator> conforming = ConformingGenerators(surface, progress);
  const SplitSurface split(surface, context.Surface);
  std::vector<Membrane> shapes;
  std::array<HomologySpan, 2> bounding; // the classes that bound on each side
  for (const ConformingGenerator& generator : conforming)
  {
    shapes.push_back(split.Of(generator.Shape));
    bounding[static_cast<std::size_t>(generator.Side)].Add(ClassOf(context, shapes.back()));
  }
  LocatedFeatures kept;
  kept.Diagram.Reference = features.Diagram.Reference;
  kept.Diagram.ExpectedGenerators = features.Diagram.ExpectedGenerators;
  const auto keep = [&kept](ShapeFeature f, std::optional<Membrane> membrane, const Point3& centre)
  {
    kept.Diagram.Features.push_back(std::move(f));
    kept.Membranes.push_back(std::move(membrane));
    kept.Centres.push_back(centre);
  };
  std::array<HomologySpan, 2> spans;
  for (std::size_t i = 0; i < features.Membranes.size(); ++i)
  {
    const ShapeFeature& f = features.Diagram.Features[i];
    const std::optional<Membrane>& membrane = features.Membranes[i];
    const auto side = static_cast<std::size_t>(f.Side);
    const auto isTrue = [&]
    {
      const HomologyClass c = ClassOf(context, *membrane);
      return bounding[side].Contains(c) && spans[side].Add(c);
    };
    if (!IsGenerator(f) || (IsSettled(f, membrane) && isTrue()))
    {
      keep(f, membrane, features.Centres[i]);
    }
  }
  for (std::size_t i = 0; i < conforming.size(); ++i)
  {
    const auto side = static_cast<std::size_t>(conforming[i].Side);
    if (spans[side].Add(ClassOf(context, shapes[i])))
    {
      keep(FeatureOf(conforming[i], kept.Diagram.Reference[side]), std::move(shapes[i]),
        conforming[i].Centre);
    }
  }
  features = Sorted(kept);
}

}
