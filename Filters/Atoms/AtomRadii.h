/**
 * @file AtomRadii.h
 * @brief Radii by element, and the radius of an atom without a given radius.
 *
 * All molecular filters decide the radius of an atom here, in this order:
 *
 * 1. the value of the point array of radii, `Radius` unless another one is chosen;
 * 2. if there is no such array, the van der Waals radius of the element (DefaultRadius): that of
 *    Bondi, or that of Alvarez if Bondi has none. A warning is issued if another array than
 * `Radius` was requested;
 * 3. if there are no elements either, std::invalid_argument is thrown.
 *
 * Readers that create the array (vtkMacromoleculeReader) use the table that is chosen there.
 *
 * An atom that has no radius after this (NaN in the array, an element in neither table) is dropped
 * with a warning by filters of shape and refused by filters that use its charge (MissingRadius).
 * Poisson-Boltzmann energies depend on the radii of a force field, so vtkPoissonBoltzmann requires
 * the array (RadiusFallback::None). If chains have no hydrogens at all and radii are those of a
 * table by element, they are replaced by united-atom radii on request (AssignUnitedRadii).
 */
#ifndef isthmus_AtomRadii_h
#define isthmus_AtomRadii_h

#include "vtkIsthmusFiltersAtomsModule.h"

#include <string>
#include <vector>

#include <vtkType.h>

class vtkDataSetAttributes;

namespace isthmus
{

/// Tables of van der Waals radii.
enum class RadiusTable
{
  /// A. Bondi, J. Phys. Chem. 68 (1964) 441, with the main-group elements that M. Mantina et al.,
  /// J. Phys. Chem. A 113 (2009) 5806, Table 12 add. H 1.20 (Bondi's), C 1.70, N 1.55, O 1.52, S
  /// 1.80. Most transition metals have no radius there.
  Bondi,
  /// S. Alvarez, Dalton Trans. 42 (2013) 8617, Table 1: nearly all elements, metals as well.
  Alvarez,
  /// Atoms together with their hydrogens, with one radius for each element of a biopolymer: C 1.85,
  /// N 1.75, O 1.65, P 2.10, S 2.00. From S. J. Weiner et al., J. Am. Chem. Soc. 106 (1984) 765, as
  /// summarised by O. S. Smart et al. (HOLE, J. Mol. Graph. 14 (1996) 354).
  UnitedAtom
};

/// Van der Waals radius in angstrom; NaN where the table has none.
VTKISTHMUSFILTERSATOMS_EXPORT double VanDerWaalsRadius(int element, RadiusTable table);

/**
 * Covalent radius in angstrom, B. Cordero et al., Dalton Trans. (2008) 2832 (carbon: sp3); NaN for
 * metals and noble gases, for which bonds are not determined by distance.
 */
VTKISTHMUSFILTERSATOMS_EXPORT double CovalentRadius(int element);

/// Van der Waals radius in angstrom of an atom without one: Bondi's, or Alvarez' where Bondi has
/// none; NaN where neither has.
VTKISTHMUSFILTERSATOMS_EXPORT double DefaultRadius(int element);

/// The replacement for a missing array of radii.
enum class RadiusFallback
{
  Element, ///< DefaultRadius; std::invalid_argument without elements
  Zero,    ///< radius 0: only positions are used, e.g. for the points of a surface
  None     ///< std::invalid_argument
};

/// Treatment of an atom without a radius.
enum class MissingRadius
{
  Drop,  ///< dropped, with a warning
  Refuse ///< std::invalid_argument
};

/// Radii of all atoms of the input, angstrom.
struct AtomRadii
{
  std::vector<double> Values; ///< NaN: none
  bool ByElement = false;     ///< from the elements, since there is no array
  std::string Warning;        ///< empty: none
};

/**
 * The radii of `count` atoms from the array `name` (empty: Radius) of their point data, or
 * according to `fallback`. `elements` is empty if the input has no elements.
 *
 * Throws std::invalid_argument for an array with several components, and if there are no radii.
 */
AtomRadii ReadRadii(vtkDataSetAttributes* data, vtkIdType count, const std::vector<int>& elements,
  const std::string& name, RadiusFallback fallback);

/// Replaces the radii of the kept atoms by united-atom radii if none of the atoms is a hydrogen and
/// all radii are those of a table by element. Returns whether it did.
bool AssignUnitedRadii(
  const std::vector<std::size_t>& kept, const std::vector<int>& elements, AtomRadii& radii);

/// The names of point arrays for a message, each preceded by a blank; " none" if there are none.
VTKISTHMUSFILTERSATOMS_EXPORT std::string ArrayNames(vtkDataSetAttributes* data);

}

#endif
