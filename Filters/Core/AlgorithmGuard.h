/**
 * @file AlgorithmGuard.h
 * @brief What every VTK class does around its algorithm: input checks, progress, abort, exceptions
 * to error messages, empty outputs.
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
 * Reports `message` through vtkErrorMacro, unless it is what `self` reported last and nothing has
 * changed since: neither `self` nor what precedes it in the pipeline.
 *
 * A pipeline requests information and then data, the window does so for each of its parts, and
 * composite data bring a block at a time; all of them meet the same obstacle.
 */
VTKISTHMUSFILTERSCORE_EXPORT void ReportError(vtkAlgorithm* self, const std::string& message);

/// Progress of `algorithm` as VTK shows it; aborts the computation when the algorithm, what
/// contains it, or what precedes it in the pipeline is aborted. What follows it in the pipeline
/// then treats its output as aborted.
inline ProgressCallback ProgressOf(vtkAlgorithm* algorithm)
{
  return [algorithm](double fraction)
  {
    algorithm->UpdateProgress(fraction);
    return !algorithm->CheckAbort();
  };
}

/// What the functions below are made of.
namespace guard
{

/// True when `body` came to its end; else its exception is reported, unless it is Cancelled.
template <typename Body>
bool Ends(vtkAlgorithm* self, Body&& body)
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
  return false;
}

/// Null is what a filter has for a block of a type that it cannot even create.
inline void Clear(vtkDataObject* output)
{
  if (output)
  {
    output->Initialize();
  }
}

}

/// Empties all outputs. At the beginning of RequestData they hold the field data of the input,
/// which VTK's executive copies there: filters whose outputs are not the input's kind of thing (a
/// pocket's table is no molecule) call it first.
inline void ClearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    guard::Clear(vtkDataObject::GetData(outputs, port));
  }
}

/**
 * Guarded for filters that have to know whether `body` came to its end.
 */
template <typename Body>
bool Succeeds(vtkAlgorithm* self, vtkInformationVector* outputs, Body&& body)
{
  const bool ends = guard::Ends(self, std::forward<Body>(body));
  if (!ends)
  {
    ClearOutputs(outputs);
  }
  return ends;
}

/**
 * The frame of every filter's RequestData:
 *
 *     return isthmus::Guarded(this, outputVector, [&] { ... });
 *
 * Inputs of another type than the filter requires, as blocks of composite data can be, and arrays
 * that are too short are refused first (PipelineInputs.h); then `body` runs. An exception is
 * reported as one error, once (ReportError). After an exception, and after an abort (Cancelled),
 * all outputs are empty.
 *
 * Returns 1 always: after 0 VTK's executive would add a page about its request to the error, and
 * leave what follows in the pipeline as it was before, instead of empty.
 */
template <typename Body>
int Guarded(vtkAlgorithm* self, vtkInformationVector* outputs, Body&& body)
{
  Succeeds(self, outputs, std::forward<Body>(body));
  return 1;
}

/// The same for an object that is no output's, or one output's only, as RequestInformation fills:
/// it is empty unless `body` comes to its end.
template <typename Body>
int Guarded(vtkAlgorithm* self, vtkDataObject* output, Body&& body)
{
  if (!guard::Ends(self, std::forward<Body>(body)))
  {
    guard::Clear(output);
  }
  return 1;
}

}

#endif
