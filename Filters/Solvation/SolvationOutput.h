/**
 * @file SolvationOutput.h
 * @brief A solvation surface as VTK data: surface, image, table of updates.
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

/// Of a flow that has run; the arrays are those that vtkSolvationSurface documents.
void FillSolvation(const SolvationFlow& flow, const std::vector<std::string>& notes,
  const SolvationOutputs& outputs, const ProgressCallback& progress);

}

#endif
