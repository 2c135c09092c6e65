/**
 * @class   vtkForceFieldCharges
 * @brief   charges, radii and hydrogens of a force field for atoms of a PDB or mmCIF file
 *
 * Input: atoms with names, any vtkPointSet, for example from vtkMacromoleculeReader for a PDB or
 * mmCIF file. Output, of the same type: the atoms that the force field knows, with its hydrogens,
 * and the arrays of OutputArrayTable(). Atoms that already have charges (a PQR file) are returned
 * unchanged.
 *
 * The program pdb2pqr has to be installed (ProteinCharges.h); vtkPoissonBoltzmann calls it in the
 * same way. It runs in a temporary folder on a file of the atoms in memory: the user's files are
 * neither read nor written. Protonation states are those of the force field at pH 7. Water is
 * dropped; so are residues that the force field does not know (ligands, ions, modified residues),
 * and one warning names them. There is no fallback for their charges: PEOE needs bond orders and
 * hydrogens, which these files do not have.
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

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkForceFieldCharges();
  ~vtkForceFieldCharges() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkForceFieldCharges(const vtkForceFieldCharges&) = delete;
  void operator=(const vtkForceFieldCharges&) = delete;

  int ForceField = AMBER;
  std::unique_ptr<isthmus::ForceFieldAtomsCache> Cache;
};

#endif
