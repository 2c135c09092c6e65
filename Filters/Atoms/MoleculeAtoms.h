/**
 * @file MoleculeAtoms.h
 * @brief The atoms of a VTK data set: which of them are used, their positions, radii, charges and
 * names.
 *
 * All molecular filters read their input, a vtkPointSet or a vtkMolecule, through this header:
 *
 * - radii: AtomRadii.h;
 * - charges: AtomCharges, from a point array, required;
 * - elements: the atomic numbers of a molecule, or the point array `Element`;
 * - names: the point arrays `AtomName`, `ResidueName`, `ResidueId`, `Chain`, `InsertionCode`,
 *   `AltLoc`, `Occupancy`, `IsHetero` and `pLDDT` of vtkMacromoleculeReader, as far as they exist;
 * - atoms exactly at the same place: the largest of them (the first of equal ones) is used, and a
 *   warning states how many others were dropped, with their charges; a molecule that occurs twice
 *   would otherwise count twice in sums over atoms;
 * - waters, ions, ligands, hydrogens and alternate locations: PolymerAtoms.h.
 */
#ifndef isthmus_MoleculeAtoms_h
#define isthmus_MoleculeAtoms_h

#include "Atoms/AtomRadii.h"
#include "Atoms/Ball.h"
#include "Atoms/PolymerAtoms.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <vtkType.h>

#include <limits>
#include <optional>
#include <set>
#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkDataSetAttributes;
class vtkPoints;

namespace isthmus
{

/// Which atoms are used, and their radii.
struct AtomOptions
{
  std::string RadiusArray = "Radius";
  std::optional<PolymerOptions> Selection; ///< none: all atoms
  /// Where chains of amino acids or nucleotides have no hydrogens at all, and radii are those of a
  /// table by element, radii of united atoms (RadiusTable::UnitedAtom) replace them.
  bool UnitedAtoms = false;
  /// Residues of a predicted model with a confidence (point array pLDDT) below this are dropped, of
  /// those that the selection keeps. 0: none.
  double MinimumConfidence = 0.0;
  bool ZeroRadii = false;    ///< atoms with radius 0 also get a ball
  bool KeepCopies = false;   ///< atoms at the place of another one are listed only, not dropped
  bool RequireBalls = false; ///< std::invalid_argument where no atom has a radius above 0
  /// Angstrom. Radii of this size or larger are refused.
  double MaximumRadius = std::numeric_limits<double>::infinity();
  bool SurfacePoints = false; ///< polygons without elements or radii are points with radius 0
  RadiusFallback Fallback = RadiusFallback::Element;
  MissingRadius Missing = MissingRadius::Drop;
};

/// All residues except water, which is kept on request (the properties of AtomProperties.h).
VTKISTHMUSFILTERSATOMS_EXPORT AtomOptions SelectWholeMolecule(
  const std::string& radiusArray, bool keepWaters = false, bool unitedAtoms = true);

/// The chains and the other residues that `options` keeps, including atoms of radius 0.
VTKISTHMUSFILTERSATOMS_EXPORT AtomOptions SelectPolymer(
  const std::string& radiusArray, const PolymerOptions& options);

/// The atoms that a filter uses. Places and radii in angstrom.
struct MoleculeAtoms
{
  std::vector<Ball> Balls;       ///< of the atoms with a radius
  std::vector<vtkIdType> Points; ///< of each ball: its point in the input
  std::vector<vtkIdType> Kept;   ///< points of all atoms that are used, including those of radius 0
  std::vector<vtkIdType> Copies; ///< points of atoms at the place of another one, ascending
  std::vector<NamedAtom> Named;  ///< of all points of the input, where there was a selection
  std::vector<std::string> Notes; ///< one message per kind of dropped or replaced value
  /// One message per missing property, for copies of atoms, and for missing side chains.
  std::vector<std::string> Warnings;
  vtkIdType NumberOfAtoms = 0; ///< of the input
  bool HasNames = false;       ///< any residue names
  bool HasElements = false;
  bool IsSurface = false; ///< points of polygons, see AtomOptions::SurfacePoints
};

/**
 * Reads the atoms of a vtkPointSet or a vtkMolecule according to `options`; empty if it has no
 * points.
 *
 * O(atoms), using the names of residues if there is a selection.
 * @throws std::invalid_argument for radii that AtomRadii.h refuses, that are negative, infinite or
 * at least MaximumRadius, or that are missing with MissingRadius::Refuse; for coordinates that are
 * not finite; and if no atom is left but one is required.
 */
VTKISTHMUSFILTERSATOMS_EXPORT MoleculeAtoms ReadAtoms(
  vtkDataObject* atoms, const AtomOptions& options);

/// The charges of `atoms.Kept` in e, from the point array `name` of `input`. Throws
/// std::invalid_argument if there is no such array of one component, or a charge is not finite.
VTKISTHMUSFILTERSATOMS_EXPORT std::vector<double> AtomCharges(
  vtkDataObject* input, const MoleculeAtoms& atoms, const std::string& name);

/// Points of a vtkPointSet or a vtkMolecule; null for anything else.
VTKISTHMUSFILTERSATOMS_EXPORT vtkPoints* AtomPoints(vtkDataObject* atoms);

/// Point data of a vtkPointSet, vertex data of a vtkMolecule.
VTKISTHMUSFILTERSATOMS_EXPORT vtkDataSetAttributes* AtomData(vtkDataObject* atoms);

/// Atomic number of each atom (0: unknown); empty if neither the molecule nor an array has
/// elements.
VTKISTHMUSFILTERSATOMS_EXPORT std::vector<int> AtomElements(vtkDataObject* atoms);

/// The names of all atoms. Throws std::invalid_argument for coordinates that are not finite.
VTKISTHMUSFILTERSATOMS_EXPORT std::vector<NamedAtom> ReadNamedAtoms(vtkDataObject* atoms);

/// The name of the array selected as input array `index` of `filter`; empty: none.
VTKISTHMUSFILTERSATOMS_EXPORT std::string InputArrayName(vtkAlgorithm* filter, int index);

/// Adds the field array `Notes`.
VTKISTHMUSFILTERSATOMS_EXPORT void AddNotes(
  const std::vector<std::string>& notes, vtkDataObject* to);

/// Names separated by blanks, commas or semicolons.
VTKISTHMUSFILTERSATOMS_EXPORT std::set<std::string> SplitNames(const std::string& list);

}

#endif
