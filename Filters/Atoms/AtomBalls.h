/**
 * @file AtomBalls.h
 * @brief The atoms of a VTK data set as balls: radii from an array, or by element.
 */
#ifndef isthmus_AtomBalls_h
#define isthmus_AtomBalls_h

#include "Atoms/Ball.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <vtkType.h>

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataObject;
class vtkDataSetAttributes;
class vtkPoints;

namespace isthmus
{

/// Which points count, and how large they are.
struct AtomChoice
{
  bool KeepWaters = false;
  /// Where chains of amino acids or nucleotides come without any hydrogen, and radii go by element,
  /// those of united atoms (RadiusTable::UnitedAtom) stand for what is missing.
  bool UnitedAtoms = true;
};

struct AtomBalls
{
  std::vector<Ball> Balls;        ///< of the atoms that have a radius above 0
  std::vector<vtkIdType> Ids;     ///< their numbers in the input
  std::vector<vtkIdType> Points;  ///< of all atoms that count, with a ball or without
  vtkIdType NumberOfAtoms = 0;    ///< of the input
  vtkIdType WithoutRadius = 0;    ///< atoms left out since their radius is not a number
  bool ByElement = false;         ///< whether radii come from the elements
  std::vector<std::string> Notes; ///< a sentence for what was left out or replaced
};

/// Points of a vtkPointSet or a vtkMolecule; null for anything else.
vtkPoints* AtomPoints(vtkDataObject* atoms);

/// Point data of a vtkPointSet, vertex data of a vtkMolecule.
vtkDataSetAttributes* AtomData(vtkDataObject* atoms);

/// Number of the element of each atom, from a molecule or the array `Element`; empty where neither
/// is there.
std::vector<int> AtomElements(vtkDataObject* atoms);

/**
 * Balls from the point array `radii`; where there is none, from the elements, by Bondi's table and
 * Alvarez' where that has none. Where residues have names, water is left out unless kept, and of
 * alternate locations one stays (PolymerAtoms.h). Radii count as going by element where each is
 * that of one of these tables. Atoms whose radius is 0 have no ball; those whose radius is not a
 * number are counted. Throws std::invalid_argument where there are neither radii nor elements, for
 * a radius that is negative or infinite, a coordinate that is not finite, and when no atom is left.
 */
VTKISTHMUSFILTERSATOMS_EXPORT AtomBalls BallsOf(
  vtkDataObject* atoms, const char* radii, const AtomChoice& choice = {});

/// The same with the radii of `filter`'s input array 0.
VTKISTHMUSFILTERSATOMS_EXPORT AtomBalls BallsOf(
  vtkAlgorithm* filter, vtkDataObject* atoms, const AtomChoice& choice);

}

#endif
