/**
 * @file MolecularSurfaceParameters.h
 * @brief Parameters of molecular surfaces and of the solvent around them, with their defaults.
 */
#ifndef isthmus_MolecularSurfaceParameters_h
#define isthmus_MolecularSurfaceParameters_h

#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

namespace isthmus
{

/// Lengths are in angstrom, times in square angstrom (the speed of the flow is the curvature).
struct SurfaceFlowParameters
{
  double Enlargement = 1.3;   ///< eta: the flow starts from balls of eta times the radius, >= 1
  double EvolutionTime = 2.5; ///< of the flow, where it is not Steady
  bool Steady = false;        ///< until the surface has converged
  double ProbeRadius = 0.0;   ///< of the second obstacle, the solvent's side; 0: none
  double Spacing = 0.5;
  double Padding = 1.7;     ///< from the enlarged balls to the border; two spacings are always kept
  bool CoarseToFine = true; ///< steady surfaces begin on coarser grids
};

/// @throws std::invalid_argument with property, value and range; so do the other functions of this
/// name.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Check(const SurfaceFlowParameters& parameters);

/// Energies in kcal/mol, lengths in angstrom. Water: TIP3P's oxygen, 1 g/cm^3.
struct SolventParameters
{
  double SurfaceTension = 0.0700;
  double Pressure = 0.0464;
  double SolventDensity = 0.033428; ///< molecules a cubic angstrom
  double SolventRadius = 1.7683;
  double SolventWellDepth = 0.1521;
};

VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Check(const SolventParameters& parameters);

/// The same for a surface that tension and solvent move: the tension must be above 0.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void CheckMoving(const SolventParameters& parameters);

enum class FlowPreset
{
  Custom = 0, ///< the parameters as they are set
  Fine = 1,
  Coarse = 2,
  Hull = 3,
  Channel = 4
};

enum class FlowMethod
{
  SignedDistanceFlow = 0, ///< SurfaceFlow.h
  ThesisFlow = 1,         ///< ThesisFlow.h
  SolventExcluded = 2     ///< SolventExcludedSurface.h
};

/// Of vtkMolecularFlowSurface, where they are documented.
struct MolecularFlowParameters
  : SurfaceFlowParameters
  , SolventParameters
{
  FlowPreset Preset = FlowPreset::Custom;
  FlowMethod Method = FlowMethod::SignedDistanceFlow;
  double Level = 0.5;
  bool Solvent = false;
  bool DelaunayQuality = false;
  int TimeSteps = 0;

  /// Those of the flow, by Preset.
  SurfaceFlowParameters Flow() const;
};

VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void Check(const MolecularFlowParameters& parameters);

}

#endif
