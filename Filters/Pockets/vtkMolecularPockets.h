/**
 * @class   vtkMolecularPockets
 * @brief   Finds and ranks pockets and voids of a molecule, with their mouths and the residues that
 * line them.
 *
 * Input 0: atoms, i.e. points with the array `Radius` (input array 0), as created by
 * vtkMacromoleculeReader. If the atoms have names, water, ions, ligands and hydrogens are dropped;
 * modified residues and other residues linked into a chain are kept (PolymerAtoms.h). The field
 * array `Notes` of outputs 0 and 1 lists what was dropped. If the points have no names, all of them
 * are used.
 *
 * Input 1 (optional): a surface with the point arrays `PolarizedCurvature` (PolarizedArrayName)
 * and, for the mean, `Potential` (PotentialArrayName; optional), as created by
 * vtkPolarizedCurvature: then each score is multiplied by the square root of the pocket's mean
 * |polarized curvature| divided by that of the whole surface.
 *
 * A pocket is space for a ball of InnerRadius that a ball of OuterRadius does not reach from
 * outside; the definitions are in MolecularPockets.h. The best pocket has the PocketId (and Rank)
 * 1.
 *
 * - **Output 0**, vtkUnstructuredGrid: the tetrahedra of the pockets, between centers of atoms.
 * - **Output 1**, vtkTable: one row per pocket; unknown values are NaN.
 * - **Output 2**, vtkPolyData: triangles of the mouths.
 * - **Output 3**, vtkPolyData: alpha balls.
 * - **Output 4**, vtkTable: lining residues.
 * - **Output 5**, vtkPolyData: all atoms of those residues, with their bonds and the input's point
 *   arrays; for all pockets, or for ShownPocket only.
 * - **Output 6**, vtkPolyData: input 1 with the probability of a site (SiteProbabilities in
 *   PocketSurface.h); without input 1, the centers of the tetrahedra evaluated by the site model,
 *   as points.
 *
 * OutputArrayTable() lists their arrays.
 *
 * **Errors** (message, empty outputs): neither radii nor elements, radii or positions out of range,
 * options that are not lengths or contradict each other, a surface without polarized curvature or
 * in a different place than the atoms (InputOverlap.h). Fewer than four atoms, or atoms in one
 * plane, have no pockets; their `AccessibleArea` and `AccessibleVolume` are computed. Of coinciding
 * atoms, the larger one is used.
 *
 * **Cost.** O(n log n); 2 KB per atom. Results are bitwise the same on any number of threads and
 * for any order of the atoms. With several MPI ranks, gather the atoms first.
 */
#ifndef vtkMolecularPockets_h
#define vtkMolecularPockets_h

#include "Core/ArrayProperty.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Pockets/Pocket.h"
#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro
#include "vtkUnstructuredGridAlgorithm.h"

#include <memory>
#include <string> // for the properties

class vtkAlgorithmOutput;
class vtkPointSet;
class vtkPolyData;
class vtkTable;

