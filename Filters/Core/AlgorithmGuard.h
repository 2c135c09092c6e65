/**
 * @file AlgorithmGuard.h
 * @brief What every vtk class of ours does around its algorithm: report, stop, turn errors to
 * words.
 */
#ifndef isthmus_AlgorithmGuard_h
#define isthmus_AlgorithmGuard_h

#include "Core/ErrorOnce.h"
#include "Core/PipelineInputs.h"
#include "Core/Progress.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkInformationVector.h>

#include <exception>
#include <new>
#include <utility>

namespace isthmus
{

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
 * (ErrorOnce.h).
 */
template <typename Body>
bool Succeeds(vtkAlgorithm* self, vtkDataObject* output, Body&& body)
{
  try
  {
    DemandInputs(self);
    body();
    return true;
  }
  catch (const Cancelled&)
  {
  }
  catch (const std::bad_alloc&)
  {
    TellError(self, "Not enough memory for the result: crop or subsample the input.");
  }
  catch (const std::exception& error)
  {
    TellError(self, error.what());
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
