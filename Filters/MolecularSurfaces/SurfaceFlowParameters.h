/**
 * @file SurfaceFlowParameters.h
 * @brief What a geometric-flow surface is asked for, and what it gives.
 */
#ifndef isthmus_SurfaceFlowParameters_h
#define isthmus_SurfaceFlowParameters_h

#include "Atoms/MolecularDensity.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Lengths in angstrom, times in square angstrom (the flow's speed is the curvature).
struct SurfaceFlowParameters
{
  double Enlargement = 1.3;   ///< eta: the flow starts from balls of eta times the radius, >= 1
  double EvolutionTime = 2.5; ///< of the flow, where it is not Steady
  bool Steady = false;        ///< until the surface rests
  double ProbeRadius = 0.0;   ///< of the second obstacle, the solvent's side; 0: none
  double Spacing = 0.5;
  double Padding = 1.7;     ///< from the enlarged balls to the border; two spacings are always kept
  bool CoarseToFine = true; ///< steady surfaces begin on coarser grids
};

/// One line of the history.
struct FlowRecord
{
  double Time = 0.0;    ///< square angstrom
  double Spacing = 0.0; ///< of the grid that the flow was on, angstrom
  double Area = 0.0;    ///< square angstrom
  double Volume = 0.0;  ///< cubic angstrom
};

struct SurfaceFlowResult
{
  DensityGrid Grid;            ///< of the nodes below
  std::vector<float> Distance; ///< angstrom, negative inside, cut at Band
  double Band = 0.0;           ///< angstrom
  std::vector<FlowRecord> History;
  std::vector<float> S; ///< by the thesis' scheme only: 1 inside, 0 outside
  bool Rests = true;    ///< false: a Steady flow reached its limit of steps still moving
};

}

#endif