class VTKISTHMUSFILTERSPOCKETS_EXPORT vtkMolecularPockets : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkMolecularPockets* New();
  vtkTypeMacro(vtkMolecularPockets, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the radii, `Radius` by default.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  ///@{
  /// The surface with polarized curvature, optional: input 1.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(1, surface); }
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /// Radius of the probe that defines the accessible volume and area: those that its center can
  /// reach. Default: 1.4 angstrom, water.
  ISTHMUS_PARAMETER(ProbeRadius, double);
  ///@}

  ///@{
  /// Radius of the ball that fits into a pocket. Default: 1.7 angstrom, a carbon atom.
  ISTHMUS_PARAMETER(InnerRadius, double);
  ///@}

  ///@{
  /// Radius of the ball that does not get into a pocket from outside. Default: 3.1 angstrom.
  ISTHMUS_PARAMETER(OuterRadius, double);
  ///@}

  ///@{
  /// Radius within which atoms are counted for the burial of a place. Default: 10 angstrom.
  ISTHMUS_PARAMETER(BurialRadius, double);
  ///@}

  ///@{
  /// Volume below which a pocket is dropped. Default: 10 angstrom^3.
  ISTHMUS_PARAMETER(MinimumVolume, double);
  ///@}

  ///@{
  /// Whether pockets are divided into sites of the size of a ligand, ranked by their probability
  /// (if the atoms have names and elements). Off: whole pockets, ranked by Score. Default: on.
  vtkSetMacro(FindSites, bool);
  vtkGetMacro(FindSites, bool);
  vtkBooleanMacro(FindSites, bool);
  ///@}

  ///@{
  /// Whether the atoms repeat by their periodic cell (field array `CellVectors`): a pocket is then
  /// space of the crystal that a ball of OuterRadius does not reach from infinitely far, it is
  /// listed once, and there are no sites. All atoms of the cell must be in the input: that of a
  /// protein's file holds one asymmetric unit, whose pockets are those of the molecule. Default:
  /// off.
  vtkSetMacro(UsePeriodicCell, bool);
  vtkGetMacro(UsePeriodicCell, bool);
  vtkBooleanMacro(UsePeriodicCell, bool);
  ///@}

  ///@{
  /// Whether a surface on input 1 contributes to the score. Default: on.
  vtkSetMacro(UsePolarizedCurvature, bool);
  vtkGetMacro(UsePolarizedCurvature, bool);
  vtkBooleanMacro(UsePolarizedCurvature, bool);
  ///@}

  ///@{
  /// Names of the surface's point arrays. Default: PolarizedCurvature, Potential. (No input arrays:
  /// ParaView 5.11 does not support them on a second input.)
  vtkSetMacro(PolarizedArrayName, std::string);
  vtkGetMacro(PolarizedArrayName, std::string);
  vtkSetMacro(PotentialArrayName, std::string);
  vtkGetMacro(PotentialArrayName, std::string);
  ///@}

  ///@{
  /// Residues and atoms that count as part of the molecule in addition to its chains. Default:
  /// none.
  vtkSetMacro(IncludeHydrogens, bool);
  vtkGetMacro(IncludeHydrogens, bool);
  vtkBooleanMacro(IncludeHydrogens, bool);
  vtkSetMacro(IncludeWaters, bool);
  vtkGetMacro(IncludeWaters, bool);
  vtkBooleanMacro(IncludeWaters, bool);
  vtkSetMacro(IncludeIons, bool);
  vtkGetMacro(IncludeIons, bool);
  vtkBooleanMacro(IncludeIons, bool);
  vtkSetMacro(IncludeLigands, bool);
  vtkGetMacro(IncludeLigands, bool);
  vtkBooleanMacro(IncludeLigands, bool);
  vtkSetMacro(IncludeProstheticGroups, bool);
  vtkGetMacro(IncludeProstheticGroups, bool);
  vtkBooleanMacro(IncludeProstheticGroups, bool);
  ///@}

  ///@{
  /// Names of further residues to keep, separated by spaces or commas. Default: none.
  vtkSetMacro(IncludeResidues, std::string);
  vtkGetMacro(IncludeResidues, std::string);
  ///@}

  ///@{
  /// The pocket whose residues output 5 contains; 0 (default): all pockets.
  vtkSetMacro(ShownPocket, int);
  vtkGetMacro(ShownPocket, int);
  ///@}

  ///@{
  /// Residues of a predicted model with a confidence (point array `pLDDT`, 0 to 100) below this are
  /// left out. Default 0: none.
  vtkSetMacro(MinimumConfidence, double);
  vtkGetMacro(MinimumConfidence, double);
  ///@}

  vtkTable* GetPocketTable();
  vtkPolyData* GetMouths();
  vtkPolyData* GetAlphaBalls();
  vtkTable* GetLiningResidues();
  vtkPolyData* GetLiningAtoms();
  vtkPolyData* GetSiteSurface();

  /// The arrays that the filter adds to its outputs, and which of them are optional.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// Which optional arrays to make.
  ISTHMUS_OUTPUT_ARRAY_SELECTION();

protected:
  vtkMolecularPockets();
  ~vtkMolecularPockets() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMolecularPockets(const vtkMolecularPockets&) = delete;
  void operator=(const vtkMolecularPockets&) = delete;

  void Compute(vtkPointSet* atoms, vtkPolyData* surface, vtkInformationVector* outputs);

  /// The pockets of the last run, whatever their volume, and their inputs.
  class vtkInternals;
  std::unique_ptr<vtkInternals> Internals;

  isthmus::PocketOptions Parameters;
  bool FindSites = true;
  bool UsePeriodicCell = false;
  bool UsePolarizedCurvature = true;
  std::string PolarizedArrayName = "PolarizedCurvature";
  std::string PotentialArrayName = "Potential";
  bool IncludeHydrogens = false;
  bool IncludeWaters = false;
  bool IncludeIons = false;
  bool IncludeLigands = false;
  double MinimumConfidence = 0.0;
  bool IncludeProstheticGroups = false;
  std::string IncludeResidues;
  int ShownPocket = 0;
};

#endif
