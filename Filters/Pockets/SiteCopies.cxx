#include "Pockets/SiteCopies.h"

#include "Atoms/PointBins.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double AroundReach = 10.0; // angstrom
constexpr double LeastLikeness = 0.5;
constexpr double MostOfSame = 0.5; // of the similarity

/// Weights of residues.
template <typename Key>
using Weights = std::map<Key, double>;
using NumberedWord = std::pair<std::int64_t, std::int64_t>; ///< word, number of the residue

template <typename Key>
double ComputeSum(const Weights<Key>& weights)
{
  double sum = 0.0;
  for (const auto& one : weights)
  {
    sum += one.second;
  }
  return sum;
}

template <typename Key>
double Similarity(const Weights<Key>& a, const Weights<Key>& b)
{
  double common = 0.0;
  for (const auto& [key, weight] : a)
  {
    const auto same = b.find(key);
    common += same != b.end() ? std::min(weight, same->second) : 0.0;
  }
  const double all = ComputeSum(a) + ComputeSum(b) - common;
  return all > 0.0 ? common / all : 0.0;
}

struct Surroundings
{
  Weights<NumberedWord> OfEach;
  Weights<std::int64_t> OfAll;
  int Chain = -1;

  Surroundings(const std::vector<SiteAtom>& atoms, const PointBins& bins, const Point3& center)
  {
    std::map<std::int64_t, int> chainOf; // of each residue
    bins.Near(center, AroundReach,
      [&](std::int64_t id, double squared)
      {
        const SiteAtom& atom = atoms[static_cast<std::size_t>(id)];
        const double weight = 1.0 - std::sqrt(squared) / AroundReach;
        if (atom.Word >= 0)
        {
          double& ofEach = this->OfEach[{ atom.Word, atom.Number }];
          ofEach = std::max(ofEach, weight);
          double& ofAll = this->OfAll[atom.Word];
          ofAll = std::max(ofAll, weight);
          chainOf[atom.Number] = atom.Chain;
        }
      });
    Weights<int> chains;
    for (const auto& [key, weight] : this->OfEach)
    {
      chains[chainOf[key.second]] += weight;
    }
    double most = 0.0;
    for (const auto& [chain, weight] : chains)
    {
      this->Chain = weight > most ? chain : this->Chain;
      most = std::max(most, weight);
    }
  }

  bool IsCopy(const Surroundings& other) const
  {
    const double likeness = Similarity(this->OfAll, other.OfAll);
    return likeness >= LeastLikeness &&
      Similarity(this->OfEach, other.OfEach) < MostOfSame * likeness;
  }
};

/// Sorts a group of copies (SiteCopies.h).
void OrderCopies(const std::vector<Surroundings>& around, std::vector<std::size_t>& group)
{
  std::map<std::int64_t, std::set<std::int64_t>> numbersOf; // of each word
  for (const std::size_t i : group)
  {
    for (const auto& one : around[i].OfEach)
    {
      numbersOf[one.first.first].insert(one.first.second);
    }
  }
  std::map<std::size_t, double> shares;
  for (const std::size_t i : group)
  {
    double sum = 0.0, all = 0.0;
    for (const auto& [key, weight] : around[i].OfEach)
    {
      const auto word = numbersOf.find(key.first);
      const auto before = std::distance(numbersOf.begin(), word);
      const double part =
        weight * (2.0 - static_cast<double>(before) / static_cast<double>(numbersOf.size()));
      const auto rank = std::distance(word->second.begin(), word->second.find(key.second));
      sum += part * std::pow(0.25, static_cast<double>(rank));
      all += part;
    }
    shares[i] = all > 0.0 ? sum / all : 0.0;
  }
  std::stable_sort(group.begin(), group.end(),
    [&](std::size_t a, std::size_t b) { return shares[a] > shares[b]; });
}

/// Numbers of the groups, each with its densest site first.
std::vector<std::vector<std::size_t>> FindGroups(const std::vector<Surroundings>& around)
{
  std::vector<std::vector<std::size_t>> groups;
  std::map<std::int64_t, std::vector<std::size_t>> groupsAt; // groups with a residue around
  for (std::size_t i = 0; i < around.size(); ++i)
  {
    std::vector<std::size_t> candidates;
    for (const auto& [word, weight] : around[i].OfAll)
    {
      const auto found = groupsAt.find(word);
      if (found != groupsAt.end())
      {
        candidates.insert(candidates.end(), found->second.begin(), found->second.end());
      }
    }
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
    const auto group = std::find_if(candidates.begin(), candidates.end(),
      [&](std::size_t g) { return around[i].IsCopy(around[groups[g].front()]); });
    if (group != candidates.end())
    {
      groups[*group].push_back(i);
      continue;
    }
    for (const auto& [word, weight] : around[i].OfAll)
    {
      groupsAt[word].push_back(groups.size());
    }
    groups.push_back({ i });
  }
  return groups;
}

}

std::vector<CopiedSite> GroupCopies(
  const std::vector<SiteAtom>& atoms, std::vector<PocketSite> sites)
{
  std::vector<Point3> places;
  places.reserve(atoms.size());
  for (const SiteAtom& atom : atoms)
  {
    places.push_back(atom.Place);
  }
  const PointBins bins(places, 0.5 * AroundReach);
  std::vector<Surroundings> around;
  around.reserve(sites.size());
  for (const PocketSite& site : sites)
  {
    around.emplace_back(atoms, bins, site.Center);
  }
  std::vector<CopiedSite> copied;
  copied.reserve(sites.size());
  std::int64_t number = 0;
  for (std::vector<std::size_t>& group : FindGroups(around))
  {
    OrderCopies(around, group);
    double sum = 0.0;
    for (const std::size_t i : group)
    {
      sum += sites[i].Density;
    }
    for (const std::size_t i : group)
    {
      sites[i].Density = sum / static_cast<double>(group.size());
      copied.push_back({ std::move(sites[i]), number, around[i].Chain });
    }
    ++number;
  }
  std::stable_sort(copied.begin(), copied.end(),
    [](const CopiedSite& a, const CopiedSite& b)
    { return std::pair(-a.Site.Density, a.Group) < std::pair(-b.Site.Density, b.Group); });
  std::map<std::int64_t, std::int64_t> renumbered;
  for (CopiedSite& site : copied)
  {
    site.Group =
      renumbered.emplace(site.Group, static_cast<std::int64_t>(renumbered.size())).first->second;
  }
  return copied;
}

}
