/**
 * @file SolvationOutput.h
 * @brief Converts a solvation surface to VTK data: surface, image, table of updates.
 */
#ifndef isthmus_SolvationOutput_h
#define isthmus_SolvationOutput_h

#include "Solvation/SolvationFlow.h"

#include <string>
#include <vector>

class vtkImageData;
class vtkPolyData;
class vtkTable;

namespace isthmus
{

struct SolvationOutputs
{
  vtkPolyData* Surface;
  vtkImageData* Image;
  vtkTable* Updates;
};

/// For a flow that has run; the arrays are documented in vtkSolvationSurface.
void FillSolvation(const SolvationFlow& flow, const SolvationErrors& errors,
  const std::vector<std::string>& notes, const SolvationOutputs& outputs,
  const ProgressCallback& progress);

}

#endif
