/**
 * @file ChokingLoopParameters.h
 * @brief Parameters of this module's algorithms, with their defaults.
 */
#ifndef isthmus_ChokingLoopParameters_h
#define isthmus_ChokingLoopParameters_h

#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <string>

namespace isthmus
{

enum class SideSelection
{
  Inside = 0,
  Outside = 1,
  Both = 2
};

// ------------------------------------------------------------------------------------------
// The analysis of a surface (ChokingLoops.h).

struct ChokingLoopParameters
{
  /// Edges of the surface are split until none is longer than this. In units of the data; 0:
  /// automatic, which spreads about 20,000 samples over the surface and refines where a feature
  /// cannot be distinguished from the sampling, as long as a round resolves at least half of such
  /// places.
  double SampleSpacing = 0.0;
  /// Of radii, in percent. A surface with more than 40,000 points is analysed on as few of them as
  /// its thickness requires (AdaptiveSamples.h), and the radii of trusted features are then
  /// measured on the surface itself. Has no effect with a SampleSpacing: every point of the surface
  /// is then a sample.
  double Accuracy = 1.0;
  /// Analyse a surface even if it intersects itself. The numbers of handles and tunnels are then
  /// not guaranteed.
  bool AllowSelfIntersections = false;
  /// Memory limit of the analysis in MiB; 0: the available memory. An error is thrown if the
  /// samples do not fit; refinement that would not fit is skipped.
  int MemoryLimit = 0;
};

/// @throws std::invalid_argument with property, value and range; so do the other functions of this
/// name.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const ChokingLoopParameters& parameters);

// ------------------------------------------------------------------------------------------
// Selection of the reported features (FeatureDiagram.h).

enum class LengthUnit
{
  Percent, ///< of the side's reference length
  Absolute ///< in the unit of the points
};

/// How additional features are separated from noise.
enum class ThresholdMode
{
  Given,     ///< by FeatureSelection::MinimumPersistence
  LargestGap ///< by the largest gap of each side's diagram
};

/// Which features to report.
struct FeatureSelection
{
  SideSelection Side = SideSelection::Both;
  bool IncludeHandles = true;
  bool IncludeTunnels = true;
  bool IncludeBottlenecks = true; ///< the additional features
  double MaximumRadius = 100.0;
  LengthUnit MaximumRadiusUnit = LengthUnit::Percent;
  double MinimumPersistence = 5.0;
  LengthUnit MinimumPersistenceUnit = LengthUnit::Percent;
  isthmus::ThresholdMode ThresholdMode = isthmus::ThresholdMode::Given;
  /// Report handles and tunnels of any radius, beyond MaximumRadius as well. MinimumPersistence
  /// never applies to them: a ring of constant width does not widen behind the narrowing, and yet
  /// it is a handle.
  bool AlwaysIncludeHandles = true;
  /// Drop features that may be caused by the sampling (see ShapeFeature::Trusted).
  bool TrustedOnly = false;
  /// Keep the features of the largest persistence; 0: all of them.
  int MaximumNumberOfLoops = 0;
};

VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const FeatureSelection& selection);

// ------------------------------------------------------------------------------------------
// Limits on drawn loops, and their order (ChokingLoopsOutput.h).

enum class LoopOrder
{
  ByRadius,
  ByLength ///< of a feature's longest loop
};

struct LoopLimits
{
  double MaximumLength =
    0.0; ///< of a feature's longest loop, in the unit of the points; 0: no limit
  double MaximumReach = 0.0; ///< `Reach` of a feature (vtkChokingLoops.h); 0: no limit
  isthmus::LoopOrder LoopOrder = isthmus::LoopOrder::ByRadius; ///< ascending
};

VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const LoopLimits& limits);

// ------------------------------------------------------------------------------------------
// The function on a tetrahedral mesh (MeshLoops.h).

/// MorseFunction of MorseValues.h, or a point array of the mesh.
enum class MeshFunction
{
  ClosestPoint = 0,
  EdgePaths = 1,
  GridDistance = 2,
  PointArray = 3,
  FastMarching = 4
};

struct MeshFunctionParameters
{
  MeshFunction MorseFunction = MeshFunction::ClosestPoint;
  std::string MorseArrayName;
};

// ------------------------------------------------------------------------------------------
// From a surface to drawn loops (vtkChokingLoops.h, where each is documented).

enum class LoopFiltration
{
  Delaunay,
  TetrahedralMesh
};

enum class ShorteningMode
{
  None,
  Rounds,
  Geodesic
};

/// How the membrane that spans a choke is computed.
enum class MembraneMethod
{
  Automatic,  ///< as LoopDrawing.h chooses
  MinimumCut, ///< of least area (MinimumCutMembrane.h)
  Greedy      ///< grown from the choke triangle (GreedyMembrane.h)
};

struct LoopSearchParameters
  : ChokingLoopParameters
  , FeatureSelection
  , LoopLimits
  , MeshFunctionParameters
{
  LoopFiltration Filtration = LoopFiltration::Delaunay;
  ShorteningMode Shortening = ShorteningMode::Geodesic;
  int ShorteningRounds = 5;
  isthmus::MembraneMethod MembraneMethod = isthmus::MembraneMethod::Automatic;
  bool CapHoles = false;
};

VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const LoopSearchParameters& parameters);

// ------------------------------------------------------------------------------------------
// Shortening of loops (LoopShortening.h).

struct LoopShorteningParameters
{
  int MaximumRounds = 1000; ///< each finds the shortest path in the strip and reroutes the strip
  double Tolerance = 1e-6;  ///< relative accuracy of the length within a strip
};

VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const LoopShorteningParameters& parameters);

// ------------------------------------------------------------------------------------------
// Removal of small handles and tunnels (HandleFilling.h).

struct HandleFillingParameters : ChokingLoopParameters
{
  /// Handles and tunnels with a smaller radius are removed. In the unit of the points.
  double FillHandlesBelow = 1.0;
  /// Inside: handles are cut; Outside: tunnels are filled.
  SideSelection Side = SideSelection::Both;
  /// Thickness of the plate that fills a tunnel, or width of the gap that cuts a handle, in radii
  /// of the handle or tunnel.
  double Thickness = 0.25;
};

VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const HandleFillingParameters& parameters);

// ------------------------------------------------------------------------------------------
// The points at a distance from a surface (OffsetSurface.h).

struct OffsetSurfaceParameters
{
  double Distance = 1.0; ///< from the surface, in the unit of the points
  SideSelection Side = SideSelection::Both;
  int Resolution = 128; ///< grid cells along the longest side of the offset's bounding box
};

VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const OffsetSurfaceParameters& parameters);

// ------------------------------------------------------------------------------------------
// Bootstrap of the handles of a map (MapHandles.h).

struct SupportParameters
{
  int NumberOfResamples = 100;
  int Seed = 1;
  double Level = 0.0; ///< the chosen level
};

VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT void Check(const SupportParameters& parameters);

}

#endif
