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
 * Outputs, whose arrays OutputArrayTable() lists:
 *  0. loops: closed polylines on the surface. A feature may have several, for example if its
 *     membrane is an annulus.
 *  1. membranes: triangles spanning each loop.
 *  2. choke points: one vertex for a feature.
 *  3. persistence diagram, a vtkTable: a bar and its loops have the same `FeatureId`, so selecting
 *     one shows the other. Rows of dimension 2 (additional loops) have the same birth and death as
 *     their loops. Rows of dimension 1 (handles and tunnels) are the class of the loop on the
 *     surface: birth 0, death `Radius`.
 *
 * Birth, death and persistence are defined once, in FeatureDiagram.h (ShapeFeature).
 *
 * Lengths are in the unit of the points, areas in its square.
 *
 * Needles, double triangles, and parts that touch or cross are repaired if this changes the volume
 * by at most 1 %, with a warning and the field data `Repaired` and `RepairedPlaces`. A surface that
 * is not closed, consistently oriented and finite, or that cannot be repaired, causes an error that
 * names triangles, and the outputs are empty. Of handles and tunnels narrower than the sampling
 * error, number and side are those of the surface; a warning says that their `Radius` is an upper
 * bound.
 *
 * The analysis is cached: changes of thresholds, side and shortening do not repeat it.
 */
#ifndef vtkChokingLoops_h
#define vtkChokingLoops_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory>
#include <string>
#include <vector>

namespace isthmus
{
class ChokingLoops;
struct ShownFeature;
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
  ISTHMUS_PARAMETER(Side, int);
  ///@}

  ///@{
  /// Report narrowings up to this radius: in percent of the side's reference length, the largest
  /// radius at which anything on that side is filled, or in the unit of the points. Default 100 %.
  ISTHMUS_PARAMETER(MaximumRadius, double);
  ISTHMUS_PARAMETER(MaximumRadiusUnit, int);
  ///@}

  ///@{
  /// Report additional loops of at least this persistence: in percent of the side's reference
  /// length or in the unit of the points. Default 5 %.
  ISTHMUS_PARAMETER(MinimumPersistence, double);
  ISTHMUS_PARAMETER(MinimumPersistenceUnit, int);
  ///@}

  ///@{
  /// Given (default): MinimumPersistence separates additional loops from noise. LargestGap: the
  /// largest gap of each side's diagram separates them (field data `ProposedThreshold`). Gaps
  /// narrower than 1 % of the reference length are ignored; if no gap is wider, the threshold is
  /// that 1 %.
  ISTHMUS_PARAMETER(ThresholdMode, int);
  ///@}

  ///@{
  /// Report at most this many features, those of the largest persistence. 0 (default): all.
  ISTHMUS_PARAMETER(MaximumNumberOfLoops, int);
  ///@}

  ///@{
  /// Drop features of any kind with a loop longer than this, in the unit of the points. 0
  /// (default): no limit.
  ISTHMUS_PARAMETER(MaximumLength, double);
  ///@}

  ///@{
  /// Drop features of any kind whose loops extend farther than this from the choke point, in radii
  /// (the cell array `Reach`: 1 for a round neck, large for a slot). 0 (default): no limit.
  ISTHMUS_PARAMETER(MaximumReach, double);
  ///@}

  ///@{
  /// Drop features that may be caused by the sampling (cell array `Trusted` is 0). Default off.
  ISTHMUS_PARAMETER_SWITCH(TrustedOnly);
  ///@}

  enum LoopOrderType
  {
    ByRadius,
    ByLength
  };

  ///@{
  /// Sort order of the features in the outputs, ascending. Default ByRadius.
  ISTHMUS_PARAMETER(LoopOrder, int);
  ///@}

  ///@{
  /// Kinds of features to report; bottlenecks are the additional ones. Default on.
  ISTHMUS_PARAMETER_SWITCH(IncludeHandles);
  ISTHMUS_PARAMETER_SWITCH(IncludeTunnels);
  ISTHMUS_PARAMETER_SWITCH(IncludeBottlenecks);
  ///@}

  ///@{
  /// Report handles and tunnels of any radius, beyond MaximumRadius as well. Default on.
  ISTHMUS_PARAMETER_SWITCH(AlwaysIncludeHandles);
  ///@}

