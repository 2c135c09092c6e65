/**
 * @file PipelineInputs.h
 * @brief Checks the types of a filter's inputs before it uses them.
 *
 * ParaView's window and scripts can connect anything: blocks of several types, a table instead of a
 * surface. VTK's executive only checks the type of the whole, and passes blocks to a filter
 * unchecked.
 */
#ifndef isthmus_PipelineInputs_h
#define isthmus_PipelineInputs_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <map>
#include <string>

class vtkAlgorithm;
class vtkPointSet;

namespace isthmus
{

/// @throws std::invalid_argument if an input does not have a type that its port requires, or an
/// array has fewer values than there are points (cells, rows ...); for hidden points or cells
/// (vtkGhostType), which no filter can leave out; coordinates out of range (RangeChecks.h); images
/// with axes that are not perpendicular; inputs that do not overlap (InputOverlap.h). Warns of
/// coordinates in single precision, rounded by more than 2 % of the distance between points.
/// RunGuarded (AlgorithmGuard.h) calls it first. O(arrays + ghost types + points).
VTKISTHMUSFILTERSCORE_EXPORT void CheckInputs(vtkAlgorithm* self);

/// @throws std::invalid_argument, naming the point, if one is at a position that is not finite;
/// points that no cell uses are ignored where there are cells. `name`: "the surface". This is
/// for filters whose algorithm has no such message of its own. O(points).
VTKISTHMUSFILTERSCORE_EXPORT void RequireFinitePositions(
  vtkPointSet* data, const std::string& name);

/**
 * Updates an input from RequestInformation, which filters normally do not do. It is for filters
 * that make an image of given spacing around atoms or surfaces: VTK must know the whole extent
 * before it requests data, otherwise downstream image filters allocate empty outputs on their first
 * update, and the extent depends on the input's points. Nothing else is computed there, and no
 * external program is run.
 *
 * It does nothing while the filter itself is being executed. VTK requests the information of each
 * block of composite data during an execution; an update at that time would execute the source
 * again into the block, and crash.
 *
 * The object is a member of the filter and created with it; it is held by pointer because the
 * filter's header is installed.
 */
class VTKISTHMUSFILTERSCORE_EXPORT InputInAdvance
{
public:
  explicit InputInAdvance(vtkAlgorithm* self);
  InputInAdvance(const InputInAdvance&) = delete;
  InputInAdvance& operator=(const InputInAdvance&) = delete;

  /// With several ranks all of them must call it.
  void Update(int port = 0);
  /// @throws std::runtime_error if several ranks had points when this input was updated; `what`
  /// names the data in the plural. The check does not communicate, because a rank without data may
  /// skip the execution.
  void RequireOneRank(int port, const std::string& what) const;

private:
  vtkAlgorithm* Self;
  std::map<int, int> RanksOf; ///< number of ranks with points, by port
  int Executing = 0;          ///< depth: the execution of a block lies within that of the whole
};

}

#endif
