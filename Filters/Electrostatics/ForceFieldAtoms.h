/**
 * @file ForceFieldAtoms.h
 * @brief Atoms of a file without charges (PDB, mmCIF) as atoms with a force field's.
 */
#ifndef isthmus_ForceFieldAtoms_h
#define isthmus_ForceFieldAtoms_h

#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "Electrostatics/ProteinCharges.h"

#include <vtkSmartPointer.h>
#include <vtkType.h>

class vtkPointSet;

namespace isthmus
{

/// Names of point arrays.
struct ChargeArrays
{
  std::string Charge, Radius;
};

/// Whether the charges are missing, or NaN for most atoms (which the reader gives where a file has
/// formal charges only), and atoms and residues have names by which they could be found.
bool LacksCharges(vtkPointSet* atoms, const ChargeArrays& arrays);

/// `protein` as points of the kind of `atoms`: the arrays `arrays` names, AtomName, Element,
/// InputAtom (the point of the input; -1: new), and of the input's those that a residue has.
vtkSmartPointer<vtkPointSet> PointsOf(
  const ChargedProtein& protein, vtkPointSet* atoms, const ChargeArrays& arrays);

/// How far hydrogens may lie beyond the balls of the atoms that carry them, angstrom.
constexpr double HydrogenMargin = 2.0;

/// What pdb2pqr may charge of atoms that lack charges, all but water, as balls of 2 angstrom with
/// charge 0; of 9 around CA where a side chain is incomplete and will be rebuilt. Only for the
/// extent of a grid.
std::vector<ChargedAtom> PolymerWithoutCharges(vtkPointSet* atoms);

/// Charges, or the reason why there are none, are computed once for each input and force field.
class ForceFieldAtomsCache
{
public:
  /// @throws what ChargeProtein does.
  vtkPointSet* Get(vtkPointSet* atoms, const ChargeArrays& arrays, ChargeTable table,
    const ProgressCallback& progress);
  const std::string& Warning() const { return this->Warned; }

private:
  vtkPointSet* Input = nullptr; ///< to know it again by, no more
  vtkMTimeType Time = 0;
  ChargeTable Table = ChargeTable::AMBER;
  std::string Names;
  vtkSmartPointer<vtkPointSet> Charged;
  std::string Warned, Failure;
};

}

#endif
