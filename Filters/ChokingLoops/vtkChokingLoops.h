/**
 * @class vtkChokingLoops
 * @brief Finds every narrowing of a closed surface: handles, tunnels, and other bottlenecks.
 *
 * A ball that rolls inside the surface, or outside of it, gets stuck where the space is narrow.
 * Each such place is a choke point with a radius (`Radius`); the loop around it, on the surface,
 * bounds a membrane through it. Handles (a loop that bounds inside but not on the surface) and
 * tunnels (a loop that bounds outside) are found in exactly the number that homology requires, g of
 * each for genus g. Other narrowings, such as the neck of a bunny or the pores of a shell, are
 * found by the persistence of the voids behind them.
 *
 * Source: X. Feng, PhD thesis, chapter 6. The filtration is the alpha complex of samples of the
 * surface (H. Edelsbrunner, Discrete Comput. Geom. 13, 1995), which is exact for the offsets of the
 * samples, or that of the thesis, by a function on a tetrahedral mesh.
 *
 * Input 0: closed triangulated surfaces (vtkPolyData), any genus, any number of components,
 * cavities included, with any consistent orientation. Input 1, optional: a tetrahedral mesh
 * (vtkUnstructuredGrid) of one side or both that has the surface's triangles among its faces, for
 * TetrahedralMesh.
 *
 * Outputs:
 *  0. loops: closed polylines on the surface. Cell arrays:
 *     - `Kind` (0 handle, 1 tunnel, 2 additional), `KindName`, `Side` (0 inside, 1 outside)
 *     - `Radius`: of the ball that gets stuck
 *     - `Birth`: equal to `Radius`
 *     - `Death`: radius at which the space behind the narrowing is filled
 *     - `Persistence`: Death - Birth
 *     - `Uncertainty`: the true radius lies in [Radius - Uncertainty, Radius]; with TetrahedralMesh
 *       in [Radius - Uncertainty, Radius + Uncertainty], since the distance is known only at the
 *       points of the mesh. It is 0.61 times the longest edge of the tetrahedra on the same side
 *       that come that close to the surface (with PointArray: the largest range of the array within
 *       one of them)
 *     - `Trusted`: 1 for a feature of the surface, 0 if it may be caused by the sampling
 *     - `Length`
 *     - `Reach`: of the feature, distance of its loops' farthest point from the choke point, in
 *       radii: 1 for a round neck
 *     - `FeatureId`, `Component`
 *     - `SharedWith`: if several narrowings have the same loop, such as the windows of a wall: the
 *       `FeatureId` of the first of them, whose points the cells of the others use; otherwise -1
 *
 *     A feature may have several loops, for example if its membrane is an annulus.
 *  1. membranes: triangles spanning each loop, cell arrays `FeatureId`, `Area` (of the membrane),
 *     `Radius`, `Birth`, `Death`, `Persistence`, `Kind`; if MembraneMethod is not Automatic also
 *     `Method` (the method by which the membrane was computed: 0 if the chosen method found none),
 *     and with Greedy `GrowthCost` (sum of the path costs of the growth, in the unit of the points,
 *     before shortening; 0 for another method).
 *  2. choke points: one vertex for a feature, point arrays `Radius`, `Birth`, `Death`,
 *     `Persistence`, `Kind`, `Side`, `FeatureId`.
 *  3. persistence diagram: a vtkTable with `FeatureId`, `Dimension`, `Side`, `Birth`, `Death`,
 *     `Persistence`, `Radius`, `Kind` (3: noise, or the surface itself). A bar and its loops have
 *     the same `FeatureId`, so selecting one shows the other. Rows of dimension 2 (additional
 *     loops) have the same birth and death as their loops. Rows of dimension 1 (handles and
 *     tunnels) are the class of the loop on the surface: birth 0, death `Radius`.
 *
 * Birth, death and persistence are defined once, in FeatureDiagram.h (ShapeFeature).
 *
 * **Deprecated, removed in 1.1.0:** the arrays `Fill` (now `Death`) and `Widening` (`Persistence`)
 * of the loops, and `Distance` (`Radius`) of loops and membranes. They are still there, with the
 * same values; an array cannot issue a warning when it is read. Deprecated methods:
 * SetMaximumDistance() and SetMaximumDistanceUnit(), now SetMaximumRadius() and
 * SetMaximumRadiusUnit().
 *
 * Lengths are in the unit of the points, areas in its square. Field data of output 0:
 * `NumberOfSamples`, `LargestSamplingError`, `ReferenceLength` (inside, outside),
 * `NumberOfHandles`, `NumberOfTunnels`, `NumberOfAdditionalLoops` (inside, outside; features, each
 * counted once, however many loops it has), `NumberOfFeatures` (selected by Side and the
 * thresholds), `NumberOfUntrustedFeatures` (those of them that are not trusted),
 * `NumberOfShownFeatures` (those of them that remain after MaximumNumberOfLoops, TrustedOnly,
 * MaximumLength and MaximumReach), `ProposedThreshold` (inside, outside: the persistence at the
 * middle of the side's largest gap, and the width of the gap, 0 if there is none; in the unit of
 * the points).
 *
 * Needles, double triangles, and parts that touch or cross are repaired if this changes the volume
 * by at most 1 %. The repair is reported by a warning and by the field data `Repaired` (number of
 * triangles changed) and `RepairedPlaces` (their centres) of output 0. A surface that is not
 * closed, consistently oriented and finite, or that cannot be repaired, causes an error that names
 * triangles, and the outputs are empty. Handles and tunnels narrower than the sampling error are
 * found on a TetGen mesh of both sides; a warning then says that their `Radius` is an upper bound,
 * or, if TetGen fails, that their number and side are not guaranteed.
 *
 * The analysis is cached: changes of thresholds, side and shortening do not repeat it. Time is
 * nearly linear, about 30 s and 2.5 GB for a million points on two threads; loops and membranes
 * take little additional time.
 */
