/**
 * @file InnerAlgorithm.h
 * @brief Runs an algorithm of VTK inside another one, which passes on its progress and its errors.
 */
#ifndef isthmus_InnerAlgorithm_h
#define isthmus_InnerAlgorithm_h

#include "Core/Progress.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <functional>
#include <string>

class vtkAlgorithm;

namespace isthmus
{

/// The message that the last execution of `self` ended with, whether or not it was shown; empty
/// after one that succeeded or was aborted, and for algorithms that are not RunGuarded
/// (AlgorithmGuard.h, which sets it).
std::string GetFailure(vtkAlgorithm* self);
VTKISTHMUSFILTERSCORE_EXPORT void SetFailure(vtkAlgorithm* self, const std::string& message);

/// A message of vtkErrorMacro or vtkWarningMacro without file, line, class and address.
std::string PlainMessage(const std::string& message);

/**
 * Updates `inner` and observes its errors. Otherwise a failure inside a filter would cause an empty
 * output without an error event of the filter that the user called.
 *
 * Errors of `inner` and of its executive are thrown, so that RunGuarded (AlgorithmGuard.h) reports
 * them as those of the outer filter; an abort by `progress` ends `inner`. `warn` is called with
 * each warning; without it VTK shows warnings as those of `inner`.
 * @throws std::runtime_error with the message of the first error; Cancelled.
 */
VTKISTHMUSFILTERSCORE_EXPORT void UpdateInner(vtkAlgorithm* inner,
  const ProgressCallback& progress = {}, const std::function<void(const std::string&)>& warn = {});

}

#endif
