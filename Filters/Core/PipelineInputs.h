/**
 * @file PipelineInputs.h
 * @brief What a filter must know of its inputs before it takes them for what it asked for.
 *
 * A window and a script can connect anything: blocks of several kinds, a table for a surface.
 * VTK's executive checks the type of the whole only, and hands a filter the blocks as they come.
 */
#ifndef isthmus_PipelineInputs_h
#define isthmus_PipelineInputs_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <map>
#include <string>

class vtkAlgorithm;

namespace isthmus
{

/// @throws std::invalid_argument, with both types, where an input is not of a type that its port
/// asks for; with the array, where one has fewer values than there are points (cells, rows ...)
/// that it is to say something of, and would be read beyond its end. Guarded (AlgorithmGuard.h)
/// begins with it. O(arrays).
VTKISTHMUSFILTERSCORE_EXPORT void CheckInputs(vtkAlgorithm* self);

/**
 * Updates an input from RequestInformation, which filters do not do otherwise: for those that make
 * an image of given spacing around atoms or surfaces. VTK has to know its whole extent before data,
 * or image filters downstream allocate empty outputs on their first update, and the extent follows
 * from the input's points. Nothing else is computed there, and no program is run.
 *
 * Not while the filter itself is being executed: VTK asks for the information of each block of
 * composite data in the middle of an execution; an update there would run the source again onto the
 * block, and end the program.
 *
 * A member of the filter, made with it; by pointer, since the filter's header is installed.
 */
class VTKISTHMUSFILTERSCORE_EXPORT InputInAdvance
{
public:
  explicit InputInAdvance(vtkAlgorithm* self);
  InputInAdvance(const InputInAdvance&) = delete;
  InputInAdvance& operator=(const InputInAdvance&) = delete;

  /// With several ranks all must call it.
  void Update(int port = 0);
  /// @throws std::runtime_error, with `what` they are in the plural, where several ranks had points
  /// when this input was made. Asks no other rank: one without data may skip the execution.
  void RequireOneRank(int port, const std::string& what) const;

private:
  vtkAlgorithm* Self;
  std::map<int, int> RanksOf; ///< of each port: ranks with points
  int Executing = 0;          ///< depth: the execution of a block lies within that of the whole
};

}

#endif
