/**
 * @file PoreOutput.h
 * @brief Pores as VTK data: polylines, tables, bottlenecks, lining residues and atoms, tubes.
 */
#ifndef isthmus_PoreOutput_h
#define isthmus_PoreOutput_h

#include "Pockets/LiningResidues.h"
#include "Pockets/Pore.h"

class vtkPointSet;
class vtkPolyData;
class vtkTable;

namespace isthmus
{

struct PoreReport
{
  const std::vector<Pore>& Pores;
  const MoleculeAtoms& Atoms;
};

void FillPoreLines(const PoreReport& report, vtkPolyData* output);
void FillPoreSamples(const PoreReport& report, vtkTable* output);
void FillPoreTable(const PoreReport& report, vtkTable* output);
void FillBottlenecks(const PoreReport& report, vtkPolyData* output);

/// For each pore, the residues with an atom that is within 0.5 angstrom of touching one of its
/// balls.
std::vector<std::vector<LiningResidue>> PoreLining(const PoreReport& report);
void FillPoreLining(const PoreReport& report,
  const std::vector<std::vector<LiningResidue>>& residues, vtkTable* output);

/// All atoms of those residues, once for each of their pores, with the bonds of the input between
/// them.
void FillPoreLiningAtoms(const PoreReport& report,
  const std::vector<std::vector<LiningResidue>>& residues, vtkPointSet* input, vtkPolyData* output);

/// Tubes around the lines with the radius of the array Radius.
void FillTubes(vtkPolyData* lines, vtkPolyData* output);

}

#endif
