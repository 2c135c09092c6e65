#include "Persistence/LowerStars.h"

#include "Core/ParallelFor.h"

#include <algorithm>
#include <utility>

namespace isthmus
{
namespace
{

/// Orders of the nodes in the 3 x 3 rows round one row, each with an extra node at both ends.
template <typename Order>
class RowWindow
{
public:
  explicit RowWindow(std::int64_t length)
    : Length(length)
  {
    for (auto& row : this->Rows)
    {
      row.assign(static_cast<std::size_t>(length + 2), Order{});
    }
  }

  /// Makes (j, k) the middle row; rows known from (j - 1, k) are kept.
  template <typename Stored>
  void MoveTo(const OrderedValues<Stored>& values, const LowerStars::Size& n, std::int64_t j,
    std::int64_t k, bool kept)
  {
    for (std::int64_t dz = -1; dz <= 1; ++dz)
    {
      auto* plane = &this->Rows[static_cast<std::size_t>(3 * (dz + 1))];
      if (kept)
      {
        std::rotate(plane, plane + 1, plane + 3);
      }
      for (std::int64_t dy = kept ? 1 : -1; dy <= 1; ++dy)
      {
        if (j + dy >= 0 && j + dy < n[1] && k + dz >= 0 && k + dz < n[2])
        {
          values.Convert(n[0] * (j + dy + n[1] * (k + dz)), n[0],
            plane[static_cast<std::size_t>(dy + 1)].data() + 1);
        }
      }
    }
  }

  void MasksInto(std::uint32_t allowed, std::uint32_t* masks) const
  {
    this->Compare(masks, std::make_index_sequence<26>());
    masks[0] &= this->Without(-1);
    masks[this->Length - 1] &= this->Without(1);
    for (std::int64_t i = 0; i < this->Length; ++i)
    {
      // Only closed stars: a face with both edges, a cube with its three faces.
      std::uint32_t mask = masks[i] & allowed;
      mask &= Star::FacesOfEdges[mask & 63U] | ~(4095U << Star::FirstFace);
      mask &= Star::CubesOfFaces[mask >> Star::FirstFace & 4095U] | ~(255U << Star::FirstCube);
      masks[i] = mask;
    }
  }

private:
  /// All bits except those of cells that step to `side` along x.
  static std::uint32_t Without(int side)
  {
    std::uint32_t bits = ~0U;
    for (std::size_t cell = 0; cell < 26; ++cell)
    {
      bits &= Star::Steps[cell][0] == side ? ~(1U << cell) : ~0U;
    }
    return bits;
  }

  template <std::size_t... Cells>
  void Compare(std::uint32_t* masks, std::index_sequence<Cells...>) const
  {
    const Order* own = this->Rows[4].data() + 1;
    const Order* near[] = { this->Neighbours(Cells)... };
    const std::int64_t length = this->Length;
    for (std::int64_t i = 0; i < length; ++i)
    {
      // The first nodes of a tie are the ones with the lower index.
      masks[i] = ((IsEarlier(Cells) ? (near[Cells][i] <= own[i] ? 1U << Cells : 0U)
                                    : (near[Cells][i] < own[i] ? 1U << Cells : 0U)) |
        ...);
    }
  }

  const Order* Neighbours(std::size_t cell) const
  {
    const auto& step = Star::Steps[cell];
    return this->Rows[static_cast<std::size_t>(step[1] + 1 + 3 * (step[2] + 1))].data() + 1 +
      step[0];
  }

  /// Cells are numbered by direction within a dimension, so the first half steps backwards.
  static constexpr bool IsEarlier(std::size_t cell)
  {
    return cell < 3 || (cell >= 6 && cell < 12) || (cell >= 18 && cell < 22);
  }

