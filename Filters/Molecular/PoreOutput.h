/**
 * @file PoreOutput.h
 * @brief Pores as VTK data: polylines, tables, bottlenecks, lining residues, tubes.
 */
#ifndef isthmus_PoreOutput_h
#define isthmus_PoreOutput_h

#include "AtomInput.h"
#include "PoreParameters.h"

class vtkPolyData;
class vtkTable;

namespace isthmus
{

struct PoreReport
{
  const std::vector<Pore>& Pores;
  const ChosenAtoms& Atoms;
};

void FillPoreLines(const PoreReport& report, vtkPolyData* output);
void FillPoreSamples(const PoreReport& report, vtkTable* output);
void FillPoreTable(const PoreReport& report, vtkTable* output);
void FillBottlenecks(const PoreReport& report, vtkPolyData* output);

/// Residues with an atom that touches one of the pore's balls, nearly: within 0.5 angstrom.
void FillPoreLining(const PoreReport& report, vtkTable* output);

/// Tubes around the lines, as wide as their Radius.
void FillTubes(vtkPolyData* lines, vtkPolyData* output);

}

#endif