  ///@{
  /// Delaunay (default): the alpha complex of samples of the surface, exact. TetrahedralMesh: the
  /// lower-star filtration (thesis, 6.3.1) of MorseFunction on the mesh of input 1, or on one of
  /// about 200,000 tetrahedra that TetGen creates inside the filter, with the surface's triangles
  /// split to their size. Narrowings within the error of the mesh are not reported, with a warning.
  ISTHMUS_PARAMETER(Filtration, int);
  ///@}

  ///@{
  /// With TetrahedralMesh: ClosestPoint (default), the exact distance to the surface; EdgePaths,
  /// the shortest way along edges of the mesh (Dijkstra); GridDistance, the exact distance at the
  /// nodes of a regular grid, sampled trilinearly; PointArray, the array MorseArrayName of input 1;
  /// FastMarching, the distance computed on that grid by fast marching from the surface, sampled
  /// trilinearly.
  ISTHMUS_PARAMETER(MorseFunction, int);
  ///@}

  ///@{
  /// Point array of input 1 for MorseFunction PointArray: not negative, 0 on the surface. Default:
  /// none.
  ISTHMUS_PARAMETER(MorseArrayName, const std::string&);
  ///@}

  ///@{
  /// Edges of the surface are split until none is longer than this, in the unit of the points. 0
  /// (default): automatic, about 20,000 samples, and more if a feature is too small for them.
  ISTHMUS_PARAMETER(SampleSpacing, double);
  ///@}

  ///@{
  /// Of radii, in percent (default 1). A surface with more than 40,000 points is analysed on as few
  /// of them as its thickness requires, and the radii of trusted features are then measured on the
  /// surface itself. With a SampleSpacing every point of the surface is a sample instead.
  ISTHMUS_PARAMETER(Accuracy, double);
  ///@}

  ///@{
  /// None: loops run along edges. Rounds: ShorteningRounds rounds of shortening on the surface,
  /// from 1 to 1000 (default 5).
  /// Geodesic (default): until no loop gets shorter.
  ISTHMUS_PARAMETER(Shortening, int);
  ISTHMUS_PARAMETER(ShorteningRounds, int);
  ///@}

  ///@{
  /// Which membrane spans a choke; its boundary is the loop that is shortened. Automatic (default):
  /// the membrane closed by the filtration, or another one if its loop does not belong to the choke
  /// point. MinimumCut: the membrane of least area through the choke triangle. Greedy, with
  /// TetrahedralMesh only: grown from the choke triangle down to the surface in steps of least cost
  /// (thesis, 6.3.2; GreedyMembrane.h). If a method finds no membrane, the automatic one is
  /// used, and the cell array `Method` of the membranes is 0.
  ISTHMUS_PARAMETER(MembraneMethod, int);
  ///@}

  ///@{
  /// Analyse a surface even if it intersects itself, with a warning. Default off.
  ISTHMUS_PARAMETER_SWITCH(AllowSelfIntersections);
  ///@}

  ///@{
  /// Close holes of the surface, planar or not, before the search. Default off.
  ISTHMUS_PARAMETER_SWITCH(CapHoles);
  ///@}

  ///@{
  /// Memory limit in MiB; 0 (default): what is available. A larger analysis ends in an error before
  /// it begins.
  ISTHMUS_PARAMETER(MemoryLimit, int);
  ///@}

  /// Time in seconds of the stages of the analysis from which the outputs were computed: check,
  /// sampling, filtration, pairing, features; 0 if there is none. Times are not part of the
  /// outputs, which are the same on every machine.
  vtkGetVectorMacro(StageTimes, double, 5);

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

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

  class vtkInternals;
  void Analyse(vtkPolyData* surface, vtkDataObject* mesh); ///< or takes the cached analysis
  std::unique_ptr<isthmus::ChokingLoops> AnalyseSurface(vtkPolyData* surface, vtkDataObject* mesh);
  void Report(const isthmus::ChokingLoops& analysis); ///< warnings and StageTimes
  int RoundsOfShortening() const;
  std::vector<isthmus::ShownFeature> DrawLoops();
  /// Field data: the numbers of all features and of those shown.
  void AddCounts(std::size_t shown, vtkPolyData* output);

  isthmus::LoopSearchParameters Parameters;
  double StageTimes[5] = { 0.0, 0.0, 0.0, 0.0, 0.0 };
  std::unique_ptr<vtkInternals> Internals;
};

#endif
