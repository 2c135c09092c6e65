#include "Contouring/ContourRings.h"

namespace isthmus
{
namespace
{

/// The corner of a polygon, and the ones after and before it.
struct Wedge
{
  std::int64_t Corner, Next, Before, Edge;
  bool operator<(const Wedge& o) const
  {
    return this->Corner != o.Corner ? this->Corner < o.Corner : this->Next < o.Next;
  }
};

using Wedges = std::vector<Wedge>;

/// All wedges of one corner, ordered by Next.
struct Around
{
  Wedges::const_iterator First, Last;

  std::size_t Size() const { return static_cast<std::size_t>(this->Last - this->First); }
  /// The wedge beyond the side towards Before; Size() when there is none.
  std::size_t After(std::size_t wedge) const
  {
    const std::int64_t side = this->First[static_cast<std::ptrdiff_t>(wedge)].Before;
    const auto found = std::lower_bound(
      this->First, this->Last, side, [](const Wedge& w, std::int64_t id) { return w.Next < id; });
    return found != this->Last && found->Next == side
      ? static_cast<std::size_t>(found - this->First)
      : this->Size();
  }
};

bool IsRing(const Around& around, bool mayBeOpen)
{
  const std::size_t count = around.Size();
  const auto sameNext = [](const Wedge& a, const Wedge& b) { return a.Next == b.Next; };
  if (std::adjacent_find(around.First, around.Last, sameNext) != around.Last)
  {
    return false;
  }
  std::vector<char> isReached(count, 0);
  for (std::size_t w = 0; w < count; ++w)
  {
    if (around.After(w) < count)
    {
      isReached[around.After(w)] = 1;
    }
  }
  const auto start =
    static_cast<std::size_t>(std::find(isReached.begin(), isReached.end(), 0) - isReached.begin());
  const bool isChain = start < count;
  const std::size_t first = isChain ? start : 0;
  std::size_t steps = 1;
  for (std::size_t w = around.After(first); w < count && w != first && steps <= count; ++steps)
  {
    w = around.After(w);
  }
  return steps == count && (isChain ? mayBeOpen : count >= 3);
}

Wedges WedgesOf(const ContourPolygons& polygons)
{
  Wedges wedges;
  for (std::size_t i = 0; i < polygons.Corners.size(); ++i)
  {
    const auto& q = polygons.Corners[i];
    const std::size_t count = q[3] < 0 ? 3 : 4;
    for (std::size_t c = 0; c < count; ++c)
    {
      wedges.push_back({ q[c], q[(c + 1) % count], q[(c + count - 1) % count], polygons.Edge[i] });
    }
  }
  std::sort(wedges.begin(), wedges.end());
  return wedges;
}

}

BadRings FindBadRings(const ContourPolygons& polygons, const std::vector<char>& mayBeOpen)
{
  BadRings bad{ polygons.Folded, std::vector<char>(mayBeOpen.size(), 0) };
  const Wedges wedges = WedgesOf(polygons);
  for (auto first = wedges.begin(), last = first; first != wedges.end(); first = last)
  {
    const std::int64_t corner = first->Corner;
    last =
      std::find_if(first, wedges.end(), [corner](const Wedge& w) { return w.Corner != corner; });
    const auto at = static_cast<std::size_t>(corner);
    const bool isMore = at >= mayBeOpen.size();
    if (!isMore)
    {
      bad.IsThere[at] = 1;
    }
    if (!IsRing({ first, last }, isMore || mayBeOpen[at] != 0))
    {
      std::for_each(first, last, [&bad](const Wedge& w) { bad.Edges.push_back(w.Edge); });
    }
  }
  return bad;
}

}
