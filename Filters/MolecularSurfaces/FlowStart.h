/**
 * @file FlowStart.h
 * @brief The grids of a flow, and the fields that it starts from.
 */
#ifndef isthmus_FlowStart_h
#define isthmus_FlowStart_h

#include "Core/Progress.h"
#include "MolecularSurfaces/FlowGrid.h"
#include "MolecularSurfaces/SurfaceFlowParameters.h"

#include <functional>
#include <vector>

namespace isthmus
{

/// Fills in -V / gamma at the nodes of a grid, in 1/angstrom: positive pulls to the atoms.
using PullField = std::function<void(const FlowGrid& grid, std::vector<float>& pull)>;

/// Throws std::invalid_argument for what is out of range.
void CheckFlow(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters);

/// Throws std::runtime_error when no node of the field's grid lies inside of a ball.
void CheckAnythingInside(
  const FlowField& field, const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters);

/// The grid around the enlarged balls at a spacing of `factor` times that of the parameters.
DensityGrid FlowGridAround(
  const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters, double factor = 1.0);

/// How many times the spacing can be doubled before the grid no longer shows the atoms: a coarse
/// cell is at most twice a mean radius wide, and 16 of them go along the grid's shortest side.
int CoarserLevels(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters);

/// The field at the flow's start, from balls of `enlargement` times the radius: ceiling, floor,
/// pull and distances in the band.
FlowField StartField(const std::vector<Ball>& balls, const SurfaceFlowParameters& parameters,
  double factor, double enlargement, const PullField& pull, const ProgressCallback& progress);

/// Makes the inside of `fine` what is inside of it or of `coarse`, whose distances are interpolated
/// linearly along each axis.
void AddCoarse(const FlowField& coarse, FlowField& fine);

}

#endif
