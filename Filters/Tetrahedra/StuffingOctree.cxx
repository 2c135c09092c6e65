#include "Tetrahedra/StuffingLattice.h"

namespace isthmus
{
namespace
{

/// One flag for each block of cells of one size.
struct Blocks
{
  std::array<std::int64_t, 3> Count;
  std::vector<unsigned char> Flags;

  std::size_t At(const LatticePoint& b) const
  {
    return static_cast<std::size_t>(b[0] + this->Count[0] * (b[1] + this->Count[1] * b[2]));
  }
  bool Has(const LatticePoint& b) const { return this->Flags[this->At(b)] != 0; }
};

template <typename Visit>
void ForEachBlock(const std::array<std::int64_t, 3>& count, Visit&& visit)
{
  for (std::int64_t k = 0; k < count[2]; ++k)
  {
    for (std::int64_t j = 0; j < count[1]; ++j)
    {
      for (std::int64_t i = 0; i < count[0]; ++i)
      {
        visit(LatticePoint{ i, j, k });
      }
    }
  }
}

/// Blocks twice as large all of whose eight children are flagged.
Blocks Parents(const Blocks& children)
{
  Blocks parents;
  for (std::size_t a = 0; a < 3; ++a)
  {
    parents.Count[a] = children.Count[a] / 2;
  }
  parents.Flags.resize(
    static_cast<std::size_t>(parents.Count[0] * parents.Count[1] * parents.Count[2]));
  ForEachBlock(parents.Count,
    [&](const LatticePoint& b)
    {
      bool all = true;
      for (int c = 0; c < 8; ++c)
      {
        all =
          all && children.Has({ 2 * b[0] + (c & 1), 2 * b[1] + (c >> 1 & 1), 2 * b[2] + (c >> 2) });
      }
      parents.Flags[parents.At(b)] = all ? 1 : 0;
    });
  return parents;
}

/// Flags of those whose up to 26 neighbours are flagged, too: none of them is smaller by two
/// levels.
Blocks Balanced(const Blocks& blocks)
{
  Blocks result = blocks;
  ForEachBlock(blocks.Count,
    [&](const LatticePoint& b)
    {
      for (int n = 0; n < 27; ++n)
      {
        const LatticePoint other{ b[0] + n % 3 - 1, b[1] + n / 3 % 3 - 1, b[2] + n / 9 - 1 };
        bool exists = true;
        for (std::size_t a = 0; a < 3; ++a)
        {
          exists = exists && other[a] >= 0 && other[a] < blocks.Count[a];
        }
        if (exists && !blocks.Has(other))
        {
          result.Flags[result.At(b)] = 0;
        }
      }
    });
  return result;
}

}

void StuffingLattice::Grade(int levels)
{
  if (levels == 0)
  {
    return;
  }
  this->Levels.assign(this->Near.size(), 0);
  Blocks blocks{ this->Count, this->Near };
  for (unsigned char& flag : blocks.Flags)
  {
    flag = flag ? 0 : 1;
  }
  for (int level = 1; level <= levels; ++level)
  {
    blocks = Balanced(Parents(blocks));
    const std::int64_t size = std::int64_t{ 1 } << level;
    ForEachBlock(this->Count,
      [&](const LatticePoint& c)
      {
        if (blocks.Has({ c[0] / size, c[1] / size, c[2] / size }))
        {
          this->Levels[static_cast<std::size_t>(this->Cell(c[0], c[1], c[2]))] =
            static_cast<unsigned char>(level);
        }
      });
  }
}

}
