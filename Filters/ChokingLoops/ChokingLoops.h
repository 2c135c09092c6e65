/**
 * @file ChokingLoops.h
 * @brief Every narrowing of a closed surface, inside and outside: handles, tunnels, bottlenecks.
 */
#ifndef isthmus_ChokingLoops_h
#define isthmus_ChokingLoops_h

#include "ChokingLoops/FeatureDiagram.h"
#include "ChokingLoops/FeatureMembrane.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <cstddef>
#include <functional>
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
  double LastRound = 0.0; ///< the part since the last sampling, which AnalysisCost estimates
};

/**
 * The cost of analysing the samples of a surface: filtration, pairs, features and the loops of
 * handles and tunnels. The cost of drawing selected features afterwards is estimated in
 * LoopDrawing.h.
 *
 * Bytes follow from counts alone. Seconds depend on the machine, its load and the shape, so they
 * are predicted after the samples are triangulated, as multiples of the time of that stage, which
 * reflects all three:
 * - all stages but the next take 3.2 and 0.006 for each class of loops. Those are medians of 25
 *   surfaces and contours; how hard the classes are to reduce (0 to 2.5 units, most on noisy
 *   contours) and whether radii need exact arithmetic (3 units more on flat pieces) depend on the
 *   shape and hardly change with finer sampling: from the second round on, the units of the
 *   previous round are used instead;
 * - where the samples do not resolve all handles and tunnels, the surface's own points are
 *   tetrahedralized and analysed as well (GeneratorCompletion.h), which takes 11.4 times as long
 *   per point. It is included in the estimate in the last round, and where the previous round left
 *   more than 64 unresolved; otherwise it is predicted once the features are known.
 *
 * Cross-validation (each of the 25 predicted with constants fitted to the other 24): estimates are
 * 0.53 to 1.28 of the actual CPU time.
 */
struct AnalysisCost
{
  std::size_t Samples = 0;
  std::size_t Rank = 0;       ///< of H1(M): twice the genus, all components together
  std::size_t Own = 0;        ///< the surface's own points, if GeneratorCompletion.h uses them
  double Bytes = 0.0;         ///< at the peak
  double Triangulation = 0.0; ///< its time in seconds
  double Units = 0.0;         ///< all stages but GeneratorCompletion.h, in triangulations
  double Seconds = -1.0;      ///< of the whole, triangulation included; below 0: not known yet

  /// With the time that the triangulation took.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT AnalysisCost After(double triangulation) const;

  /// Derives Units from the analysis of the same surface on fewer samples, which took `seconds`
  /// without GeneratorCompletion.h.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void LearnFrom(const AnalysisCost& before, double seconds);

  /// Includes the cost of GeneratorCompletion.h on the surface's own `points`.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void ExpectCompletion(std::size_t points);

  /// Its estimated time in seconds.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double Completion() const;
};

/// Cost of the samples of a closed surface, without the time. O(n).
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT AnalysisCost CostOf(const SurfaceView& samples);

/**
 * Whether that fits into `limit` bytes (0: the available memory). If not, `sentence` is an error
 * message that states the required memory and what to do.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool FitsMemory(
  const AnalysisCost& cost, double limit, std::string& sentence);

struct ChokingLoopParameters
{
  /// Edges of the surface are split until none is longer. In units of the data; 0: automatic, which
  /// spreads about 20,000 samples over the surface and refines where a feature cannot be
  /// distinguished from the sampling, as long as a round resolves at least half of such places.
  double SampleSpacing = 0.0;
  /// Analyse a surface even if it intersects itself. Numbers of handles and tunnels are then not
  /// guaranteed.
  bool AllowSelfIntersections = false;
  /// Memory limit of the analysis in bytes; 0: the available memory. An error is thrown if the
  /// samples do not fit; refinement that would not fit is skipped.
  double MemoryLimit = 0.0;
  /// Called with the estimated cost of the samples: before the work begins, and again, including
  /// the time, once they are triangulated; also after each refinement, and if handles or tunnels
  /// turn out not to be resolved by the samples (GeneratorCompletion.h).
  std::function<void(const AnalysisCost& cost)> Estimated;
};

struct ChokingAnalysis;

/**
 * The analysis of one surface. The constructor does the work; selecting features and computing a
 * membrane is fast, and membranes are cached. Membranes may be asked for on several threads at
 * once.
 */
