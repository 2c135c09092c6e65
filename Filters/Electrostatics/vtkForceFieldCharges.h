/**
 * @class   vtkForceFieldCharges
 * @brief   charges, radii and hydrogens of a force field for atoms of a PDB or mmCIF file
 *
 * Input: atoms with names, any vtkPointSet, for example from vtkMacromoleculeReader for a PDB or
 * mmCIF file. Output, of the same type: the atoms that the force field knows, with its hydrogens,
 * and the arrays of OutputArrayTable(). Atoms that already have charges (a PQR file) are returned
 * unchanged.
 *
 * Input 1 (optional): a molecule with charges and radii, for example of a MOL2 or PQR file, for
 * residues that the force field does not know. Residues whose heavy atoms are at its places, or
 * have its names of residue and atoms, get its charges (ProteinCharges.h).
 *
 * The program pdb2pqr has to be installed (ProteinCharges.h); vtkPoissonBoltzmann calls it in the
 * same way. It runs in a temporary folder on a file of the atoms in memory: the user's files are
 * neither read nor written. Protonation states are those of the force field at pH 7, or those of
 * PROPKA at PH. Water is dropped; so are residues that the force field does not know (ligands,
 * ions, modified residues), unless input 1 has them. What came back is compared with what was sent:
 * one warning lists these residues, with the formal charges of the file, and all other heavy atoms
 * that were left out or built. Hydrogens with unknown names are listed in the field data `Notes`.
 *
 * **Errors** (one message, empty output): pdb2pqr is not installed, fails or takes more than ten
 * minutes; atoms without names of residues and without charges; coordinates that are not finite;
 * more chains or residues than a PDB file can contain.
 *
 * **Cost.** That of pdb2pqr, some seconds. The result is cached until the atoms change. On several
 * MPI ranks, gather the atoms first.
 */
#ifndef vtkForceFieldCharges_h
#define vtkForceFieldCharges_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h" // for the export macro
#include "vtkPointSetAlgorithm.h"

#include <memory> // for what is shared between executions

namespace isthmus
{
class ForceFieldAtomsCache;
}

class VTKISTHMUSFILTERSELECTROSTATICS_EXPORT vtkForceFieldCharges : public vtkPointSetAlgorithm
{
public:
  static vtkForceFieldCharges* New();
  vtkTypeMacro(vtkForceFieldCharges, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ForceFields
  {
    AMBER = 0,
    PARSE = 1
  };

  ///@{
  /// AMBER (default; Cornell et al. 1995) or PARSE (Sitkoff et al. 1994).
  vtkSetMacro(ForceField, int);
  vtkGetMacro(ForceField, int);
  ///@}

  ///@{
  /// Protonation states by PROPKA at PH, instead of those of the force field at pH 7. Default off.
  vtkSetMacro(UsePropka, bool);
  vtkGetMacro(UsePropka, bool);
  vtkBooleanMacro(UsePropka, bool);
  ///@}

  ///@{
  /// pH, 0 to 14, for UsePropka. Default 7.
  vtkSetMacro(PH, double);
  vtkGetMacro(PH, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkForceFieldCharges();
  ~vtkForceFieldCharges() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkForceFieldCharges(const vtkForceFieldCharges&) = delete;
  void operator=(const vtkForceFieldCharges&) = delete;

  int ForceField = AMBER;
  bool UsePropka = false;
  double PH = 7.0;
  std::unique_ptr<isthmus::ForceFieldAtomsCache> Cache;
};

#endif
