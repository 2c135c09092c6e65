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

/// How near to a point of a site an atom's centre lies that counts as one of it, in angstrom: the
/// reach of contacts between heavy atoms.
constexpr double SiteReach = 4.0;

/**
 * For each of `sites` sites the residues with atoms within SiteReach of a point labelled 1 + its
 * place: "A HIS 57 (5), A SER 195 (3)" is chain, name, number and how many atoms. Those with most
 * atoms come first, else as in the file; atoms without residue names are counted only ("12 atoms").
 * O(n log n) and the pairs within reach.
 */
std::vector<std::string> ResiduesOfSites(const SurfaceView& surface, const std::vector<int>& labels,
  std::size_t sites, const MoleculeAtoms& atoms);

/// Columns Rank, Score, SiteClass and, in words, Class; Residues and Volume where there are any;
/// Area and what else was measured. The field array Threshold.
void FillSiteTable(
  const BindingSiteResult& result, const std::vector<std::string>& residues, vtkTable* table);

}

#endif
