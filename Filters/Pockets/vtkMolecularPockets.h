/**
 * @class   vtkMolecularPockets
 * @brief   pockets and voids of a molecule, ranked, with their mouths and the residues that line
 * them
 *
 * Input 0: atoms, points with the array `Radius` (input array 0), as vtkMacromoleculeReader makes
 * them. Where it gives names, water, ions and ligands are dropped, and so are hydrogens; modified
 * residues and what else is linked into a chain stay (PolymerAtoms.h). The field array `Notes` of
 * outputs 0 and 1 says what was dropped. Points without names are all taken.
 *
 * Input 1 (optional): a surface with the point arrays `PolarizedCurvature` (PolarizedArray) and,
 * for the mean, `Potential` (PotentialArray; optional), as vtkPolarizedCurvature makes it: then
 * each score is multiplied by the square root of the pocket's mean |polarized curvature| over the
 * surface's.
 *
 * A pocket is space for a ball of InnerRadius that a ball of OuterRadius does not reach from
 * outside; MolecularPockets.h has the definitions. The best pocket has the PocketId (and Rank) 1.
 *
 * - **Output 0**, vtkUnstructuredGrid: the tetrahedra of the pockets, between centres of atoms.
 *   Cell arrays `PocketId`, `Clearance` (radius of the ball there that touches no atom),
 *   `AccessRadius` (of the largest that gets there from outside), `Burial` (atoms within
 *   BurialRadius), `EmptyVolume` (only sums mean anything; of a site, at least 0),
 * `SiteProbability` (that a ligand's atom is within 3 angstrom of the ball's centre; 0 without
 * sites). Point array `AtomId`: the input's point.
 * - **Output 1**, vtkTable: a row for each pocket: `Rank`, `Probability` (that the centre is within
 *   4 angstrom of a ligand; NaN without sites), `Score` (angstrom^3 x (atoms/100)^2),
 *   `CenterX`, `CenterY`, `CenterZ`, `Volume` (angstrom^3) and `Area` (angstrom^2) accessible to
 *   the probe's centre, `Mouths` (0: a void), `MouthRadius` (of the widest), `MouthArea`, `Radius`
 *   (of the largest ball), `PolarShare`, `ApolarShare` (of Area, on N and O, and on the rest),
 *   `LiningAtoms`, `Cells`, `Parent` (of a site; 0: in no pocket), `CopyOf` (rank of the first site
 * at this place of a copy of the chain, SiteCopies.h, its own if that is it; 0 without sites),
 * `MeanPotential` (kT/e), `MeanPolarized` (kT/(e angstrom), of the absolute value); NaN where not
 * known. Field data: `AccessibleArea`, `AccessibleVolume` of the whole molecule.
 * - **Output 2**, vtkPolyData: triangles of the mouths; `PocketId`, `MouthId`, `Clearance`.
 * - **Output 3**, vtkPolyData: alpha balls, points with `PocketId`, `Radius`, `AccessRadius`,
 *   `Burial`.
 * - **Output 4**, vtkTable: lining residues: `PocketId`, `Chain`, `ResidueId`, `InsertionCode`,
 *   `ResidueName`, `Atoms` (names), `AtomIds` (points of the input), `NumberOfAtoms`, `Area`.
 * - **Output 5**, vtkPolyData: those residues whole, with their bonds, the input's point arrays,
 *   `ResidueLabel` (at one atom of each) and `PocketId`; all of them, or those of ShownPocket.
 * - **Output 6**, vtkPolyData: input 1 with `SiteProbability` (SiteProbabilities in
 * PocketSurface.h) and `PocketId` (0: none); without input 1, the centres of the tetrahedra that
 * were judged, points with `SiteProbability`.
 *
 * **Errors** (message, empty outputs): no radii and no elements, radii or places out of range,
 * options that are no lengths or contradict each other, a surface without polarized curvature or
 * elsewhere than the atoms (InputOverlap.h). No atoms, fewer than four, or all in one plane: no
 * pockets. Coinciding atoms: the larger counts.
 *
 * **Cost.** 1AON (58,674 atoms): see README.md. Bitwise the same on any number of threads and for
 * any order of the atoms. On several MPI ranks, gather the atoms first.
 */
#ifndef vtkMolecularPockets_h
#define vtkMolecularPockets_h

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

  ///@{
  /// The surface with polarized curvature, optional: input 1.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(1, surface); }
  void SetSurfaceData(vtkPolyData* surface);
  ///@}

  ///@{
  /// Radius of the probe whose centre volumes and areas are accessible to. Default: 1.4 angstrom,
  /// water.
  vtkSetMacro(ProbeRadius, double);
  vtkGetMacro(ProbeRadius, double);
  ///@}

  ///@{
  /// Radius of the ball that fits into a pocket. Default: 1.7 angstrom, a carbon atom.
  vtkSetMacro(InnerRadius, double);
  vtkGetMacro(InnerRadius, double);
  ///@}

  ///@{
  /// Radius of the ball that does not get in. Default: 3.1 angstrom.
  vtkSetMacro(OuterRadius, double);
  vtkGetMacro(OuterRadius, double);
  ///@}

  ///@{
  /// How far around a place atoms bury it. Default: 10 angstrom.
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
  /// (where the atoms have names and elements). Off: whole pockets, ranked by Score. Default: on.
  vtkSetMacro(FindSites, bool);
  vtkGetMacro(FindSites, bool);
  vtkBooleanMacro(FindSites, bool);
  ///@}

  ///@{
  /// Whether output 6, without input 1, has the point array `SiteDescriptors`, what each place's
  /// probability is computed from. Default: off.
  vtkSetMacro(KeepDescriptors, bool);
  vtkGetMacro(KeepDescriptors, bool);
  vtkBooleanMacro(KeepDescriptors, bool);
  ///@}

  ///@{
  /// Whether a surface, where there is one, contributes to the score. Default: on.
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
  /// What counts as part of the molecule beside its chains. Default: nothing.
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
  /// Names of further residues to keep, between blanks or commas. Default: none.
  vtkSetMacro(KeepResidues, std::string);
  vtkGetMacro(KeepResidues, std::string);
  ///@}

  ///@{
  /// The pocket whose residues output 5 shows; 0 (default): those of all.
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

  /// The pockets of the last run, whatever their volume, and what they were made of.
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
