/**
 * @file SiteModel.h
 * @brief The frozen model of binding sites: the probability that a place in a pocket is next to a
 * ligand.
 *
 * Gradient-boosted regression trees (J. H. Friedman, Ann. Stat. 29 (2001) 1189) on the descriptors
 * of SiteDescriptors.h, trained by Testing/Studies/train_site_model.py on public complexes, with
 * the same weight for each family of proteins; the script writes SiteModelTable.cxx. The guide's
 * page *Site model* lists the complexes and reports the performance on unseen families.
 */
#ifndef isthmus_SiteModel_h
#define isthmus_SiteModel_h

#include <cstddef>
#include <cstdint>

namespace isthmus
{

/// A node of a tree: continues with Low if the descriptor is at most Threshold, otherwise with
/// High. A negative number stands for leaf -1 - Low of the table.
struct SiteModelNode
{
  std::uint8_t Descriptor;
  float Threshold;
  std::int16_t Low, High;
};

/// The result of the training.
struct SiteModelTable
{
  const SiteModelNode*
    Nodes; ///< nodes of all trees; children are numbered from the first node of their tree
  const int* FirstNodes; ///< of each tree
  const int* FirstLeaves;
  const float* Leaves; ///< log odds
  std::size_t Trees;
  double LogOdds;           ///< constant to which the log odds of the leaves are added
  const double* Propensity; ///< for backbone and side chain of the twenty amino acids
  double Calibration[3];    ///< constant, factor of ln(density), factor of ln(share)
};

const SiteModelTable& GetSiteModel();

/// Enrichment of atoms of residue number `residue` (SiteAtom) around ligands compared with other
/// places in pockets: natural logarithm of the ratio in the training set.
double SitePropensity(int residue);

/// Probability that a place with these descriptors lies within 3 angstrom of a ligand's atom.
double PlaceProbability(const float* descriptors);

/**
 * Probability that a site's center is within 4 angstrom of the ligand: logistic in the logarithms
 * of the site's density and of its share of the densities of all sites of the molecule (Platt's
 * calibration, fitted on families left out of the training).
 */
double SiteProbability(double density, double share);

}

#endif