#ifndef vtkChokingLoops_h
#define vtkChokingLoops_h

#include "Core/Deprecation.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory>
#include <string>
#include <vector>

class vtkUnstructuredGrid;

namespace isthmus
{
class ChokingLoops;
struct FeatureSelection;
struct ShownFeature;
struct SurfaceView;
struct TetrahedralMesh;
struct TriangleMesh;
}

class VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT vtkChokingLoops : public vtkPolyDataAlgorithm
{
public:
  static vtkChokingLoops* New();
  vtkTypeMacro(vtkChokingLoops, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SideType
  {
    Inside,
    Outside,
    Both
  };
  enum FiltrationType
  {
    Delaunay,
    TetrahedralMesh
  };
  enum MorseFunctionType
  {
    ClosestPoint,
    EdgePaths,
    GridDistance,
    PointArray,
    FastMarching
  };
  enum ShorteningType
  {
    None,
    Rounds,
    Geodesic
  };
  enum MembraneMethodType
  {
    Automatic,
    MinimumCut,
    Greedy
  };
  enum ThresholdModeType
  {
    Given,
    LargestGap
  };
  enum UnitType
  {
    Percent,
    Absolute
  };

  ///@{
  /// Which side of the surface to search: Inside, Outside or Both (default).
  vtkSetClampMacro(Side, int, Inside, Both);
  vtkGetMacro(Side, int);
  ///@}

  ///@{
  /// Report narrowings up to this radius: in percent of the side's reference length, the largest
  /// radius at which anything on that side is filled, or in the unit of the points. Default 100 %.
  vtkSetMacro(MaximumRadius, double);
  vtkGetMacro(MaximumRadius, double);
  vtkSetClampMacro(MaximumRadiusUnit, int, Percent, Absolute);
  vtkGetMacro(MaximumRadiusUnit, int);
  ISTHMUS_DEPRECATED("1.0.0", "use SetMaximumRadius")
  void SetMaximumDistance(double radius) { this->SetMaximumRadius(radius); }
  ISTHMUS_DEPRECATED("1.0.0", "use GetMaximumRadius")
  double GetMaximumDistance() { return this->GetMaximumRadius(); }
  ISTHMUS_DEPRECATED("1.0.0", "use SetMaximumRadiusUnit")
  void SetMaximumDistanceUnit(int unit) { this->SetMaximumRadiusUnit(unit); }
  ISTHMUS_DEPRECATED("1.0.0", "use GetMaximumRadiusUnit")
  int GetMaximumDistanceUnit() { return this->GetMaximumRadiusUnit(); }
  ///@}

  ///@{
  /// Report additional loops of at least this persistence: in percent of the side's reference
  /// length or in the unit of the points. Default 5 %.
  vtkSetMacro(MinimumPersistence, double);
  vtkGetMacro(MinimumPersistence, double);
  vtkSetClampMacro(MinimumPersistenceUnit, int, Percent, Absolute);
  vtkGetMacro(MinimumPersistenceUnit, int);
  ///@}

  ///@{
  /// Given (default): MinimumPersistence separates additional loops from noise. LargestGap: the
  /// largest gap of each side's diagram separates them (field data `ProposedThreshold`). Gaps
  /// narrower than 1 % of the reference length are ignored; if no gap is wider, the threshold is
  /// that 1 %.
  vtkSetClampMacro(ThresholdMode, int, Given, LargestGap);
  vtkGetMacro(ThresholdMode, int);
  ///@}

  ///@{
  /// Report at most this many features, those of the largest persistence. 0 (default): all.
  vtkSetClampMacro(MaximumNumberOfLoops, int, 0, VTK_INT_MAX);
  vtkGetMacro(MaximumNumberOfLoops, int);
  ///@}

  ///@{
  /// Drop features of any kind with a loop longer than this, in the unit of the points. 0
  /// (default): no limit.
  vtkSetMacro(MaximumLength, double);
  vtkGetMacro(MaximumLength, double);
  ///@}

  ///@{
  /// Drop features of any kind whose loops extend farther than this from the choke point, in radii
  /// (the cell array `Reach`: 1 for a round neck, large for a slot). 0 (default): no limit.
  vtkSetMacro(MaximumReach, double);
  vtkGetMacro(MaximumReach, double);
  ///@}

  ///@{
  /// Drop features that may be caused by the sampling (cell array `Trusted` is 0). Default off.
  vtkSetMacro(TrustedOnly, bool);
  vtkGetMacro(TrustedOnly, bool);
  vtkBooleanMacro(TrustedOnly, bool);
  ///@}

  enum LoopOrderType
  {
    ByRadius,
    ByLength
  };

  ///@{
  /// Sort order of the features in the outputs, ascending. Default ByRadius.
  vtkSetClampMacro(LoopOrder, int, ByRadius, ByLength);
  vtkGetMacro(LoopOrder, int);
  ///@}

  ///@{
  /// Report handles and tunnels whatever MaximumRadius says. Default on.
  vtkSetMacro(AlwaysReportHandles, bool);
  vtkGetMacro(AlwaysReportHandles, bool);
  vtkBooleanMacro(AlwaysReportHandles, bool);
  ///@}

  ///@{
  /// Delaunay (default): the alpha complex of samples of the surface, exact. TetrahedralMesh: the
  /// lower-star filtration (thesis, 6.3.1) of MorseFunction on the mesh of input 1, or on one of
  /// about 200,000 tetrahedra that TetGen creates inside the filter, with the surface's triangles
  /// split to their size. Narrowings within the error of the mesh are not reported, with a warning.
  vtkSetClampMacro(Filtration, int, Delaunay, TetrahedralMesh);
  vtkGetMacro(Filtration, int);
  ///@}

  ///@{
  /// With TetrahedralMesh: ClosestPoint (default), the exact distance to the surface; EdgePaths,
  /// the shortest way along edges of the mesh (Dijkstra); GridDistance, the exact distance at the
  /// nodes of a regular grid, sampled trilinearly; PointArray, the array MorseArrayName of input 1;
  /// FastMarching, the distance computed on that grid by fast marching from the surface, sampled
  /// trilinearly.
  vtkSetClampMacro(MorseFunction, int, ClosestPoint, FastMarching);
  vtkGetMacro(MorseFunction, int);
  ///@}

  ///@{
  /// Point array of input 1 for MorseFunction PointArray: not negative, 0 on the surface. Default:
  /// none.
  vtkSetMacro(MorseArrayName, std::string);
  vtkGetMacro(MorseArrayName, std::string);
  ///@}

  ///@{
  /// Edges of the surface are split until none is longer than this, in the unit of the points. 0
  /// (default): automatic, about 20,000 samples, and more if a feature is too small for them.
  vtkSetMacro(SampleSpacing, double);
  vtkGetMacro(SampleSpacing, double);
  ///@}

  ///@{
  /// None: loops run along edges. Rounds: ShorteningRounds rounds of shortening on the surface.
  /// Geodesic (default): until no loop gets shorter.
  vtkSetClampMacro(Shortening, int, None, Geodesic);
  vtkGetMacro(Shortening, int);
  vtkSetClampMacro(ShorteningRounds, int, 1, 1000);
  vtkGetMacro(ShorteningRounds, int);
  ///@}

  ///@{
  /// Which membrane spans a choke; its boundary is the loop that is shortened. Automatic (default):
  /// the membrane closed by the filtration, or another one if its loop does not belong to the choke
  /// point. MinimumCut: the membrane of least area through the choke triangle. Greedy, with
  /// TetrahedralMesh only: grown from the choke triangle down to the surface in steps of least cost
  /// (thesis, 6.3.2; MinimumCutMembrane.h). If a method finds no membrane, the automatic one is
  /// used, and the cell array `Method` of the membranes is 0.
  vtkSetClampMacro(MembraneMethod, int, Automatic, Greedy);
  vtkGetMacro(MembraneMethod, int);
  ///@}

  ///@{
  /// Analyse a surface even if it intersects itself, with a warning. Default off.
  vtkSetMacro(AllowSelfIntersections, bool);
  vtkGetMacro(AllowSelfIntersections, bool);
  vtkBooleanMacro(AllowSelfIntersections, bool);
  ///@}

  ///@{
  /// Close holes of the surface, planar or not, before the search. Default off.
  vtkSetMacro(CapHoles, bool);
  vtkGetMacro(CapHoles, bool);
  vtkBooleanMacro(CapHoles, bool);
  ///@}

  ///@{
  /// Memory limit of the analysis, in MiB; 0 (default): the available memory. If the samples do not
  /// fit, an error is reported.
  vtkSetClampMacro(MemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  /// Time in seconds of the stages of the analysis from which the outputs were computed: check,
  /// sampling, filtration, pairing, features; 0 if there is none. Times are not part of the
  /// outputs, which are the same on every machine.
  vtkGetVectorMacro(StageTimes, double, 5);

protected:
  vtkChokingLoops();
  ~vtkChokingLoops() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  /// All outputs for a surface that is complete on this rank; `mesh` as in input 1, or null.
  bool FindLoops(vtkPolyData* surface, vtkDataObject* mesh, vtkInformationVector* output);

private:
  vtkChokingLoops(const vtkChokingLoops&) = delete;
  void operator=(const vtkChokingLoops&) = delete;

  struct Cache;
  void Analyse(vtkPolyData* surface, vtkDataObject* mesh);
  void Keep(std::unique_ptr<Cache> made);
  isthmus::FeatureSelection Selection() const;
  int RoundsOfShortening() const;
  std::vector<isthmus::ShownFeature> DrawLoops();
  /// Field data: the numbers of all features and of those shown.
  void AddCounts(std::size_t shown, vtkPolyData* output);
  std::unique_ptr<isthmus::ChokingLoops> AnalyseMesh(
    isthmus::TriangleMesh triangles, vtkUnstructuredGrid* given);
  std::vector<double> MorseValues(const isthmus::SurfaceView& surface,
    const isthmus::TetrahedralMesh& mesh, vtkUnstructuredGrid* given);

  int Side = Both;
  double MaximumRadius = 100.0;
  int MaximumRadiusUnit = Percent;
  double MinimumPersistence = 5.0;
  int MinimumPersistenceUnit = Percent;
  int ThresholdMode = Given;
  int MaximumNumberOfLoops = 0;
  bool TrustedOnly = false;
  double MaximumLength = 0.0;
  double MaximumReach = 0.0;
  int LoopOrder = ByRadius;
  bool AlwaysReportHandles = true;
  int Filtration = Delaunay;
  int MorseFunction = ClosestPoint;
  std::string MorseArrayName;
  double SampleSpacing = 0.0;
  int Shortening = Geodesic;
  int ShorteningRounds = 5;
  int MembraneMethod = Automatic;
  bool AllowSelfIntersections = false;
  bool CapHoles = false;
  int MemoryLimit = 0;
  double StageTimes[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  std::unique_ptr<Cache> Kept;
};

#endif
