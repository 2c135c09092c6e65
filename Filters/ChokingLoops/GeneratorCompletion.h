/**
 * @file GeneratorCompletion.h
 * @brief Handles and tunnels that the samples do not resolve, found on a tetrahedral mesh that
 * conforms to the surface.
 */
#ifndef isthmus_GeneratorCompletion_h
#define isthmus_GeneratorCompletion_h

#include "ChokingLoops/FeatureMembrane.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <optional>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Handles and tunnels of a surface from tetrahedra that have its triangles among their
// faces.

/// A handle or tunnel with the loop that it is and the membrane that fills it.
struct ConformingGenerator
{
  SpaceSide Side = SpaceSide::Inside;
  double Radius = 0.0; ///< at most this one is the true radius at which the loop is filled
  Point3 Centre{ 0.0, 0.0, 0.0 };
  Membrane Shape; ///< ids of the surface's points, then Extra
};

/**
 * Exactly g handles and g tunnels, whatever the distance of sheets: space is tetrahedralized by
 * TetGen without a new point on the surface M, the simplices of M enter first, the others by the
 * radius of the smallest ball round their corners, and M's loops are reduced over Z/2.
 *
 * M is part of the complex, so the kernel of H1(M) -> H1(side) is what is reduced, and that has
 * rank g on either side ("half lives, half dies"). Each membrane lies on its side of M. Points of a
 * triangle are no farther from its corners than the radius of its ball: hence the bound Radius.
 *
 * Per side ascending by Radius; loops of one side are independent in H1(M).
 * @pre `surface` has passed CheckedSurface() (SurfacePreparation.h).
 * @throws std::runtime_error or std::invalid_argument with a message when TetGen is missing, fails
 * or takes longer than two minutes; Cancelled. Time and memory: see MeshTetrahedra().
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<ConformingGenerator> ConformingGenerators(
  const SurfaceView& surface, const ProgressCallback& progress = {});

/**
 * A loop and membrane of `surface` on the same surface after SplitLongEdges()
 * (SurfacePreparation.h): each edge of M becomes the pieces that it was split into. `samples` keeps
 * the surface's points as its first ones.
 */
class SplitSurface
{
public:
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT SplitSurface(
    const SurfaceView& surface, const SurfaceAdjacency& samples);

  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Membrane Of(const Membrane& membrane) const;

private:
  bool IsSplit(SimplexId a, SimplexId b) const;
  void AddPieces(SimplexId a, SimplexId b, std::vector<SimplexId>& points) const;

  const SurfaceAdjacency& Samples;
  SurfaceAdjacency Original;
  std::map<Point3, SimplexId> Added; ///< the points that splitting made
};

// ------------------------------------------------------------------------------------------
// Handles and tunnels that the samples of a surface do not resolve, found on the surface.

/// How many handles and tunnels the samples do not settle: not above the sampling error, or without
/// a loop.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::size_t CountUnresolved(const LocatedFeatures& features);

inline bool AllResolved(const LocatedFeatures& features)
{
  return CountUnresolved(features) == 0;
}

/**
 * Completes handles and tunnels to g each, with loops, where sheets of M are nearer to each other
 * than the samples. ConformingGenerators() of `surface`, which was split into `context.Surface`,
 * give the classes that bound on each side. A generator that the samples settle stays if its class
 * is one of them; the others make way for conforming ones, ascending by radius, that are
 * independent of those that stay. These are not trusted: their true radius lies between 0 and
 * Radius().
 *
 * @throws what ConformingGenerators() throws; `features` is then as before.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void CompleteGenerators(const FeatureContext& context,
  const SurfaceView& surface, LocatedFeatures& features, const ProgressCallback& progress = {});

}

#endif
