/**
 * @file SiteDescriptors.h
 * @brief Descriptors of the surroundings of a place in a pocket, from which a site's probability is
 * computed.
 *
 * All are sums over atoms and over tetrahedra of pockets near a place, so they depend neither on
 * the molecule's orientation nor on the order of its atoms:
 *
 * - **burial**: heavy atoms within 5, 6, 8, 10 and 12 angstrom;
 * - **enclosure in solid angle**, within 6, 8 and 12 angstrom, from the unit vectors to the atoms:
 *   the length of their mean (0: enclosed on all sides, 1: atoms on one side only) and the two
 *   smaller eigenvalues of their mean outer product (tunnels, clefts, flat places);
 * - **lining**: the weight 1 - d/8 of the atoms of each SiteAtomKind within 8 angstrom, and of all;
 * - **chains**: the share of that weight outside the chain with the largest share, and the number
 *   of chains;
 * - **metal binders**: atoms within 4.5 angstrom that bind metals (His N, Cys S, Asp and Glu O);
 * - **propensity**: the mean over the atoms within 6 angstrom, with the weight 1 - d/6, of the
 *   enrichment of their residue (backbone or side chain) around ligands compared with the rest of
 *   the pockets (SiteModel.h);
 * - **density of alpha balls**: empty volume and mean burial within 3 to 10 angstrom, number of
 *   tetrahedra and largest clearance within 5;
 * - **depth**: clearance, access radius and their difference; burial divided by the largest burial
 *   in the molecule.
 */
#ifndef isthmus_SiteDescriptors_h
#define isthmus_SiteDescriptors_h

#include "Core/Geometry.h"
#include "Core/Progress.h"
#include "Pockets/Pocket.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

/// The kind of an atom with respect to ligand binding.
enum class SiteAtomKind
{
  Aromatic,
  Aliphatic,
  Sulfur,
  Acid,
  Base,
  Imidazole,
  CarbonylOxygen,
  AmideNitrogen,
  Hydroxyl,
  SideChainAmide,
  Other
};

/// A heavy atom of the molecule.
struct SiteAtom
{
  Point3 Place;
  SiteAtomKind Kind = SiteAtomKind::Other;
  int Residue =
    -1; ///< 0 to 19: backbone of the amino acids in the order of their names; 20 to 39: side chain
  int Chain = 0;            ///< numbered from 0 by name
  std::int64_t Number = -1; ///< of its residue, ascending by chain and number
  /// The same for residues with the same name and the same three neighbours on each side in the
  /// sequence, as copies of a chain have them.
  std::int64_t Word = -1;
  bool BindsMetals = false;
};

/// Kind, Residue and BindsMetals from names; force-field variants and common modifications count as
/// the amino acid from which they are derived. Unknown atoms are Other.
SiteAtom MakeSiteAtom(
  const Point3& place, int element, const std::string& residue, const std::string& name);

/// Names of the descriptors, in their order.
const std::vector<std::string>& SiteDescriptorNames();

/// Number of values of SiteAtom::Residue.
const std::vector<std::string>& SiteResidueNames();

/// Rows of numbers, one row for each tetrahedron.
struct SiteDescriptorTable
{
  std::vector<float> Descriptors; ///< each row has one number per entry of SiteDescriptorNames
  std::vector<float> Residues;    ///< weights of the residues in the mean Propensity
};

/// O(cells x atoms nearby). Deterministic for a given order of atoms and cells. `residues`: whether
/// to compute the weights of residues, which the training needs. @throws Cancelled
SiteDescriptorTable DescribeSites(const std::vector<SiteAtom>& atoms,
  const std::vector<const PocketCell*>& cells, bool residues,
  const ProgressCallback& progress = {});

}

#endif
