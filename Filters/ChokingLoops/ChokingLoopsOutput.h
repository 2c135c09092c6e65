/**
 * @file ChokingLoopsOutput.h
 * @brief Choking loops as VTK data, for vtkChokingLoops.
 */
#ifndef isthmus_ChokingLoopsOutput_h
#define isthmus_ChokingLoopsOutput_h

#include "ChokingLoops/SharedLoops.h"

class vtkPolyData;
class vtkTable;

namespace isthmus
{

/// The outputs as documented in vtkChokingLoops.h.
void FillLoops(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output);
void FillMembranes(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output);
void FillChokePoints(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output);
void FillDiagram(const ChokingLoops& loops, vtkTable* output);

/// Facts about the analysis, as field data of the loops.
void FillFacts(
  const ChokingLoops& loops, const std::vector<ShownFeature>& features, vtkPolyData* output);

}

#endif
