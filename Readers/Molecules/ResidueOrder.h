/**
 * @file ResidueOrder.h
 * @brief Residues whose atoms are apart in a file, and residues by their names and numbers.
 */
#ifndef isthmus_ResidueOrder_h
#define isthmus_ResidueOrder_h

#include "Molecules/Macromolecule.h"

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace isthmus
{

/// Consecutive atoms of one residue.
struct ResidueRun
{
  std::size_t First, Last;
  std::size_t Group; ///< the chain: residues are the same only within consecutive runs of a group
  int Number;
  std::string_view Name;
  char Code = ' '; ///< insertion code, in small letters
  std::string_view Segment = {};
};

/// Where the atoms of runs go, so that those of a residue come together.
struct ResidueOrder
{
  std::vector<std::size_t> Residue; ///< of each run
  std::vector<std::size_t> Place;   ///< of the first atom of each run
  std::vector<std::size_t> Starts;  ///< first atom of each residue
  bool IsOfFile = true;             ///< no atom moves
};

/// O(runs).
ResidueOrder FindResidueOrder(const std::vector<ResidueRun>& runs);

/// The values at `from`, in that order; nothing where there are none.
template <typename Values>
void Reorder(Values& values, const std::vector<std::size_t>& from)
{
  if (!values.empty())
  {
    Values ordered(from.size());
    for (std::size_t i = 0; i < from.size(); ++i)
    {
      ordered[i] = std::move(values[from[i]]);
    }
    values = std::move(ordered);
  }
}

/// Atoms of residues by chain, name and number.
class ResidueIndex
{
public:
  /// Of residues with equal addresses, the first one counts.
  void Add(std::size_t part, std::string_view chain, std::string_view name, int number, char code,
    std::size_t first, std::size_t last);

  /// The first and the last but one atom; empty if there is no such residue.
  std::pair<std::size_t, std::size_t> Find(
    std::size_t part, std::string_view chain, std::string_view name, int number, char code) const;

private:
  // Chain, name, part, number, code in small letters.
  using Address = std::tuple<std::string_view, std::string_view, std::size_t, int, char>;
  struct Hash
  {
    std::size_t operator()(const Address& address) const;
  };
  std::unordered_map<Address, std::pair<std::size_t, std::size_t>, Hash> Residues;
};

/// The atom of [range) with this name that is in the alternate location or has none.
std::optional<std::size_t> FindAtom(const std::vector<Atom>& atoms,
  std::pair<std::size_t, std::size_t> range, std::string_view name, char altLoc);

}

#endif
