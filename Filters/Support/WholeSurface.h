/**
 * @file WholeSurface.h
 * @brief A surface that lies in pieces on several ranks, in one piece: for filters whose answer is
 * about the surface and not about its points.
 */
#ifndef isthmus_WholeSurface_h
#define isthmus_WholeSurface_h

#include "vtkIsthmusModule.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace isthmus
{

/// Where the whole surface is wanted.
enum class WholeOn
{
  FirstRank, ///< the others get an empty one, so that nothing is counted or shown twice
  EachRank
};

/// How many ranks there are: 1 without MPI.
VTKISTHMUS_EXPORT int NumberOfRanks();

/// Whether this is the first rank, or the only one.
VTKISTHMUS_EXPORT bool OnFirstRank();

/**
 * The pieces of all ranks together, ghost cells left out, points at the same place (bit for bit) on
 * several ranks merged. On one rank `piece` itself, unless it has ghost cells.
 *
 * With several ranks all must call it. Null in, null out (a piece of another kind: Guarded refuses
 * it). Memory: the whole surface where it is wanted.
 */
VTKISTHMUS_EXPORT vtkSmartPointer<vtkPolyData> WholeSurface(
  vtkPolyData* piece, WholeOn where = WholeOn::FirstRank);

}

#endif
