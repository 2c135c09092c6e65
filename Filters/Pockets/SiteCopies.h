/**
 * @file SiteCopies.h
 * @brief Sites at equivalent places of copies of a chain.
 *
 * Copies of a chain differ by a little noise, and so do the densities of their sites, so their
 * order would be random. Therefore copies of a site are given the mean of their densities, and an
 * order that noise does not change.
 *
 * Each residue around a site has the weight 1 - d/10, with the distance d in angstrom from the
 * site's center to the residue's nearest heavy atom. The **similarity** of two sites is the sum
 * over residues of the smaller weight divided by the sum of the larger weight. Two sites are copies
 * if their similarity is at least a half when residues with the same Word (SiteAtom) are the same,
 * in whatever chain, and less than half of that when they are not. A site is compared with the
 * densest one of each group.
 *
 * **Order**: by the mean of 1/4^c over the residues around, with the number c of residues of the
 * same Word around the copies that precede it by chain and number. A residue has its weight times 2
 * for the first to 1 for the last Word, which decides between sites between two chains that differ
 * only in which chain has which residues.
 */
#ifndef isthmus_SiteCopies_h
#define isthmus_SiteCopies_h

#include "Pockets/PocketSites.h"
#include "Pockets/SiteDescriptors.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/// A site and the values that it shares with its copies.
struct CopiedSite
{
  PocketSite Site;        ///< its density is set to the mean over the copies
  std::int64_t Group = 0; ///< the same for copies, numbered from 0 by the best of them
  int Chain = -1;         ///< the chain with the most weight around it; -1: no atom is nearby
};

/// By descending density; copies of a site are consecutive, in their order. `sites`: the
/// densest first. O(sites x residues around x sites with the same residues around).
std::vector<CopiedSite> GroupCopies(
  const std::vector<SiteAtom>& atoms, std::vector<PocketSite> sites);

}

#endif
