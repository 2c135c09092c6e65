/**
 * @file SiteCopies.h
 * @brief Sites that are at the same place of copies of a chain.
 *
 * Copies of a chain differ by a little noise, and so do the densities of their sites: which of them
 * came first would be chance. Copies of a site have the mean of their densities, and those of the
 * chain with the first name come first.
 *
 * **Around** a site each residue has the weight 1 - d/10, with the distance d in angstrom from the
 * site's centre to the residue's nearest heavy atom. The **likeness** of two sites is the sum over
 * residues of the smaller weight over that of the larger one. Two sites are copies if their
 * likeness is at least a half where only the number and the name of a residue count, and less than
 * half of that where its chain counts too. A site is compared with the densest one of each group.
 */
#ifndef isthmus_SiteCopies_h
#define isthmus_SiteCopies_h

#include "Pockets/PocketSites.h"
#include "Pockets/SiteDescriptors.h"
#include "vtkIsthmusFiltersPocketsModule.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/// A site and what it shares with its copies.
struct CopiedSite
{
  PocketSite Site;        ///< its density becomes the mean over the copies
  std::int64_t Group = 0; ///< the same for copies, from 0 by the best of them
  int Chain = -1;         ///< with the most weight around it; -1: no atom is near
};

/// By falling density; copies of a site follow each other, by their chains. `sites`: the densest
/// first. O(sites x residues around x sites with the same residues around).
VTKISTHMUSFILTERSPOCKETS_EXPORT std::vector<CopiedSite> GroupCopies(
  const std::vector<SiteAtom>& atoms, std::vector<PocketSite> sites);

}

#endif
