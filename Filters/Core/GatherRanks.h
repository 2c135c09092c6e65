/**
 * @file GatherRanks.h
 * @brief A surface that lies in pieces on several ranks, in one piece: for filters whose answer is
 * about the surface and not about its points.
 */
#ifndef isthmus_GatherRanks_h
#define isthmus_GatherRanks_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <string>

class vtkAlgorithm;
class vtkDataObject;

namespace isthmus
{

/// Where the whole surface is wanted.
enum class GatherOn
{
  FirstRank, ///< the others get an empty one, so that nothing is counted or shown twice
  EachRank
};

/// How many ranks there are: 1 without MPI.
VTKISTHMUSFILTERSCORE_EXPORT int NumberOfRanks();

/// Whether this is the first rank, or the only one.
VTKISTHMUSFILTERSCORE_EXPORT bool OnFirstRank();

/// On how many ranks `data` has points. With several ranks all must call it, each with its piece or
/// null.
VTKISTHMUSFILTERSCORE_EXPORT int RanksWithPoints(vtkDataObject* data);

/// @throws std::runtime_error, with `what` they are in the plural, where `ranks` is more than 1.
VTKISTHMUSFILTERSCORE_EXPORT void RefuseSeveralRanks(int ranks, const std::string& what);

/// @throws std::runtime_error on several ranks where an input of `filter` is composite: blocks are
/// run one by one, and a rank that lacks one would be waited for without end. Seen in ParaView's
/// pipelines; in one of VTK alone, blocks look like what they are.
VTKISTHMUSFILTERSCORE_EXPORT void RequireNoBlocks(vtkAlgorithm* filter);

/**
 * The pieces of all ranks together, ghost cells left out, points at the same place (bit for bit) on
 * several ranks merged. On one rank `piece` itself, unless it has ghost cells.
 *
 * With several ranks all must call it. Null in, null out (a piece of another kind: Guarded refuses
 * it). Memory: the whole surface where it is wanted.
 * @throws std::runtime_error as RequireNoBlocks
 */
VTKISTHMUSFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> GatherSurface(
  vtkAlgorithm* filter, vtkPolyData* piece, GatherOn where = GatherOn::FirstRank);

/**
 * For data that are needed whole and not put together here: atoms, meshes.
 *
 * With several ranks all must call it, each with its piece or null.
 * @param what  they are, in the plural, for the sentence
 * @throws std::runtime_error on all ranks where more than one has points, and as RequireNoBlocks
 */
VTKISTHMUSFILTERSCORE_EXPORT void RequireOneRank(
  vtkAlgorithm* filter, vtkDataObject* piece, const std::string& what);

}

#endif
