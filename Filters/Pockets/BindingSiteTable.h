/**
 * @file BindingSiteTable.h
 * @brief The table of binding sites, with the residues around each.
 */
#ifndef isthmus_BindingSiteTable_h
#define isthmus_BindingSiteTable_h

#include "Atoms/MoleculeAtoms.h"
#include "Pockets/BindingSites.h"

#include <string>
#include <vector>

class vtkTable;

namespace isthmus
{

/// An atom belongs to a site if its center is within this distance of one of the site's points, in
/// angstrom: the range of contacts between heavy atoms.
constexpr double SiteReach = 4.0;

/**
 * For each of `sites` sites, the residues with atoms within SiteReach of a point that has the
 * site's label (1 + index): "HIS 57 A (5); SER 195 A (3)" gives name, number, chain and number of
 * atoms. Residues with the most atoms come first, then in the order of the file; atoms without
 * residue names are only counted ("12 atoms"). O(n log n) plus the number of pairs within reach.
 */
std::vector<std::string> FindSiteResidues(const SurfaceView& surface,
  const std::vector<int>& labels, std::size_t sites, const MoleculeAtoms& atoms);

/// Columns Rank, Score, SiteClass and, in words, Class; Residues and Volume if there are any; Area
/// and the other measures. The field array Threshold.
void FillSiteTable(
  const BindingSiteResult& result, const std::vector<std::string>& residues, vtkTable* table);

}

#endif
