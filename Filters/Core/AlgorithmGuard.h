/**
 * @file AlgorithmGuard.h
 * @brief What every VTK class does around its algorithm: input checks, progress, abort, exceptions to
 * error messages, empty outputs.
 */
#ifndef isthmus_AlgorithmGuard_h
#define isthmus_AlgorithmGuard_h

#include "Core/PipelineInputs.h"
#include "Core/Progress.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkInformationVector.h>

#include <exception>
#include <new>
#include <string>
#include <utility>

namespace isthmus
{

/**
 * Tells `sentence` through vtkErrorMacro, unless it is what `self` said last and nothing has
 * changed since: neither `self` nor what it stands on.
 *
 * A pipeline asks for information and for data, the window does so for each of its parts, and
 * composite data bring a block at a time; all of them meet the same obstacle.
 */
VTKISTHMUSFILTERSCORE_EXPORT void ReportError(vtkAlgorithm* self, const std::string& sentence);

/// Progress of `algorithm` as VTK shows it; stops when it, what contains it, or what comes before
/// it in the pipeline is told to. What comes after it then knows its output for a stopped one's.
inline ProgressCallback ProgressOf(vtkAlgorithm* algorithm)
{
  return [algorithm](double fraction)
  {
    algorithm->UpdateProgress(fraction);
    return !algorithm->CheckAbort();
  };
}

/// Null is what a filter has for a block of a kind that it can't even make.
inline void Clear(vtkDataObject* output)
{
  if (output)
  {
    output->Initialize();
  }
}

/// Empties all outputs.
inline void ClearAll(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    Clear(vtkDataObject::GetData(outputs, port));
  }
}

/**
 * Runs `body()`; true when it came to its end.
 *
 * Inputs of another type than asked for, as blocks of composite data can be, are refused first. A
 * stop on request leaves an empty output; an exception does, too, and its sentence is told once
 * (AlgorithmGuard.h).
 */
template <typename Body>
bool Succeeds(vtkAlgorithm* self, vtkDataObject* output, Body&& body)
{
  try
  {
    CheckInputs(self);
    body();
    return true;
  }
  catch (const Cancelled&)
  {
  }
  catch (const std::bad_alloc&)
  {
    ReportError(self, "Not enough memory for the result: crop or subsample the input.");
  }
  catch (const std::exception& error)
  {
    ReportError(self, error.what());
  }
  Clear(output);
  return false;
}

/// Runs `body()` likewise and returns what RequestData and RequestInformation should return, always
/// 1: 0 would have VTK's executive add a page about its request to the sentence, and leave what
/// stands on this output as it was before.
template <typename Body>
int Guarded(vtkAlgorithm* self, vtkDataObject* output, Body&& body)
{
  Succeeds(self, output, std::forward<Body>(body));
  return 1;
}

/// Guarded for a filter of several outputs: all are empty unless `body` comes to its end.
template <typename Body>
int GuardedOutputs(vtkAlgorithm* self, vtkInformationVector* outputs, Body&& body)
{
  ClearAll(outputs);
  if (!Succeeds(self, vtkDataObject::GetData(outputs, 0), std::forward<Body>(body)))
  {
    ClearAll(outputs);
  }
  return 1;
}

}

#endif
