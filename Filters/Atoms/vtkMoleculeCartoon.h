/**
 * @class   vtkMoleculeCartoon
 * @brief   chains as ribbons and arrows, ligands as balls and sticks, and a table of residues
 *
 * Input: atoms with the names that vtkMacromoleculeReader gives them, any vtkPointSet; bonds are
 * the lines of a vtkPolyData. Of alternate locations the one with the greatest sum of occupancies
 * is drawn; hydrogens are not.
 *
 * **Output 0**, vtkPolyData: the cartoon of amino acids and nucleotides (MoleculeCartoon.h):
 * helices as ribbons, strands as arrows towards the C end, coil and nucleic acids as tubes, bases
 * as sticks. Gaps in a chain stay open. Cell arrays are of the residue that a polygon belongs to.
 *
 * **Output 1**, vtkPolyData: ligands, ions and what else is selected as balls and sticks, of each
 * bond a half for either atom. Cell arrays are of the atom.
 *
 * **Output 2**, vtkPolyData: a point and a vertex for each residue, at CA, C4' or P, else in the
 * middle of its atoms. OutputArrayTable() lists the arrays of all outputs.
 *
 * Secondary structure is that of the point array `SecondaryStructure`, which vtkMacromoleculeReader
 * takes from HELIX and SHEET records or their equivalent in mmCIF; without it, DSSP's by hydrogen
 * bonds (SecondaryStructure.h). The field array `Notes` states which was used, and what is not
 * drawn.
 *
 * **Errors** (one message, empty outputs): coordinates that are not finite, lengths that are not
 * positive, not enough memory. If no residue of a chain is recognised, output 1 has all atoms.
 *
 * **Cost.** O(n log n) in atoms. On several MPI ranks, gather the atoms first.
 */
#ifndef vtkMoleculeCartoon_h
#define vtkMoleculeCartoon_h

#include "Atoms/MoleculeCartoon.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersAtomsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <string> // for StickResidues

class vtkPointSet;

class VTKISTHMUSFILTERSATOMS_EXPORT vtkMoleculeCartoon : public vtkPolyDataAlgorithm
{
public:
  static vtkMoleculeCartoon* New();
  vtkTypeMacro(vtkMoleculeCartoon, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  ///@{
  /// Residues of chains that are drawn as sticks, too: names (HIS), numbers (57) or numbers with a
  /// chain (A:57), separated by blanks or commas. Default: none.
  vtkSetMacro(StickResidues, std::string);
  vtkGetMacro(StickResidues, std::string);
  ///@}

  ///@{
  /// Width and thickness of helices and strands, in angstrom; the diameter of coil is the
  /// thickness. Defaults 2.4 and
  /// 0.5.
  ISTHMUS_PARAMETER(RibbonWidth, double);
  ISTHMUS_PARAMETER(RibbonThickness, double);
  ///@}

  ///@{
  /// Radius of bonds, in angstrom. Default 0.2.
  ISTHMUS_PARAMETER(StickRadius, double);
  ///@}

  ///@{
  /// Radius of balls over the van der Waals radius; at least as thick as the sticks. Atoms without
  /// a bond have twice that. Default 0.25; 0: sticks only.
  ISTHMUS_PARAMETER(BallScale, double);
  ///@}

  ///@{
  /// Polygons around a tube, 3 to 64. Default 12.
  ISTHMUS_PARAMETER(Sides, int);
  ///@}

  vtkPolyData* GetSticks();   ///< Output 1.
  vtkPolyData* GetResidues(); ///< Output 2.

  /// Secondary structure by hydrogen bonds, even if the file has it. Default off.
  ISTHMUS_SWITCH(ComputeSecondaryStructure, false);
  /// Ligands, prosthetic groups included. Default on.
  ISTHMUS_SWITCH(IncludeLigands, true);
  /// Residues of one heavy atom. Default on.
  ISTHMUS_SWITCH(IncludeIons, true);
  /// Water. Default off.
  ISTHMUS_SWITCH(IncludeWaters, false);

protected:
  vtkMoleculeCartoon();
  ~vtkMoleculeCartoon() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMoleculeCartoon(const vtkMoleculeCartoon&) = delete;
  void operator=(const vtkMoleculeCartoon&) = delete;

  void Draw(vtkPointSet* atoms, vtkInformationVector* outputs);

  std::string StickResidues;
  isthmus::CartoonShape Parameters;
};

#endif
