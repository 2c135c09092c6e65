/**
 * @file PoreProfile.h
 * @brief The radius along a pore: the largest ball between the atoms in each of many planes.
 *
 * As defined by HOLE (O. S. Smart et al., J. Mol. Graph. 14 (1996) 354), but with exact local
 * maxima instead of a random search, and with planes perpendicular to the course of the pore if no
 * direction is given. Planes are processed from the start outwards, each beginning with the ball of
 * the previous one, so that the path stays in one pore; it ends where the ball is larger than
 * EndRadius.
 */
#ifndef isthmus_PoreProfile_h
#define isthmus_PoreProfile_h

#include "Atoms/Ball.h"
#include "Atoms/PeriodicCell.h"
#include "Core/Progress.h"
#include "Pockets/Pore.h"

namespace isthmus
{

/// All channels through the molecule, the longest first (see PoreChannels.h for the criteria).
std::vector<Pore> FindPores(const std::vector<Ball>& atoms, const PoreOptions& options,
  const ProgressCallback& progress = {});

/// The pore from one point to another.
Pore PoreBetween(const std::vector<Ball>& atoms, const Point3& first, const Point3& last,
  const PoreOptions& options, const ProgressCallback& progress = {});

/**
 * The pore through `point` in planes perpendicular to `direction`, followed both ways from there.
 * Throws std::invalid_argument if the direction has length 0.
 *
 * All three throw std::invalid_argument for options and atoms out of range, std::runtime_error if
 * there is no path; Cancelled. Time: linear in planes and in the atoms near them.
 */
Pore PoreAlong(const std::vector<Ball>& atoms, const Point3& point, const Point3& direction,
  const PoreOptions& options, const ProgressCallback& progress = {});

/// The ways through a crystal along the vectors of its cell.
struct PeriodicPores
{
  /// From the widest place of a way to the next copy of it. Its smallest radius is that of the
  /// largest ball that gets through the crystal along this vector. A blocked one is missing.
  std::vector<Pore> Pores;
  /// The atoms around the pores, with copies where the pores are; NearestAtom refers to them.
  std::vector<Ball> Images;
  std::vector<std::size_t> Atoms; ///< of each image: its atom in the input
  double LargestRadius = 0.0;     ///< of the largest ball between the atoms
  Point3 LargestCenter{ 0.0, 0.0, 0.0 };
};

/**
 * The widest ways through a crystal along a, b and c, over all paths from a place to a copy of it
 * that is displaced by a multiple of this vector (PeriodicSpace.h). Of `options`, Spacing counts.
 * The radius at each point of the way is that of the largest ball centered there, not in a plane
 * across it. Exact for atoms of one radius; where radii differ, the way follows the power diagram,
 * which is not the widest one, but is as wide as stated.
 *
 * @throws std::invalid_argument for options and atoms out of range, or no atom; Cancelled.
 */
PeriodicPores FindPeriodicPores(const std::vector<Ball>& atoms, const PeriodicCell& cell,
  const PoreOptions& options, const ProgressCallback& progress = {});

}

#endif
