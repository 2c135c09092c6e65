/**
 * @file CubicalPersistence.h
 * @brief Persistent homology over Z/2 of the level sets of a volume.
 */
#ifndef isthmus_CubicalPersistence_h
#define isthmus_CubicalPersistence_h

#include "Core/Progress.h"
#include "Persistence/CubicalDiagram.h"
#include "Persistence/VolumeView.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

namespace isthmus
{

/**
 * All classes of components, loops and voids of the sublevel (superlevel) sets of `volume`.
 *
 * The complex is the V-construction: nodes enter at their value, edges, faces and cubes of the grid
 * with the last of their corners. Thus nodes of an object are connected along the axes (6
 * neighbours), and nodes of the background also across edges and corners (26). The box itself has
 * no holes: an object that leaves it through the border loses the voids and loops that only the
 * exterior would close. Equal values are ordered by index, which changes no birth or death; a
 * superlevel is the sublevel of the negative.
 *
 * Method: a discrete gradient by lower stars (LowerStars.h), union-find over critical edges and
 * over critical faces (CubicalComponents.h), reduction of the other critical faces
 * (CubicalLoops.h). Nearly linear for maps; memory for each node, in addition to the input: 4 to 12
 * bytes for smooth data, 100 for white noise. Double, 64-bit integers and more than 2^28 nodes need
 * keys of 128 instead of 64 bits and therefore somewhat more. The result is the same on any number
 * of threads.
 *
 * Throws std::invalid_argument for a value that is not a number, with its position. Infinities are
 * values like others. A volume without nodes has no pairs.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT CubicalDiagram CubicalPersistence(const VolumeView& volume,
  const CubicalParameters& parameters = {}, const ProgressCallback& progress = {});

/// Memory that CubicalPersistence will take for these values, with its result: the number of
/// critical cells, which decides on it, is counted in a sample of up to two million nodes.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT double CubicalBytes(const VolumeView& volume, bool superlevel);

/// @throws std::runtime_error with what to do if CubicalBytes and `more` bytes are not available.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT void RequireCubicalMemory(
  const VolumeView& volume, bool superlevel, double more = 0.0);

}

#endif
