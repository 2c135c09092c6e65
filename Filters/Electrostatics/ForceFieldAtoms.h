/**
 * @file ForceFieldAtoms.h
 * @brief Assigns charges of a force field to the atoms of a file without charges (PDB, mmCIF).
 */
#ifndef isthmus_ForceFieldAtoms_h
#define isthmus_ForceFieldAtoms_h

#include "Core/Cached.h"
#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "Electrostatics/ProteinCharges.h"

#include <vtkSmartPointer.h>

#include <string>
#include <tuple>
#include <vector>

class vtkPointSet;

namespace isthmus
{

/// Names of point arrays.
struct ChargeArrays
{
  std::string Charge, Radius;
};

/// Whether the charges are missing, or NaN for most atoms (as in files with formal charges only),
/// while the names of atoms and residues allow looking them up.
bool LacksCharges(vtkPointSet* atoms, const ChargeArrays& arrays);

/// `protein` as points of the kind of `atoms`: the arrays `arrays` names, AtomName, Element,
/// InputAtom (the point of the input; -1: new), and of the input's those that a residue has.
vtkSmartPointer<vtkPointSet> CopyAtomsWithCharges(
  const ChargedProtein& protein, vtkPointSet* atoms, const ChargeArrays& arrays);

/// Largest distance of hydrogens beyond the balls of the atoms to which they are bonded, in
/// angstrom.
constexpr double HydrogenMargin = 2.0;

/// The atoms to which pdb2pqr may assign charges, i.e. all except water, as balls of 2 angstrom
/// with charge 0, and of 9 angstrom around CA if a side chain is incomplete and will be rebuilt.
/// They are used only for the extent of a grid.
std::vector<ChargedAtom> PolymerWithoutCharges(vtkPointSet* atoms);

/// Computes the charges, or the reason why there are none, once for each input and force field.
class ForceFieldAtomsCache
{
public:
  /// `ligands`: molecules with charges for what the force field does not know, with the arrays
  /// Charge and Radius; null: none. @throws what ChargeProtein does, and std::invalid_argument for
  /// ligands without charges.
  vtkPointSet* Get(vtkPointSet* atoms, vtkPointSet* ligands, const ChargeArrays& arrays,
    const ChargeOptions& options, const ProgressCallback& progress);
  /// Of the last call of Get().
  std::string Warning() { return this->Cache.Last() ? this->Cache.Last()->Warning : std::string(); }
  std::vector<std::string> Notes()
  {
    return this->Cache.Last() ? this->Cache.Last()->Notes : std::vector<std::string>();
  }

private:
  struct Outcome
  {
    vtkSmartPointer<vtkPointSet> Atoms; ///< null: Failure says why
    std::string Warning, Failure;
    std::vector<std::string> Notes;
  };
  Cached<std::tuple<ObjectState, ObjectState, std::string, std::string, ChargeTable, bool, double>,
    Outcome>
    Cache;
};

}

#endif
