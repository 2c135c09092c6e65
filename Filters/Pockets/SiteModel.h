/**
 * @file SiteModel.h
 * @brief The frozen model of binding sites: how likely a place in a pocket is next to a ligand.
 *
 * Gradient-boosted regression trees (J. H. Friedman, Ann. Stat. 29 (2001) 1189) on the descriptors
 * of SiteDescriptors.h, trained by Examples/train_site_model.py on public complexes, each family of
 * proteins with the same weight; SiteModelTable.cxx holds what that wrote. The guide's page
 * *Site model* lists the complexes and says how good it is on families that it has not seen.
 */
#ifndef isthmus_SiteModel_h
#define isthmus_SiteModel_h

#include "vtkIsthmusFiltersPocketsModule.h"

#include <cstddef>
#include <cstdint>

namespace isthmus
{

/// A node of a tree: goes to Low where the descriptor is at most Threshold, else to High. Negative:
/// leaf -1 - Low of the table's leaves.
struct SiteModelNode
{
  std::uint8_t Descriptor;
  float Threshold;
  std::int16_t Low, High;
};

/// Frozen by the training.
struct SiteModelTable
{
  const SiteModelNode* Nodes; ///< of all trees; children are counted from their tree's first node
  const int* FirstNodes;      ///< of each tree
  const int* FirstLeaves;
  const float* Leaves; ///< log odds
  std::size_t Trees;
  double LogOdds;           ///< to which those of the leaves are added
  const double* Propensity; ///< of backbone and side chain of the twenty amino acids
  double Calibration[3];    ///< constant, factor of ln(density), factor of ln(share)
};

VTKISTHMUSFILTERSPOCKETS_EXPORT const SiteModelTable& FrozenSiteModel();

/// How much more often atoms of residue number `residue` (SiteAtom) line ligands than other places
/// in pockets: natural logarithm of the ratio, of the training's complexes.
VTKISTHMUSFILTERSPOCKETS_EXPORT double SitePropensity(int residue);

/// Probability that a place with these descriptors lies within 3 angstrom of a ligand's atom.
VTKISTHMUSFILTERSPOCKETS_EXPORT double PlaceProbability(const float* descriptors);

/**
 * Probability that a site's centre is within 4 angstrom of the ligand: logistic in the logarithms
 * of the site's density and of its share of the densities of all sites of the molecule (Platt's
 * calibration, fitted on families left out of the training).
 */
VTKISTHMUSFILTERSPOCKETS_EXPORT double SiteProbability(double density, double share);

}

#endif
