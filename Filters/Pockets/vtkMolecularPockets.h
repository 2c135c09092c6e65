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
 * Input 1 (optional): a surface with the point arrays `PolarizedCurvature` (PolarizedArray) and,
 * for the mean, `Potential` (PotentialArray; optional), as created by vtkPolarizedCurvature: then
 * each score is multiplied by the square root of the pocket's mean |polarized curvature| divided by
 * that of the whole surface.
 *
 * A pocket is space for a ball of InnerRadius that a ball of OuterRadius does not reach from
 * outside; the definitions are in MolecularPockets.h. The best pocket has the PocketId (and Rank)
 * 1.
 *
 * - **Output 0**, vtkUnstructuredGrid: the tetrahedra of the pockets, between centres of atoms.
 *   Cell arrays `PocketId`, `Clearance` (radius of the ball there that touches no atom),
 *   `AccessRadius` (of the largest ball that gets there from outside), `Burial` (atoms within
 *   BurialRadius), `EmptyVolume` (only sums are meaningful; at least 0 in a site),
 *   `SiteProbability` (probability that a ligand's atom is within 3 angstrom of the ball's centre;
 *   0 without sites). Point array `AtomId`: the point of the input.
 * - **Output 1**, vtkTable: one row per pocket: `Rank`, `Probability` (that the centre is within 4
 *   angstrom of a ligand; NaN without sites), `Score` (angstrom^3 x (atoms/100)^2), `CenterX`,
 *   `CenterY`, `CenterZ`, `Volume` (angstrom^3) and `Area` (angstrom^2) accessible to the probe's
 *   centre, `Mouths` (0: a void), `MouthRadius` (of the widest), `MouthArea`, `Radius` (of the
 *   largest ball), `PolarShare`, `ApolarShare` (fractions of Area on N and O, and on other atoms),
 *   `LiningAtoms`, `Cells`, `Parent` (of a site; 0: in no pocket), `CopyOf` (rank of the first of
 *   the sites at this place in copies of the chain, or the site's own rank if it is the first; 0
 *   without sites; SiteCopies.h), `MeanPotential` (kT/e), `MeanPolarized` (kT/(e angstrom), of the
 *   absolute value); NaN if not known; `Residues` (names of the lining residues, those with the
 *   largest area first). Field data: `AccessibleArea`, `AccessibleVolume` of the whole molecule.
 * - **Output 2**, vtkPolyData: triangles of the mouths; `PocketId`, `MouthId`, `Clearance`.
 * - **Output 3**, vtkPolyData: alpha balls, points with `PocketId`, `Radius`, `AccessRadius`,
 *   `Burial`.
 * - **Output 4**, vtkTable: lining residues: `PocketId`, `Chain`, `ResidueId`, `InsertionCode`,
 *   `ResidueName`, `Atoms` (names), `AtomIds` (points of the input), `NumberOfAtoms`, `Area`.
 * - **Output 5**, vtkPolyData: all atoms of those residues, with their bonds, the input's point
 *   arrays, `ResidueLabel` (at one atom of each residue) and `PocketId`; for all pockets, or for
 *   ShownPocket only.
 * - **Output 6**, vtkPolyData: input 1 with `SiteProbability` (SiteProbabilities in
 *   PocketSurface.h) and `PocketId` (0: none); without input 1, the centres of the tetrahedra
 *   evaluated by the site model, as points with `SiteProbability`.
 *
 * **Errors** (message, empty outputs): neither radii nor elements, radii or positions out of range,
 * options that are not lengths or contradict each other, a surface without polarized curvature or
 * in a different place than the atoms (InputOverlap.h). Fewer than four atoms, or atoms in one
 * plane, have no pockets; their `AccessibleArea` and `AccessibleVolume` are computed. Of coinciding
 * atoms, the larger one is used.
 *
 * **Cost.** See README.md, for example for 1AON (58,674 atoms). Results are bitwise the same on any
 * number of threads and for any order of the atoms. With several MPI ranks, gather the atoms first.
 */
#ifndef vtkMolecularPockets_h
#define vtkMolecularPockets_h

