/**
 * @file AlgorithmGuard.h
 * @brief Steps that every VTK class performs before and after its algorithm: input checks,
 * progress, abort, conversion of exceptions to error messages, empty outputs.
 */
#ifndef isthmus_AlgorithmGuard_h
#define isthmus_AlgorithmGuard_h

#include "Core/InnerAlgorithm.h"
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
 * Reports `message` through vtkErrorMacro, unless `self` reported the same message last and neither
 * `self` nor the upstream pipeline has been modified since.
 *
 * A pipeline requests information and then data, ParaView's window does so several times, and
 * composite data are processed block by block; all of these would report the same error.
 */
VTKISTHMUSFILTERSCORE_EXPORT void ReportError(vtkAlgorithm* self, const std::string& message);

/// Progress of `algorithm` as VTK shows it; aborts the computation when the algorithm, its
/// container, or an upstream algorithm is aborted. Downstream algorithms then treat its output as
/// aborted.
inline ProgressCallback MakeProgress(vtkAlgorithm* algorithm)
{
  return [algorithm](double fraction)
  {
    algorithm->UpdateProgress(fraction);
    return !algorithm->CheckAbort();
  };
}

/// Implementation of the functions below.
namespace guard
{

/// True if `body` completed; otherwise its exception is reported, unless it is Cancelled.
template <typename Body>
bool RunToEnd(vtkAlgorithm* self, Body&& body)
{
  SetFailure(self, {});
  try
  {
    CheckInputs(self);
    body();
    return true;
  }
  catch (const Cancelled&) // NOLINT(bugprone-empty-catch): an abort is no error
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

/// `output` is null for a block of a type that the filter cannot create.
inline void Clear(vtkDataObject* output)
{
  if (output)
  {
    output->Initialize();
  }
}

}

/// Empties all outputs. At the beginning of RequestData the outputs hold the field data of the
/// input, which VTK's executive copies there. Filters whose outputs differ in kind from the input
/// (a table of pockets is not a molecule) call this function first.
inline void ClearOutputs(vtkInformationVector* outputs)
{
  for (int port = 0; port < outputs->GetNumberOfInformationObjects(); ++port)
  {
    guard::Clear(vtkDataObject::GetData(outputs, port));
  }
}

/**
 * RunGuarded() for filters that need to know whether `body` completed.
 */
template <typename Body>
bool Succeeds(vtkAlgorithm* self, vtkInformationVector* outputs, Body&& body)
{
  const bool ends = guard::RunToEnd(self, std::forward<Body>(body));
  if (!ends)
  {
    ClearOutputs(outputs);
  }
  return ends;
}

/**
 * To be used in every filter's RequestData:
 *
 *     return isthmus::RunGuarded(this, outputVector, [&] { ... });
 *
 * Inputs of a type other than the filter requires (blocks of composite data can be of any type) and
 * arrays that are too short are refused first (PipelineInputs.h); then `body` runs. An exception is
 * reported as one error, once (ReportError). After an exception, and after an abort (Cancelled),
 * all outputs are empty.
 *
 * Always returns 1: after 0, VTK's executive would append a long description of its request to the
 * error, and leave downstream outputs unchanged instead of empty.
 */
template <typename Body>
int RunGuarded(vtkAlgorithm* self, vtkInformationVector* outputs, Body&& body)
{
  Succeeds(self, outputs, std::forward<Body>(body));
  return 1;
}

/// The same for a single data object, which readers fill: it is empty unless `body` completes.
template <typename Body>
int RunGuarded(vtkAlgorithm* self, vtkDataObject* output, Body&& body)
{
  if (!guard::RunToEnd(self, std::forward<Body>(body)))
  {
    guard::Clear(output);
  }
  return 1;
}

}

#endif
