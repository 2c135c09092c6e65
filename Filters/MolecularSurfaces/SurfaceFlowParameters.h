/**
 * @file SurfaceFlowParameters.h
 * @brief Grid, memory and result of a molecular surface, for all methods.
 *
 * Common to SurfaceFlow.h, ThesisFlow.h and SolventExcludedSurface.h.
 */
#ifndef isthmus_SurfaceFlowParameters_h
#define isthmus_SurfaceFlowParameters_h

#include "Atoms/Ball.h"
#include "Atoms/MolecularDensity.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/MolecularSurfaceParameters.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

#include <vector>

namespace isthmus
{

/// One line of the history.
struct FlowRecord
{
  double Time = 0.0;    ///< square angstrom
  double Spacing = 0.0; ///< of the grid of the flow, angstrom
  double Area = 0.0;    ///< square angstrom
  double Volume = 0.0;  ///< cubic angstrom
};

struct SurfaceFlowResult
{
  DensityGrid Grid;            ///< of the nodes below
  std::vector<float> Distance; ///< angstrom, negative inside, cut at Band
  double Band = 0.0;           ///< angstrom
  std::vector<FlowRecord> History;
  std::vector<float> S;  ///< by the thesis' scheme only: 1 inside, 0 outside
  bool Converged = true; ///< false: a Steady flow reached its limit of steps while still moving
};

/// Throws std::invalid_argument for parameters out of range (Check()) and for atoms that are not
/// finite or have no radius.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void CheckFlow(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters);

/// Throws std::runtime_error if no node of the grid of the field lies inside a ball.
void CheckGridResolvesAtoms(
  const FlowField& field, const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters);

/// The grid around the enlarged balls with `factor` times the spacing of the parameters.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT DensityGrid FlowGridAround(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters, double factor = 1.0);

/// Bytes for a flow on `grid`, including result and output: 36 for each node, and 24 for each node
/// of the margin.
double FlowBytes(const DensityGrid& grid);

/// Throws std::runtime_error, with the size that `grid` would need, if this is not available; the
/// message names an atom that lies far from the others, if there is one.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void CheckFlowMemory(
  const std::vector<Ball>& balls, const DensityGrid& grid);

/// `factor` times the values of the grid's nodes without its margin, plus `shift`.
std::vector<float> InnerValues(
  const FlowGrid& grid, const std::vector<float>& values, float factor, float shift);

/// Fills in the distances, in angstrom.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT void StoreDistances(
  const FlowField& field, SurfaceFlowResult& result);

/// Adds the field's area and volume to the history.
void RecordMeasures(const FlowField& field, double time, SurfaceFlowResult& result);

}

#endif
