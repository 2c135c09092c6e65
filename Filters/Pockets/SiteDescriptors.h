/**
 * @file SiteDescriptors.h
 * @brief What surrounds a place in a pocket: the numbers that a site's probability is computed
 * from.
 *
 * All are sums over atoms and over tetrahedra of pockets near a place, so that they neither depend
 * on the molecule's orientation nor on the order of its atoms:
 *
 * - **burial**: heavy atoms within 5, 6, 8, 10 and 12 angstrom;
 * - **enclosure in solid angle**, within 6, 8 and 12 angstrom, of the unit vectors to the atoms:
 * the length of their mean (0: closed all round, 1: atoms on one side only) and the two smaller
 *   eigenvalues of their mean outer product (tunnels, clefts, flat places);
 * - **lining**: the weight 1 - d/8 of the atoms of each SiteAtomKind within 8 angstrom, and of all;
 * - **chains**: the share of that weight outside of the chain that has most of it, the number of
 * chains;
 * - **metal binders**: atoms within 4.5 angstrom that bind metals (His N, Cys S, Asp and Glu O);
 * - **propensity**: the mean over the atoms within 6 angstrom, weight 1 - d/6, of how much more
 * often their residue (backbone, side chain) lines ligands than the rest of the pockets
 * (SiteModel.h);
 * - **density of alpha balls**: empty volume and mean burial within 3 to 10 angstrom, number of
 *   tetrahedra and largest clearance within 5;
 * - **depth**: clearance, access radius and their difference; burial over the molecule's largest.
 */
#ifndef isthmus_SiteDescriptors_h
#define isthmus_SiteDescriptors_h

#include "Core/Geometry.h"
#include "Pockets/Pocket.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

/// What an atom offers to a ligand.
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
    -1;          ///< 0 to 19: the backbone of one of the amino acids by name; 20 to 39: side chain
  int Chain = 0; ///< from 0 by name
  std::int64_t Word = -1; ///< the same for residues with the same number and name, of any chain
  bool BindsMetals = false;
};

/// Kind, Residue and BindsMetals from names; variants of force fields and common modifications
/// count as the amino acid that they are made from. What is unknown is Other.
VTKISTHMUSFILTERSPOCKETS_EXPORT SiteAtom SiteAtomOf(
  const Point3& place, int element, const std::string& residue, const std::string& name);

/// Names of the descriptors, in their order.
VTKISTHMUSFILTERSPOCKETS_EXPORT const std::vector<std::string>& SiteDescriptorNames();

/// Of the numbers SiteAtom::Residue.
VTKISTHMUSFILTERSPOCKETS_EXPORT const std::vector<std::string>& SiteResidueNames();

/// Rows of numbers, one for each tetrahedron.
struct SiteDescriptorTable
{
  std::vector<float> Descriptors; ///< as many numbers in a row as there are SiteDescriptorNames
  std::vector<float> Residues;    ///< weights of the residues that Propensity is the mean over
};

/// O(cells x atoms near). Deterministic for a given order of atoms and cells. `residues`: whether
/// those are wanted, which the training needs.
VTKISTHMUSFILTERSPOCKETS_EXPORT SiteDescriptorTable DescribeSites(
  const std::vector<SiteAtom>& atoms, const std::vector<const PocketCell*>& cells, bool residues);

}

#endif
