/**
 * @file AtomsInside.h
 * @brief Checks whether a surface that was given with the atoms is that of these atoms.
 *
 * A surface of the same molecule in nanometres, or moved, lies where the atoms are, so that
 * InputOverlap.h does not notice it; the atoms outside of it do.
 */
#ifndef isthmus_AtomsInside_h
#define isthmus_AtomsInside_h

#include "Core/Geometry.h"

#include <string>
#include <vector>

class vtkImageData;

namespace isthmus
{

/**
 * Which of `centers` lie outside the surface: where `distances` (one for each node of `grid`,
 * negative inside, linear between nodes) are not negative, or outside of the grid. An atom farther
 * inside the surface than its own grid cell cannot be counted wrongly.
 * @param what  the atoms, e.g. "charged atoms"
 * @return a warning if some lie outside; empty if none do
 * @throws std::invalid_argument if more than half of them do
 */
std::string CheckAtomsInside(vtkImageData* grid, const std::vector<float>& distances,
  const std::vector<Point3>& centers, const std::string& what);

}

#endif
