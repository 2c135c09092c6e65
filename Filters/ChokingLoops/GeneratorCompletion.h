/**
 * @file GeneratorCompletion.h
 * @brief Handles and tunnels that the samples do not resolve, found on a tetrahedral mesh that
 * conforms to the surface.
 */
#ifndef isthmus_GeneratorCompletion_h
#define isthmus_GeneratorCompletion_h

#include "ChokingLoops/FeatureMembrane.h"
#include "Core/TetrahedralMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <atomic>
#include <future>
#include <optional>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Handles and tunnels of a surface from a tetrahedral mesh that contains its triangles as faces.

/// A handle or tunnel with its loop and the membrane that fills the loop.
struct ConformingGenerator
{
  SpaceSide Side = SpaceSide::Inside;
  double Radius = 0.0; ///< upper bound of the true radius at which the loop is filled
  Point3 Center{ 0.0, 0.0, 0.0 };
  Membrane Shape; ///< ids of the surface's points, then Extra
};

/**
 * TetGen's mesh of the space inside and outside a surface M, without points added on M. It is made
 * on a thread of its own, so that the caller can do other work meanwhile. Destroying the object
 * stops TetGen.
 * @pre `surface` has passed CheckedSurface() (SurfacePreparation.h) and outlives this object.
 */
class ConformingMesh
{
public:
  explicit ConformingMesh(const SurfaceView& surface);
  ~ConformingMesh();
  ConformingMesh(const ConformingMesh&) = delete;
  ConformingMesh& operator=(const ConformingMesh&) = delete;

  /// Waits for the mesh and returns it; can be called once.
  /// @throws std::runtime_error or std::invalid_argument with a message when TetGen is missing,
  /// fails or takes longer than two minutes; Cancelled.
  TetrahedralMesh Take(const ProgressCallback& progress);

private:
  std::atomic<double> Done{ 0.0 }; ///< what TetGen has done, in [0, 1]
  std::atomic<bool> Stopped{ false };
  std::future<TetrahedralMesh> Mesh;
};

/**
 * Finds exactly g handles and g tunnels, however close sheets of the surface M are: TetGen
 * tetrahedralizes the space without adding points on M; the simplices of M enter the filtration
 * first, the others by the radius of the smallest ball around their corners; then the loops of M
 * are reduced over Z/2.
 *
 * M is part of the complex, so the reduction computes the kernel of H1(M) -> H1(side), which has
 * rank g on either side ("half lives, half dies"). Each membrane lies on its side of M. Points of a
 * triangle are no farther from its corners than the radius of its ball, so Radius is an upper
 * bound.
 *
 * Results are sorted by Radius on each side; loops of one side are independent in H1(M).
 * @param mesh the mesh of `surface`, if it was started earlier; otherwise it is created here.
 * @pre `surface` has passed CheckedSurface() (SurfacePreparation.h).
 * @throws what ConformingMesh::Take() throws. Time and memory: see MeshTetrahedra().
 */
std::vector<ConformingGenerator> ConformingGenerators(const SurfaceView& surface,
  const ProgressCallback& progress = {}, ConformingMesh* mesh = nullptr);

/**
 * Transfers a loop and membrane of `surface` to the same surface after SplitLongEdges()
 * (SurfacePreparation.h): each edge of M is replaced by the pieces into which it was split. The
 * first points of `samples` are those of the surface.
 */
class SplitSurface
{
public:
  SplitSurface(const SurfaceView& surface, const SurfaceAdjacency& samples);

  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Membrane Of(const Membrane& membrane) const;

private:
  bool IsSplit(SimplexId a, SimplexId b) const;
  void AddPieces(SimplexId a, SimplexId b, std::vector<SimplexId>& points) const;

  const SurfaceAdjacency& Samples;
  SurfaceAdjacency Original;
  std::map<Point3, SimplexId> Added; ///< the points added by splitting
};

// ------------------------------------------------------------------------------------------
// Handles and tunnels that the samples do not resolve, found on the original surface.

/// Number of handles and tunnels that the samples do not resolve: those not above the sampling
/// error, or without a loop.
std::size_t CountUnresolved(const LocatedFeatures& features);

inline bool AllResolved(const LocatedFeatures& features)
{
  return CountUnresolved(features) == 0;
}

/**
 * Completes handles and tunnels to g each, with loops, where sheets of M are closer to each other
 * than the samples. ConformingGenerators() of `surface`, which was split into `context.Surface`,
 * provide the classes that bound on each side. A generator resolved by the samples is kept if its
 * class is one of them; the others are replaced by conforming generators, in order of radius, that
 * are independent of those kept. The replacements are not trusted: their true radius lies between 0
 * and Radius().
 *
 * @param mesh as for ConformingGenerators().
 * @throws what ConformingGenerators() throws; `features` is then as before.
 */
void CompleteGenerators(const FeatureContext& context, const SurfaceView& surface,
  LocatedFeatures& features, const ProgressCallback& progress = {}, ConformingMesh* mesh = nullptr);

}

#endif
