/**
 * @file FullereneStability.h
 * @brief Rings and cages of a molecule as balls grow around its atoms, and the indicator computed
 * from them.
 */
#ifndef isthmus_FullereneStability_h
#define isthmus_FullereneStability_h

#include "Core/Progress.h"
#include "Persistence/AtomDistanceGrid.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

namespace isthmus
{

enum class StabilityMethod
{
  Exact = 0, ///< AlphaBars()
  Grid = 1   ///< GridBars()
};

struct StabilityParameters : GridDistanceParameters
{
  StabilityMethod Method = StabilityMethod::Exact;
  double FilterDelta = 0.2;   ///< shortest bar that counts
  bool ScaleByRadius = false; ///< distances in units of each atom's radius; Grid only
};

VTKISTHMUSFILTERSPERSISTENCE_EXPORT void Check(const StabilityParameters& parameters);

/// One row of the table.
struct FullereneStability
{
  std::int64_t Atoms = 0;        ///< at different positions
  std::int64_t Bars = 0;         ///< of dimension 1, at least FilterDelta long
  double Integral = 0.0;         ///< of beta_1 over distance: sum of the lengths of all bars
  double FilteredIntegral = 0.0; ///< of those at least FilterDelta long
  double Cavity = 0.0;           ///< length of the longest bar of dimension 2
  double BoxLength = 0.0;        ///< longest side of the box round the atoms
  double EnergyProxy = 0.0;      ///< -FilteredIntegral / Atoms
};

/**
 * Bars of dimension 1 and 2 of the union of balls round the atoms, by the alpha complex: exact, no
 * grid. Births and deaths are radii.
 *
 * Atoms at the same position count once. Atoms in one plane have no cages, and their rings are
 * found by adding a point that is too far away to have an effect; fewer than three atoms, or atoms
 * in one line, have no bars. Throws std::invalid_argument for a coordinate that is not finite.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<DistanceBar> AlphaBars(
  const std::vector<Point3>& atoms, const ProgressCallback& progress = {});

/**
 * The row of the table for these bars. A bar that reaches `theta` has not really ended and is kept
 * even if it is short; pass infinity for alpha complexes.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT FullereneStability ComputeStability(
  const std::vector<Point3>& atoms, const std::vector<DistanceBar>& bars, double filterDelta,
  double theta);

}

#endif
