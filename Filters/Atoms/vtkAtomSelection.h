/**
 * @class   vtkAtomSelection
 * @brief   selection of atoms of a molecule: chains, ligands, ions, water
 *
 * Input: atoms with the names that vtkMacromoleculeReader gives them, any vtkPointSet. Output, of
 * the same type: the points that are kept, in the same order, with all point arrays and field data;
 * of a vtkPolyData also the cells (bonds, with their arrays) all of whose points are kept.
 *
 * Each residue is part of a chain of amino acids or nucleotides, an ion (one heavy atom), water, or
 * a ligand (anything else). The prosthetic groups (hemes, flavins, iron-sulphur clusters,
 * chlorophylls and the like) are ligands, but can be kept without the others. PolymerAtoms.h has
 * the rules. Of alternate locations the one with the greatest sum of occupancies is kept. If no
 * residue of a chain is recognised (e.g. in an XYZ file), all atoms except water count as a chain.
 *
 * **Errors** (one message, empty output): coordinates that are not finite. If a selection keeps
 * nothing, the output is empty and there is no error.
 *
 * **Cost.** O(n log n) in atoms. On several MPI ranks, gather the atoms first.
 */
#ifndef vtkAtomSelection_h
#define vtkAtomSelection_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersAtomsModule.h" // for the export macro
#include "vtkPointSetAlgorithm.h"

#include <string> // for IncludeResidues

class VTKISTHMUSFILTERSATOMS_EXPORT vtkAtomSelection : public vtkPointSetAlgorithm
{
public:
  static vtkAtomSelection* New();
  vtkTypeMacro(vtkAtomSelection, vtkPointSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  ///@{
  /// Names of residues that are always kept, separated by blanks or commas. Default: none.
  vtkSetMacro(IncludeResidues, std::string);
  vtkGetMacro(IncludeResidues, std::string);
  ///@}

  /// Chains of amino acids and nucleotides. Default on.
  ISTHMUS_SWITCH(IncludeChains, true);
  /// Ligands, prosthetic groups included. Default off.
  ISTHMUS_SWITCH(IncludeLigands, false);
  /// Hemes, flavins, iron-sulphur clusters and the like. Default off.
  ISTHMUS_SWITCH(IncludeProstheticGroups, false);
  /// Residues of one heavy atom. Default off.
  ISTHMUS_SWITCH(IncludeIons, false);
  /// Water. Default off.
  ISTHMUS_SWITCH(IncludeWaters, false);
  /// Hydrogens of what is kept. Default on.
  ISTHMUS_SWITCH(IncludeHydrogens, true);

protected:
  vtkAtomSelection() = default;
  ~vtkAtomSelection() override = default;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkAtomSelection(const vtkAtomSelection&) = delete;
  void operator=(const vtkAtomSelection&) = delete;

  void Select(vtkPointSet* atoms, vtkPointSet* output);

  std::string IncludeResidues;
};

#endif
