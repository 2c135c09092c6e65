/**
 * @file AlgorithmGuard.h
 * @brief What every vtk class of ours does around its algorithm: report, stop, turn errors to
 * words.
 */
#ifndef isthmus_AlgorithmGuard_h
#define isthmus_AlgorithmGuard_h

#include "PipelineInputs.h"
#include "PrintableText.h"
#include "Progress.h"

#include <vtkAlgorithm.h>
#include <vtkDataObject.h>
#include <vtkInformationVector.h>
#include <vtkObject.h>

#include <exception>
#include <new>

namespace isthmus
{

/// Progress of `algorithm` as VTK shows it; stops when VTK's abort flag is set.
inline ProgressCallback ProgressOf(vtkAlgorithm* algorithm)
{
  return [algorithm](double fraction)
  {
    algorithm->UpdateProgress(fraction);
    return algorithm->GetAbortExecute() == 0;
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
 * Runs `body()` and returns what RequestData should return.
 *
 * Inputs of another type than asked for, as blocks of composite data can be, are refused first. A
 * stop on request gives 1 and an empty output; an exception gives 0, an empty output and its
 * sentence through vtkErrorMacro.
 */
template <typename Body>
int Guarded(vtkAlgorithm* self, vtkDataObject* output, Body&& body)
{
  try
  {
    DemandInputs(self);
    body();
    return 1;
  }
  catch (const Cancelled&)
  {
    Clear(output);
    return 1;
  }
  catch (const std::bad_alloc&)
  {
    vtkErrorWithObjectMacro(
      self, << "Not enough memory for the result: crop or subsample the input.");
  }
  catch (const std::exception& error)
  {
    vtkErrorWithObjectMacro(self, << Printable(error.what()));
  }
  Clear(output);
  return 0;
}

/// Guarded for a filter of several outputs: all are empty unless `body` comes to its end.
template <typename Body>
int GuardedOutputs(vtkAlgorithm* self, vtkInformationVector* outputs, Body&& body)
{
  ClearAll(outputs);
  bool whole = false;
  const int result = Guarded(self, vtkDataObject::GetData(outputs, 0),
    [&]()
    {
      body();
      whole = true;
    });
  if (!whole)
  {
    ClearAll(outputs);
  }
  return result;
}

}

#endif
