/**
 * @file GeneratorCompletion.h
 * @brief Handles and tunnels that the samples of a surface do not settle, found on the surface.
 */
#ifndef isthmus_GeneratorCompletion_h
#define isthmus_GeneratorCompletion_h

#include "ChokingLoops/FeatureMembrane.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

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

/// How many handles and tunnels the samples do not settle: not above the sampling error, or without
/// a loop.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::size_t CountUnsettled(const LocatedFeatures& features);

inline bool AllSettled(const LocatedFeatures& features)
{
  return CountUnsettled(features) == 0;
}

/**
 * True when the loops of another membrane may stand for those of a feature: always for additional
 * ones; for handles and tunnels when the two differ by a sum of the classes of those before it on
 * its side, so that all of them together stay independent, whichever are exchanged.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool IsInterchangeable(const FeatureContext& context,
  const LocatedFeatures& features, std::size_t feature, const Membrane& other);

/// The classes of loops that bound on a side: those of its handles, or of its tunnels.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT HomologySpan BoundingClasses(
  const FeatureContext& context, const LocatedFeatures& features, SpaceSide side);

/**
 * Makes handles and tunnels g each, with loops, where sheets of M are nearer to each other than the
 * samples. ConformingGenerators() of `surface`, which was split into `context.Surface`, give the
 * classes that bound on each side. A generator that the samples settle stays if its class is one of
 * them; the others make way for conforming ones, ascending by radius, that are independent of those
 * that stay. These are not trusted: their true radius lies between 0 and Distance().
 *
 * @throws what ConformingGenerators() throws; `features` is then as before.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void CompleteGenerators(const FeatureContext& context,
  const SurfaceView& surface, LocatedFeatures& features, const ProgressCallback& progress = {});

}

#endif
