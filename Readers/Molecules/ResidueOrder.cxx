#include "Molecules/ResidueOrder.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace isthmus
{
namespace
{

std::size_t HashOf(std::size_t chain, int number, std::string_view name)
{
  constexpr std::size_t golden = 0x9E3779B97F4A7C15u;
  const auto digits = static_cast<std::size_t>(static_cast<unsigned int>(number));
  return (digits + (chain << 32U)) * golden ^ std::hash<std::string_view>()(name);
}

/// What makes runs one residue; the first is the number of consecutive runs of one group.
using RunKey = std::tuple<std::size_t, int, std::string_view, char, std::string_view>;

struct RunHash
{
  std::size_t operator()(const RunKey& key) const
  {
    return HashOf(std::get<0>(key), std::get<1>(key), std::get<2>(key));
  }
};

}

ResidueOrder FindResidueOrder(const std::vector<ResidueRun>& runs)
{
  ResidueOrder order;
  order.Residue.reserve(runs.size());
  order.Place.reserve(runs.size());
  std::unordered_map<RunKey, std::size_t, RunHash> known; // [indexed, r) is not in it
  std::size_t indexed = 0;
  std::size_t chain = 0;
  int largest = 0;
  const auto keyOf = [&chain](const ResidueRun& run) {
    return RunKey{ chain, run.Number, run.Name, run.Code, run.Segment };
  };
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    const ResidueRun& run = runs[r];
    const bool isChain = r == 0 || run.Group != runs[r - 1].Group;
    chain += isChain ? 1 : 0;
    indexed = isChain ? r : indexed;
    std::size_t residue = order.Starts.size();
    if (isChain || run.Number > largest)
    {
      largest = run.Number; // rising numbers are those of further residues
    }
    else
    {
      for (; indexed < r; ++indexed)
      {
        known.emplace(keyOf(runs[indexed]), order.Residue[indexed]);
      }
      const auto found = known.find(keyOf(run));
      residue = found == known.end() ? residue : found->second;
    }
    if (residue == order.Starts.size())
    {
      order.Starts.push_back(0);
    }
    else
    {
      order.IsOfFile = order.IsOfFile && order.Residue[r - 1] == residue;
    }
    order.Residue.push_back(residue);
    order.Starts[residue] += run.Last - run.First; // the size, for now
  }
  std::size_t atoms = 0;
  for (std::size_t& start : order.Starts)
  {
    atoms += std::exchange(start, atoms);
  }
  std::vector<std::size_t> next = order.Starts;
  for (std::size_t r = 0; r < runs.size(); ++r)
  {
    order.Place.push_back(next[order.Residue[r]]);
    next[order.Residue[r]] += runs[r].Last - runs[r].First;
  }
  return order;
}

std::size_t ResidueIndex::Hash::operator()(const Address& address) const
{
  const auto& [chain, name, part, number, code] = address;
  const std::hash<std::string_view> hash;
  return HashOf(part, number, chain) ^ (hash(name) << 1U) ^ static_cast<std::size_t>(code);
}

void ResidueIndex::Add(std::size_t part, std::string_view chain, std::string_view name, int number,
  char code, std::size_t first, std::size_t last)
{
  this->Residues.emplace(
    Address{ chain, name, part, number, static_cast<char>(code | 0x20) }, std::pair(first, last));
}

std::pair<std::size_t, std::size_t> ResidueIndex::Find(
  std::size_t part, std::string_view chain, std::string_view name, int number, char code) const
{
  const auto found =
    this->Residues.find({ chain, name, part, number, static_cast<char>(code | 0x20) });
  return found == this->Residues.end() ? std::pair<std::size_t, std::size_t>() : found->second;
}

std::optional<std::size_t> FindAtom(const std::vector<Atom>& atoms,
  std::pair<std::size_t, std::size_t> range, std::string_view name, char altLoc)
{
  for (std::size_t i = range.first; i < range.second; ++i)
  {
    if (atoms[i].Name == name && (atoms[i].AltLoc == ' ' || atoms[i].AltLoc == altLoc))
    {
      return i;
    }
  }
  return {};
}

}
