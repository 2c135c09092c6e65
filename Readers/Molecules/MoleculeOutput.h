/**
 * @file MoleculeOutput.h
 * @brief Converts a Macromolecule to VTK data, with the arrays documented in
 * vtkMacromoleculeReader.
 */
#ifndef isthmus_MoleculeOutput_h
#define isthmus_MoleculeOutput_h

class vtkMolecule;
class vtkPolyData;

namespace isthmus
{

struct Macromolecule;

/**
 * `atoms` gets points, vertices, bond lines, point arrays and field data; `molecule` the same
 * atoms, sharing points and arrays, and the bonds. Arrays are filled in parallel.
 * @throws std::runtime_error if VTK cannot create a molecule from them.
 */
void FillOutputs(
  const Macromolecule& from, bool withAltLoc, vtkPolyData* atoms, vtkMolecule* molecule);

}

#endif
