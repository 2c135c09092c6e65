/**
 * @file LowerStars.h
 * @brief The lower star of every node of a grid, stored as the number of its kind, and the
 * matchings of all kinds.
 */
#ifndef isthmus_LowerStars_h
#define isthmus_LowerStars_h

#include "Core/Progress.h"
#include "Persistence/OrderedValues.h"
#include "Persistence/RankedSet.h"
#include "Persistence/StarMatching.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace isthmus
{

/**
 * The discrete gradient of a volume. A cell belongs to the last of its corners (for ties, the one
 * with the higher index). Which cells belong to a node depends on which of its 26 neighbours are
 * lower. So does their matching, which is therefore computed once for each kind of star: there are
 * about a thousand kinds in a map, ten times as many in noise. Memory: 4 bytes for each node; time:
 * O(nodes). The result is the same on any number of threads.
 */
class LowerStars
{
public:
  using Size = std::array<std::int64_t, 3>;

  template <typename Stored>
  LowerStars(
    const OrderedValues<Stored>& values, const Size& dimensions, const ProgressCallback& progress);

  const StarMatching& operator[](std::int64_t node) const
  {
    return this->Matchings[this->Kinds[static_cast<std::size_t>(node)]];
  }

  const Size& Dimensions() const { return this->Grid; }
  std::int64_t NodeCount() const { return this->Grid[0] * this->Grid[1] * this->Grid[2]; }
  std::size_t KindCount() const { return this->Matchings.size(); }

  /// From a node to the opposite corner of a cell of its star, as a difference of indices.
  std::int64_t Offset(StarCell cell) const { return this->Offsets[cell.Index()]; }
  std::int64_t Stride(std::size_t axis) const { return this->Strides[axis]; }

private:
  void NumberKinds(RankedSet& masks, const ProgressCallback& progress);

  Size Grid;
  Size Strides;
  std::array<std::int64_t, 27> Offsets;
  std::unique_ptr<std::uint32_t[]> Kinds; ///< not initialised: each thread touches its own pages
  std::vector<StarMatching> Matchings;
};

}

#endif