class ChokingLoops
{
public:
  /**
   * Analyses `surface` on the Delaunay filtration of its samples. Coinciding points are merged,
   * points that no triangle uses are dropped. The orientation need not face outward. Needles,
   * double triangles, touching and crossing parts are repaired (SurfacePreparation.h, Repairs()).
   *
   * @throws std::invalid_argument for a surface that is not closed, consistently oriented and
   * finite, lies in a plane, cannot be repaired, or whose size is not between 1e-32 and 1e32;
   * std::runtime_error if it would need too many samples; Cancelled.
   *
   * Time is nearly linear: about 20 s and 1.5 GB for a million points, on two threads.
   */
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT explicit ChokingLoops(TriangleMesh surface,
    const ChokingLoopParameters& parameters = {}, const ProgressCallback& progress = {});

  /**
   * Analyses `surface` on the lower-star filtration of a function on a tetrahedral mesh on one or
   * both sides (thesis, 6.3.1): `values` at the mesh's points, in units of the data, 0 on the
   * surface. Every triangle of the surface must be a face of the mesh.
   *
   * `errors` at the mesh's points: how far the values are from the distance to the surface; none:
   * they are another function. Radii are known up to the error of the mesh (CellError).
   */
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ChokingLoops(const SurfaceView& surface,
    const TetrahedralMesh& mesh, const std::vector<double>& values,
    const std::optional<std::vector<double>>& errors, const ProgressCallback& progress = {});

  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ~ChokingLoops();
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ChokingLoops(ChokingLoops&&) noexcept;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ChokingLoops& operator=(ChokingLoops&&) noexcept;

  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const FeatureDiagram& Diagram() const;

  /// The surface, split as it was sampled: loops and membranes are lists of its points.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const TriangleMesh& Samples() const;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const SurfaceAdjacency& Adjacency() const;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const SurfaceHomology& Homology() const;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const ChokingLoopTimes& Times() const;

  /// The estimated cost of the work on these samples.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const AnalysisCost& Cost() const;

  /// The repairs of the surface before the analysis.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const RepairReport& Repairs() const;

  /// A message to the user about the result, in one or two sentences; empty if there is none.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const std::string& Remark() const;

  /// Largest sampling error anywhere, on a mesh the largest error of its function at a feature: the
  /// least radius that can be trusted everywhere.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double LargestError() const;

  /// Features of a selection, ascending by Radius(): indices into Diagram().Features.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<std::size_t> Select(
    const FeatureSelection& selection) const;

  /// Loops and membrane of a feature; computed on first use.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const Membrane& MembraneOf(std::size_t feature);

  /// The same for a feature whose membrane has been computed before.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const Membrane& MembraneOfMade(std::size_t feature) const;

  /// MinimumCutMembrane() of a feature, computed on first use; null if there is none, and for a
  /// handle or tunnel whose loops it could not replace (IsInterchangeable()).
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const Membrane* MinimumCutMembraneOf(
    std::size_t feature, const ProgressCallback& progress = {}, bool chords = false);

  /// GreedyMembrane() of a feature; nothing where there is none, and as with the minimum cut.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<Membrane> GreedyMembraneOf(
    std::size_t feature) const;

  /// EncirclingMembranes() of a feature.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<Membrane> EncirclingMembranesOf(
    std::size_t feature, double longest, std::size_t most = SIZE_MAX) const;

  /// ContactMembrane() of a feature.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::optional<Membrane> ContactMembraneOf(
    std::size_t feature, double longest) const;

  /// Points of the samples where the ball that gets stuck touches the surface.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<SimplexId> ContactsOf(std::size_t feature) const;

  /// Centre of the ball that gets stuck.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Point3 ChokePoint(std::size_t feature) const;

private:
  void AnalyseSamples(TriangleMesh samples, AnalysisCost cost,
    const ChokingLoopParameters& parameters, ChokingLoopTimes& times,
    const ProgressCallback& progress);
  void Complete(const ChokingLoopParameters& parameters, const SurfaceView& surface,
    std::size_t own, ChokingLoopTimes& times, const ProgressCallback& progress);

  std::unique_ptr<ChokingAnalysis> State;
};

}

#endif
