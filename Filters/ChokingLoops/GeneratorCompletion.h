/**
 * @file GeneratorCompletion.h
 * @brief Handles and tunnels that the samples of a surface do not settle, found on the surface.
 */
#ifndef isthmus_GeneratorCompletion_h
#define isthmus_GeneratorCompletion_h

#include "FeatureMembrane.h"

#include <optional>

namespace isthmus
{

/// A diagram, and for each of its features what spans it and where it is.
struct LocatedFeatures
{
  FeatureDiagram Diagram;
  std::vector<std::optional<Membrane>> Membranes; ///< made for handles and tunnels, else when asked
  std::vector<Point3> Centres;                    ///< of the ball that gets stuck
};

inline bool IsGenerator(const ShapeFeature& feature)
{
  return feature.Kind == FeatureKind::Handle || feature.Kind == FeatureKind::Tunnel;
}

/// True when the samples settle all handles and tunnels: above the sampling error, with a loop.
VTKISTHMUS_EXPORT bool AllSettled(const LocatedFeatures& features);

/**
 * Makes handles and tunnels g each, with loops, where sheets of M are nearer to each other than the
 * samples. ConformingGenerators() of `surface`, which was split into `context.Surface`, give the
 * classes that bound on each side. A generator that the samples settle stays if its class is one of
 * them; the others make way for conforming ones, ascending by radius, that are independent of those
 * that stay. These are not trusted: their true radius lies between 0 and Distance().
 *
 * @throws what ConformingGenerators() throws; `features` is then as before.
 */
VTKISTHMUS_EXPORT void CompleteGenerators(const FeatureContext& context,
  const TriangleMesh& surface, LocatedFeatures& features, const ProgressCallback& progress = {});

}

#endif