#include "Core/ArrayProperty.h"
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

  /// Point array of the radii, as ParaView's panel sets it; see ArrayProperty.h. Default `Radius`.
  ISTHMUS_ARRAY_PROPERTY(RadiusArray, 0);

  ///@{
  /// The surface with polarized curvature, optional: input 1.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(1, surface); }
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /// Radius of the probe that defines the accessible volume and area: those that its centre can
  /// reach. Default: 1.4 angstrom, water.
  vtkSetMacro(ProbeRadius, double);
  vtkGetMacro(ProbeRadius, double);
  ///@}

  ///@{
  /// Radius of the ball that fits into a pocket. Default: 1.7 angstrom, a carbon atom.
  vtkSetMacro(InnerRadius, double);
  vtkGetMacro(InnerRadius, double);
  ///@}

  ///@{
  /// Radius of the ball that does not get into a pocket from outside. Default: 3.1 angstrom.
  vtkSetMacro(OuterRadius, double);
  vtkGetMacro(OuterRadius, double);
  ///@}

  ///@{
  /// Radius within which atoms are counted for the burial of a place. Default: 10 angstrom.
  vtkSetMacro(BurialRadius, double);
  vtkGetMacro(BurialRadius, double);
  ///@}

  ///@{
  /// Volume below which a pocket is dropped. Default: 10 angstrom^3.
  vtkSetMacro(MinimumVolume, double);
  vtkGetMacro(MinimumVolume, double);
  ///@}

  ///@{
  /// Whether pockets are divided into sites of the size of a ligand, ranked by their probability
  /// (if the atoms have names and elements). Off: whole pockets, ranked by Score. Default: on.
  vtkSetMacro(FindSites, bool);
  vtkGetMacro(FindSites, bool);
  vtkBooleanMacro(FindSites, bool);
  ///@}

  ///@{
  /// Whether output 6, without input 1, has the point array `SiteDescriptors`, from which the
  /// probability of each place is computed. Default: off.
  vtkSetMacro(KeepDescriptors, bool);
  vtkGetMacro(KeepDescriptors, bool);
  vtkBooleanMacro(KeepDescriptors, bool);
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
  vtkSetMacro(PolarizedArray, std::string);
  vtkGetMacro(PolarizedArray, std::string);
  vtkSetMacro(PotentialArray, std::string);
  vtkGetMacro(PotentialArray, std::string);
  ///@}

  ///@{
  /// Residues and atoms that count as part of the molecule in addition to its chains. Default:
  /// none.
  vtkSetMacro(KeepHydrogens, bool);
  vtkGetMacro(KeepHydrogens, bool);
  vtkBooleanMacro(KeepHydrogens, bool);
  vtkSetMacro(KeepWaters, bool);
  vtkGetMacro(KeepWaters, bool);
  vtkBooleanMacro(KeepWaters, bool);
  vtkSetMacro(KeepIons, bool);
  vtkGetMacro(KeepIons, bool);
  vtkBooleanMacro(KeepIons, bool);
  vtkSetMacro(KeepLigands, bool);
  vtkGetMacro(KeepLigands, bool);
  vtkBooleanMacro(KeepLigands, bool);
  vtkSetMacro(KeepProstheticGroups, bool);
  vtkGetMacro(KeepProstheticGroups, bool);
  vtkBooleanMacro(KeepProstheticGroups, bool);
  ///@}

  ///@{
  /// Names of further residues to keep, separated by spaces or commas. Default: none.
  vtkSetMacro(KeepResidues, std::string);
  vtkGetMacro(KeepResidues, std::string);
  ///@}

  ///@{
  /// The pocket whose residues output 5 contains; 0 (default): all pockets.
  vtkSetMacro(ShownPocket, int);
  vtkGetMacro(ShownPocket, int);
  ///@}

  vtkTable* GetPocketTable();
  vtkPolyData* GetMouths();
  vtkPolyData* GetAlphaBalls();
  vtkTable* GetLiningResidues();
  vtkPolyData* GetLiningAtoms();
  vtkPolyData* GetSiteSurface();

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
  struct Cache;
  std::unique_ptr<Cache> Kept;

  double ProbeRadius = 1.4;
  double InnerRadius = 1.7;
  double OuterRadius = 3.1;
  double BurialRadius = 10.0;
  double MinimumVolume = 10.0;
  bool FindSites = true;
  bool KeepDescriptors = false;
  bool UsePolarizedCurvature = true;
  std::string PolarizedArray = "PolarizedCurvature";
  std::string PotentialArray = "Potential";
  bool KeepHydrogens = false;
  bool KeepWaters = false;
  bool KeepIons = false;
  bool KeepLigands = false;
  bool KeepProstheticGroups = false;
  std::string KeepResidues;
  int ShownPocket = 0;
};

#endif
