/**
 * @file AtomInput.h
 * @brief The atoms of a vtkPointSet: places, radii and the names that vtkMacromoleculeReader gives.
 */
#ifndef isthmus_AtomInput_h
#define isthmus_AtomInput_h

#include "Atoms/Ball.h"
#include "Atoms/PolymerAtoms.h"
#include "vtkIsthmusFiltersAtomsModule.h" // for the export macro

#include <vtkType.h>

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkPointSet;

namespace isthmus
{

/// The atoms that a filter works on.
struct ChosenAtoms
{
  std::vector<NamedAtom> Named;      ///< of all points of the input
  std::vector<Ball> Balls;           ///< of the atoms that were kept
  std::vector<vtkIdType> Points;     ///< and their points
  std::vector<std::string> Notes;    ///< what was left out
  std::vector<std::string> Warnings; ///< what should have been there
  bool HasNames = false;             ///< any residue names
  bool HasElements = false;
  bool IsSurface = false; ///< points of a mesh, taken with radius 0
};

/// What points with neither radii nor elements are.
enum class WithoutRadii
{
  Error,
  SurfacePoints ///< where the input has polygons: points of radius 0
};

/**
 * Reads the arrays Element, AtomName, ResidueName, ResidueId, Chain, InsertionCode, AltLoc,
 * Occupancy and IsHetero as far as they are there, keeps what `options` says, and takes the radii
 * from the point array `radii`. Where that array is missing, elements have Bondi's radii, with a
 * warning if it is another one than Radius. Atoms whose radius is NaN are left out with a warning.
 *
 * Throws std::invalid_argument for radii that are not there, negative or infinite, and places that
 * are not finite.
 */
VTKISTHMUSFILTERSATOMS_EXPORT ChosenAtoms ChooseAtoms(const std::string& radii, vtkPointSet* input,
  const PolymerOptions& options, WithoutRadii withoutRadii = WithoutRadii::Error);

/// What the arrays above say of each point. Throws std::invalid_argument for places that are not
/// finite.
std::vector<NamedAtom> NamedAtomsOf(vtkPointSet* input);

/// The name of the array that input array `index` of `filter` is; empty: none.
VTKISTHMUSFILTERSATOMS_EXPORT std::string InputArrayName(vtkAlgorithm* filter, int index);

/// Adds the field array `Notes`.
VTKISTHMUSFILTERSATOMS_EXPORT void AddNotes(
  const std::vector<std::string>& notes, vtkDataObject* to);

/// Names between blanks, commas or semicolons.
VTKISTHMUSFILTERSATOMS_EXPORT std::set<std::string> NamesIn(const std::string& list);

}

#endif
