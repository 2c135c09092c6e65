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

/// Points, vertices, bond lines, point arrays, field data.
void FillAtoms(const Macromolecule& molecule, bool withAltLoc, vtkPolyData* atoms);

/// The same atoms, sharing the points and arrays of `atoms`, and the bonds.
/// @throws std::runtime_error where VTK makes no molecule of them.
void FillMolecule(const Macromolecule& from, vtkPolyData* atoms, vtkMolecule* molecule);

}

#endif
