/**
 * @file PocketOutput.h
 * @brief Pockets as VTK data: cells, table, mouths, alpha balls, lining residues and their atoms.
 */
#ifndef isthmus_PocketOutput_h
#define isthmus_PocketOutput_h

#include "Atoms/MoleculeAtoms.h"
#include "Pockets/Pocket.h"
#include "Pockets/PocketSurface.h"

class vtkPointSet;
class vtkPolyData;
class vtkTable;
class vtkUnstructuredGrid;

namespace isthmus
{

/// The data for the outputs: pockets by rank, and means of the surface (or none).
struct PocketReport
{
  const std::vector<Pocket>& Pockets;
  const std::vector<PocketSurfaceMeans>& Means;
  const MoleculeAtoms& Atoms;
};

void FillPocketCells(const PocketReport& report, vtkUnstructuredGrid* output);
void FillPocketTable(const PocketReport& report, vtkTable* output);
void FillMouths(const PocketReport& report, vtkPolyData* output);
void FillAlphaBalls(const PocketReport& report, vtkPolyData* output);
void FillLiningResidues(const PocketReport& report, vtkTable* output);

/// The surface with `SiteProbability` and `PocketId` (0: none); without a surface, `places` as
/// points with `SiteProbability`.
void FillSiteSurface(const PocketReport& report, const std::vector<SitePlace>& places,
  vtkPolyData* surface, vtkPolyData* output);

/// All atoms of the residues that line pocket number `shown` (0: any pocket), once for each of
/// their pockets, with the bonds of the input between them.
void FillLiningAtoms(
  const PocketReport& report, vtkPointSet* input, int shown, vtkPolyData* output);

}

#endif
