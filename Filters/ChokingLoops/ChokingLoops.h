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
  double LastRound = 0.0; ///< of these, from the last sampling on: what AnalysisCost estimates
};

/**
 * The cost of analysing the samples of a surface: filtration, pairs, features and the loops of
 * handles and tunnels. What is drawn afterwards for a choice of features: LoopDrawing.h.
 *
 * Bytes follow from counts alone. Seconds depend on the machine, on what else runs on it and on the
 * shape, so they are predicted once the samples are triangulated, in units of that stage, which has
 * met all three:
 * - all stages but the next take 3.2 and 0.006 for each class of loops. Those are medians of 25
 *   surfaces and contours; how hard the classes are to reduce (0 to 2.5 units, most on noisy
 *   contours) and whether radii need exact arithmetic (3 units more on flat pieces) is the shape's,
 *   and hardly changes as it is sampled more finely: from the second round on, the units that the
 *   round before took are taken instead;
 * - where the samples do not settle all handles and tunnels, the surface's own points are
 *   tetrahedralized and analysed as well (GeneratorCompletion.h): 11.4 times as long a point. That
 *   is expected in the last round, and where more than 64 were not settled by the round before;
 * else it is predicted once the features are known.
 *
 * Each of the 25 predicted with constants fitted to the other 24: 0.53 to 1.28 of what it took (CPU
 * seconds).
 */
struct AnalysisCost
{
  std::size_t Samples = 0;
  std::size_t Rank = 0;       ///< of H1(M): twice the genus, all components together
  std::size_t Own = 0;        ///< the surface's own points, where handles are to be found on them
  double Bytes = 0.0;         ///< at the peak
  double Triangulation = 0.0; ///< seconds that it took
  double Units = 0.0;         ///< all stages but GeneratorCompletion.h, in triangulations
  double Seconds = -1.0;      ///< of the whole, triangulation included; below 0: not known yet

  /// With the time that the triangulation took.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT AnalysisCost After(double triangulation) const;

  /// Takes over Units from the same surface on fewer samples, which took so long without
  /// GeneratorCompletion.h.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void LearnFrom(const AnalysisCost& before, double seconds);

  /// Handles or tunnels are to be found on the surface's own points.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void ExpectCompletion(std::size_t points);

  /// Seconds that this takes.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double Completion() const;
};

/// Cost of the samples of a closed surface, without the time. O(n).
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT AnalysisCost CostOf(const SurfaceView& samples);

/**
 * Whether that fits into `limit` bytes (0: what is available). If not, `sentence` says what it
 * would take and what to do.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT bool FitsMemory(
  const AnalysisCost& cost, double limit, std::string& sentence);

struct ChokingLoopParameters
{
  /// Edges of the surface are split until none is longer. In units of the data; 0: automatic, which
  /// spreads some 20,000 samples over the surface and refines where a feature can't be told from
  /// the sampling, as long as that settles half of such places.
  double SampleSpacing = 0.0;
  /// Go on with a surface that crosses itself. Counts of handles and tunnels are then not assured.
  bool AllowSelfIntersections = false;
  /// Bytes that the analysis may take; 0: what is available. More samples than fit end in a
  /// sentence; refinement that would not fit is left out.
  double MemoryLimit = 0.0;
  /// Called with what the work on the samples takes: before it begins, and with the time, too, once
  /// they are triangulated. Again when they are refined, and when handles or tunnels turn out not
  /// to be settled by them (GeneratorCompletion.h).
  std::function<void(const AnalysisCost& cost)> Estimated;
};

struct ChokingAnalysis;

/**
 * The analysis of one surface. Building it is the work; selecting and asking for a membrane is
 * quick, and membranes are kept once made.
 */
class ChokingLoops
{
public:
  /**
   * Analyses `surface` on the Delaunay filtration of its samples. Coinciding points are merged,
   * points that no triangle uses are left out. Orientation is not needed to face outward. Needles,
   * double triangles, touching and crossing parts are repaired (SurfacePreparation.h, Repairs()).
   *
   * @throws std::invalid_argument with a sentence for a surface that is not closed, consistently
   * oriented and finite, lies in a plane, can't be repaired, or whose size is not between 1e-32 and
   * 1e32; std::runtime_error when it would take too many samples; Cancelled.
   *
   * Time is near linear: some 20 s and 1.5 GB for a million points, on two threads.
   */
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT explicit ChokingLoops(TriangleMesh surface,
    const ChokingLoopParameters& parameters = {}, const ProgressCallback& progress = {});

  /**
   * Analyses `surface` on the lower-star filtration of a function on a tetrahedral mesh of one side
   * or both (thesis, 6.3.1): `values` at the mesh's points, in units of the data, 0 on the surface.
   * Every triangle of the surface must be a face of the mesh.
   */
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ChokingLoops(const SurfaceView& surface,
    const TetrahedralMesh& mesh, const std::vector<double>& values,
    const ProgressCallback& progress = {});

  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ~ChokingLoops();
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ChokingLoops(ChokingLoops&&) noexcept;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT ChokingLoops& operator=(ChokingLoops&&) noexcept;

  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const FeatureDiagram& Diagram() const;

  /// The surface, split as it was sampled: loops and membranes are lists of its points.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const TriangleMesh& Samples() const;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const SurfaceAdjacency& Adjacency() const;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const SurfaceHomology& Homology() const;
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const ChokingLoopTimes& Times() const;

  /// What the work on these samples was estimated to take.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const AnalysisCost& Cost() const;

  /// What was repaired of the surface before.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const RepairReport& Repairs() const;

  /// What the user should know about the result: a sentence or two, or nothing.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const std::string& Remark() const;

  /// Largest sampling error anywhere: the least radius that can be trusted everywhere.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT double LargestError() const;

  /// Features of a selection, ascending by Radius(): indices into Diagram().Features.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<std::size_t> Select(
    const FeatureSelection& selection) const;

  /// Loops and membrane of a feature. Made when first asked for.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const Membrane& MembraneOf(std::size_t feature);

  /// The same, of one that has been asked for before.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const Membrane& MembraneOfMade(std::size_t feature) const;

  /// MinimumCutMembrane() of a feature, found when first asked for; null where there is none, and
  /// for a handle or tunnel whose loops it could not stand for (IsInterchangeable()).
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const Membrane* MinimumCutMembraneOf(
    std::size_t feature, const ProgressCallback& progress = {});

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
