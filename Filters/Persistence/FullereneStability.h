/**
 * @file FullereneStability.h
 * @brief Rings and cages of a molecule as its atoms grow to balls, and the indicator made of them.
 */
#ifndef isthmus_FullereneStability_h
#define isthmus_FullereneStability_h

#include "Core/Progress.h"
#include "Persistence/FullereneParameters.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

namespace isthmus
{

/**
 * Bars of dimension 1 and 2 of the union of balls round the atoms, by the alpha complex: exact, no
 * grid. Births and deaths are radii. Milliseconds for a molecule.
 *
 * Atoms at one place count once. Atoms in one plane have no cages, and rings are found by adding a
 * point so far away that it takes no part; fewer than three atoms, or atoms in one line, have no
 * bars. Throws std::invalid_argument for a coordinate that is not finite.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<DistanceBar> AlphaBars(
  const std::vector<Point3>& atoms, const ProgressCallback& progress = {});

/**
 * The same by the cubical complex of the distance on a grid, up to Theta: as the thesis does it
 * (sections 6.4 and 6.5). A bar that reaches Theta ends there.
 *
 * The distance is that to the nearest atom, or the least of distance / scale where `scales` (one
 * per atom, the radius of its type) is not empty. With FastMarching each type has an eikonal
 * equation of its own, solved from the nodes round its atoms. Births and deaths are wrong by up to
 * sqrt(3)/2 spacings, and the bars shorter than a spacing or two are made by the grid alone.
 *
 * Throws std::invalid_argument for parameters or atoms that are not finite or not positive, and
 * std::runtime_error for a grid of more than 2^31 nodes.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<DistanceBar> GridBars(
  const std::vector<Point3>& atoms, const std::vector<double>& scales,
  const GridDistanceParameters& parameters, const ProgressCallback& progress = {});

/**
 * The row of the table that these bars make. A bar that ends at `theta` has not ended and is kept
 * however short; give infinity for alpha complexes.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT FullereneStability StabilityOf(const std::vector<Point3>& atoms,
  const std::vector<DistanceBar>& bars, double filterDelta, double theta);

}

#endif
