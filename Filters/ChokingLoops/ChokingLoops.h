/**
 * @file ChokingLoops.h
 * @brief Every narrowing of a closed surface, inside and outside: handles, tunnels, bottlenecks.
 */
#ifndef isthmus_ChokingLoops_h
#define isthmus_ChokingLoops_h

#include "ChokingLoops/AdaptiveSamples.h"
#include "ChokingLoops/ChokingLoopParameters.h"
#include "ChokingLoops/FeatureDiagram.h"
#include "ChokingLoops/FeatureMembrane.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>

namespace isthmus
{

/// Times of the stages, in seconds.
struct ChokingLoopTimes
{
  double Check = 0.0;
  double Sampling = 0.0;
  double Filtration = 0.0;
  double Pairing = 0.0;
  double Features = 0.0;
};

struct ChokingAnalysis;

/**
 * The analysis of one surface. The constructor does the work; selecting features and computing a
 * membrane is fast, and membranes are cached. Membranes may be requested on several threads at
 * once.
 */
class ChokingLoops
{
public:
  /**
   * Analyses `surface` on the Delaunay filtration of its samples. Coinciding points are merged, and
   * points that no triangle uses are dropped. The surface need not be oriented outward. Needles,
   * double triangles, and parts that touch or cross are repaired (SurfacePreparation.h, Repairs()).
   *
   * @throws std::invalid_argument for a surface that is not closed, consistently oriented and
   * finite, that lies in a plane or cannot be repaired, or whose size is not between 1e-32 and
   * 1e32; std::runtime_error if it would need too many samples; Cancelled.
   *
   * Time is nearly linear: about 20 s and 1.5 GB for a million points, on two threads.
   */
  explicit ChokingLoops(TriangleMesh surface, const ChokingLoopParameters& parameters = {},
    const ProgressCallback& progress = {});

  /**
   * Analyses `surface` on the lower-star filtration of a function on a tetrahedral mesh on one or
   * both sides (thesis, 6.3.1): `values` at the mesh's points, in units of the data, 0 on the
   * surface. Every triangle of the surface must be a face of the mesh.
   *
   * `errors` at the mesh's points: how far the values may deviate from the distance to the surface;
   * without errors, the values are taken as a function of another kind. Radii are known up to the
   * error of the mesh (CellError).
   */
  ChokingLoops(const SurfaceView& surface, const TetrahedralMesh& mesh,
    const std::vector<double>& values, const std::optional<std::vector<double>>& errors,
    const ProgressCallback& progress = {});

  ~ChokingLoops();
  ChokingLoops(ChokingLoops&&) noexcept;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ChokingLoops& operator=(ChokingLoops&&) noexcept;

  const FeatureDiagram& Diagram() const;

  /// The samples and their triangles: the surface after splitting, or a coarser one of its points
  /// (Fine()). Loops and membranes refer to its points.
  const TriangleMesh& Samples() const;

  /// The surface itself if it has more points than its samples, otherwise null; and the point of it
  /// that a sample is.
  const FineSurface* Fine() const;
  SimplexId PointOfFine(SimplexId sample) const;

  const SurfaceAdjacency& Adjacency() const;
  const SurfaceHomology& Homology() const;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const ChokingLoopTimes& Times() const;

  /// The repairs of the surface before the analysis.
  const RepairReport& Repairs() const;

  /// A message to the user about the result, in one or two sentences; empty if there is none.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const std::string& Remark() const;

  /// The largest sampling error anywhere, or, on a mesh, the largest error of the function at any
  /// feature: the smallest radius that can be trusted everywhere.
  double LargestError() const;

  /// Features of a selection, ascending by Radius(): indices into Diagram().Features.
  std::vector<std::size_t> Select(const FeatureSelection& selection) const;

  /// Loops and membrane of a feature; computed on first use.
  const Membrane& GetMembrane(std::size_t feature);

  /// The same for a feature whose membrane is already computed.
  const Membrane& GetExistingMembrane(std::size_t feature) const;

  /// MinimumCutMembrane() of a feature, computed on first use; null if there is none, or if the
  /// feature is a handle or tunnel whose loops the cut cannot replace (IsInterchangeable()).
  const Membrane* GetMinimumCutMembrane(
    std::size_t feature, const ProgressCallback& progress = {}, bool chords = false);

  /// GreedyMembrane() of a feature; empty in those cases in which GetMinimumCutMembrane() is null.
  std::optional<Membrane> ComputeGreedyMembrane(std::size_t feature) const;

  /// EncirclingMembranes() of a feature.
  std::vector<Membrane> ComputeEncirclingMembranes(
    std::size_t feature, double longest, std::size_t most = SIZE_MAX) const;

  /// ContactMembrane() of a feature.
  std::optional<Membrane> ComputeContactMembrane(std::size_t feature, double longest) const;

  /// Points of the samples where the ball that gets stuck touches the surface.
  std::vector<SimplexId> GetContacts(std::size_t feature) const;

  /// Center of the ball that gets stuck.
  Point3 ChokePoint(std::size_t feature) const;

private:
  void AnalyseSamples(
    SurfaceSamples samples, ChokingLoopTimes& times, const ProgressCallback& progress);

  std::unique_ptr<ChokingAnalysis> State;
};

}

#endif