  std::int64_t Length;
  std::array<std::vector<Order>, 9> Rows;
};

/// Adds a row's masks to the set.
void Mark(const std::uint32_t* masks, std::int64_t count, RankedSet& set)
{
  std::uint32_t previous = ~0U;
  for (std::int64_t i = 0; i < count; ++i)
  {
    if (masks[i] != previous)
    {
      previous = masks[i];
      set.Add(previous);
    }
  }
}

/// Bits of the cells that stay in the grid along y and z.
std::uint32_t InsideGrid(const LowerStars::Size& n, std::int64_t j, std::int64_t k)
{
  std::uint32_t bits = 0;
  for (std::size_t cell = 0; cell < 26; ++cell)
  {
    const std::int64_t y = j + Star::Steps[cell][1];
    const std::int64_t z = k + Star::Steps[cell][2];
    bits |= y >= 0 && y < n[1] && z >= 0 && z < n[2] ? 1U << cell : 0U;
  }
  return bits;
}

}

template <typename Stored>
LowerStars::LowerStars(
  const OrderedValues<Stored>& values, const Size& dimensions, const ProgressCallback& progress)
  : Grid(dimensions)
  , Strides{ 1, dimensions[0], dimensions[0] * dimensions[1] }
  , Kinds(new std::uint32_t[static_cast<std::size_t>(this->NodeCount())])
{
  for (std::size_t cell = 0; cell < 27; ++cell)
  {
    const auto& step = Star::Steps[cell];
    this->Offsets[cell] = step[0] + this->Strides[1] * step[1] + this->Strides[2] * step[2];
  }
  RankedSet seen(std::int64_t{ 1 } << 26);
  const std::int64_t rows = dimensions[1] * dimensions[2];
  ParallelFor(
    0, rows, std::max<std::int64_t>(1, 32768 / std::max<std::int64_t>(1, dimensions[0])),
    [&](std::int64_t first, std::int64_t last)
    {
      RowWindow<typename OrderedValues<Stored>::Order> window(dimensions[0]);
      for (std::int64_t row = first; row < last; ++row)
      {
        const std::int64_t j = row % dimensions[1];
        const std::int64_t k = row / dimensions[1];
        window.MoveTo(values, dimensions, j, k, row > first && j > 0);
        std::uint32_t* masks = this->Kinds.get() + row * dimensions[0];
        window.MasksInto(InsideGrid(dimensions, j, k), masks);
        Mark(masks, dimensions[0], seen);
      }
    },
    Between(progress, 0.0, 0.8));
  this->NumberKinds(seen, Between(progress, 0.8, 1.0));
}

void LowerStars::NumberKinds(RankedSet& masks, const ProgressCallback& progress)
{
  masks.Rank([this](std::int64_t mask)
    { this->Matchings.push_back(MatchStar(static_cast<std::uint32_t>(mask))); });
  std::uint32_t* kinds = this->Kinds.get();
  ParallelFor(
    0, this->NodeCount(), 65536,
    [&](std::int64_t first, std::int64_t last)
    {
      // Neighbouring nodes are often of the same kind, and most have all or no neighbours below.
      std::uint32_t mask = ~0U;
      std::uint32_t kind = 0;
      for (std::int64_t node = first; node < last; ++node)
      {
        if (kinds[node] != mask)
        {
          mask = kinds[node];
          kind = masks.FindRank(mask);
        }
        kinds[node] = kind;
      }
    },
    progress);
}

template LowerStars::LowerStars(const OrderedValues<float>&, const Size&, const ProgressCallback&);
template LowerStars::LowerStars(const OrderedValues<double>&, const Size&, const ProgressCallback&);
template LowerStars::LowerStars(
  const OrderedValues<std::uint8_t>&, const Size&, const ProgressCallback&);
template LowerStars::LowerStars(
  const OrderedValues<std::uint16_t>&, const Size&, const ProgressCallback&);
template LowerStars::LowerStars(
  const OrderedValues<std::uint32_t>&, const Size&, const ProgressCallback&);
template LowerStars::LowerStars(
  const OrderedValues<std::uint64_t>&, const Size&, const ProgressCallback&);

}
