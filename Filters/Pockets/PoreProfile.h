/**
 * @file PoreProfile.h
 * @brief The radius along a pore: the largest ball between the atoms in each of many planes.
 *
 * As HOLE defines it (O. S. Smart et al., J. Mol. Graph. 14 (1996) 354), but with exact local
 * maxima in place of a random search, and with planes across the pore's own course where no
 * direction is given. Planes are processed from the start outwards, each from the ball of the one
 * before, so that the course stays in one pore; it ends where the ball is larger than EndRadius.
 */
#ifndef isthmus_PoreProfile_h
#define isthmus_PoreProfile_h

#include "Atoms/Ball.h"
#include "Core/Progress.h"
#include "Pockets/Pore.h"
#include "vtkIsthmusFiltersPocketsModule.h"

namespace isthmus
{

/// All channels that run through the molecule, the longest first (PoreChannels.h says which).
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<Pore> FindPores(const std::vector<Ball>& atoms,
  const PoreOptions& options, const ProgressCallback& progress = {});

/// The pore from one point to another.
VTKISTHMUSFILTERSPOCKETS_EXPORT Pore PoreBetween(const std::vector<Ball>& atoms,
  const Point3& first, const Point3& last, const PoreOptions& options,
  const ProgressCallback& progress = {});

/**
 * The pore through `point` in planes across `direction`, both ways from there. Throws
 * std::invalid_argument for a direction without length.
 *
 * All three throw std::invalid_argument for options and atoms out of range, std::runtime_error
 * where there is no path; Cancelled. About 1 ms a plane.
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT Pore PoreAlong(const std::vector<Ball>& atoms, const Point3& point,
  const Point3& direction, const PoreOptions& options, const ProgressCallback& progress = {});

}

#endif
