/**
 * @file CubicalPersistence.h
 * @brief Persistent homology over Z/2 of a volume that grows with its level.
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
 * with the last of their corners. So two nodes of an object touch along the axes (6 neighbours),
 * two of the background also across edges and corners (26), and the box has no holes of its own:
 * an object that leaves through the border loses the voids and loops that only the outside closes.
 * Equal values are ordered by index, which changes no birth or death; a superlevel is the sublevel
 * of the negative.
 *
 * Method: a discrete gradient by lower stars (LowerStars.h), union-find over critical edges and
 * over critical faces (CubicalComponents.h), reduction of the other critical faces
 * (CubicalLoops.h). Cost on smooth data about 60 ns and 4 to 12 bytes a node over the input, in
 * white noise 2 us and 100 bytes; double, 64-bit integers and more than 2^28 nodes take keys of 128
 * instead of 64 bits and so somewhat more. The same on any number of threads.
 *
 * Throws std::invalid_argument, with its place, at a value that is not a number. Infinities are
 * values like others. A volume without nodes has no pairs.
 */
VTKISTHMUSFILTERSPERSISTENCE_EXPORT CubicalDiagram CubicalPersistence(const VolumeView& volume,
  const CubicalParameters& parameters = {}, const ProgressCallback& progress = {});

}

#endif
