/**
 * @file MoleculeOutput.h
 * @brief A Macromolecule as VTK data, with the arrays that vtkMacromoleculeReader documents.
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
 * atoms, sharing points and arrays, and the bonds. Arrays are filled several at once.
 * @throws std::runtime_error where VTK makes no molecule of them.
 */
void FillOutputs(
  const Macromolecule& from, bool withAltLoc, vtkPolyData* atoms, vtkMolecule* molecule);

}

#endif
