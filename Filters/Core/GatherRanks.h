/**
 * @file GatherRanks.h
 * @brief Gathers the pieces of a surface from several MPI ranks, for filters whose result depends
 * on the whole surface.
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

/// The ranks that receive the whole surface.
enum class GatherOn
{
  FirstRank, ///< the others get an empty surface, so that nothing is counted or shown twice
  EachRank
};

/// Number of ranks; 1 without MPI.
VTKISTHMUSFILTERSCORE_EXPORT int NumberOfRanks();

/// Whether this is the first rank, or the only one.
VTKISTHMUSFILTERSCORE_EXPORT bool OnFirstRank();

/// Number of ranks on which `data` has points. With several ranks all of them must call it, each
/// with its piece or null.
int RanksWithPoints(vtkDataObject* data);

/// @throws std::runtime_error if `ranks` is more than 1; `what` names the data in the plural.
void RejectSeveralRanks(int ranks, const std::string& what);

/// @throws std::runtime_error on several ranks if an input of `filter` is composite: blocks are
/// processed one by one, and the others would wait forever for a rank that lacks a block. Detected
/// in ParaView's pipelines only; in a pure VTK pipeline a block cannot be distinguished from other
/// data.
VTKISTHMUSFILTERSCORE_EXPORT void RequireNoBlocks(vtkAlgorithm* filter);

/**
 * The pieces of all ranks together, without ghost cells and with bitwise equal points of several
 * ranks merged. On one rank, this is `piece` itself unless it has ghost cells.
 *
 * With several ranks all of them must call it. Null for a null piece (one of another type, which
 * RunGuarded refuses). Memory: the whole surface where it is needed.
 * @throws std::runtime_error as RequireNoBlocks
 */
VTKISTHMUSFILTERSCORE_EXPORT vtkSmartPointer<vtkPolyData> GatherSurface(
  vtkAlgorithm* filter, vtkPolyData* piece, GatherOn where = GatherOn::FirstRank);

/**
 * Refuses several ranks for data that must be complete and are not gathered: atoms, meshes.
 *
 * With several ranks all must call it, each with its piece or null.
 * @param what  name of the data in the plural, for the error message
 * @throws std::runtime_error on all ranks if more than one has points, and as RequireNoBlocks
 */
VTKISTHMUSFILTERSCORE_EXPORT void RequireOneRank(
  vtkAlgorithm* filter, vtkDataObject* piece, const std::string& what);

}

#endif
