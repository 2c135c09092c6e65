#include "Pockets/SiteModel.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

double Logistic(double x)
{
  return 1.0 / (1.0 + std::exp(-x));
}

}

double SitePropensity(int residue)
{
  return GetSiteModel().Propensity[residue];
}

double PlaceProbability(const float* descriptors)
{
  const SiteModelTable& model = GetSiteModel();
  double odds = model.LogOdds;
  for (std::size_t tree = 0; tree < model.Trees; ++tree)
  {
    const SiteModelNode* nodes = model.Nodes + model.FirstNodes[tree];
    int at = 0;
    while (at >= 0)
    {
      const SiteModelNode& node = nodes[at];
      at = descriptors[node.Descriptor] <= node.Threshold ? node.Low : node.High;
    }
    odds += static_cast<double>(model.Leaves[model.FirstLeaves[tree] - 1 - at]);
  }
  return Logistic(odds);
}

double SiteProbability(double density, double share)
{
  const double* c = GetSiteModel().Calibration;
  constexpr double least = 1e-6;
  return Logistic(
    c[0] + c[1] * std::log(std::max(density, least)) + c[2] * std::log(std::max(share, least)));
}

}
