#include "ChokingLoops/StripFunnel.h"

#include <algorithm>

namespace isthmus
{
namespace
{

/// A point where the shortest path touches the border of the strip.
struct Bend
{
  std::size_t Edge; ///< index from the start of the strip
  bool AtFrom;
};

/// Shortest path from p to q through the unfolded edges 1 .. n - 1 (funnel).
std::vector<Bend> Funnel(const UnfoldedStrip& plane, const Point2& p, const Point2& q)
{
  const std::size_t n = plane.From.size() - 1;
  std::vector<Bend> bends;
  Point2 apex = p;
  std::size_t left = 0;
  std::size_t right = 0;
  Point2 leftEnd = p;
  Point2 rightEnd = p;
  const auto restart = [&](const Point2& at, std::size_t edge)
  {
    apex = leftEnd = rightEnd = at;
    left = right = edge;
    return edge;
  };
  // Collinear corners may restart it in vain: a path has at most n bends.
  for (std::size_t i = 1; i <= n && bends.size() <= n; ++i)
  {
    const Point2& newLeft = i < n ? plane.From[i] : q;
    const Point2& newRight = i < n ? plane.To[i] : q;
    // The right side swings inward (to the left), or starts.
    if (Cross2(apex, rightEnd, newRight) >= 0.0)
    {
      if (apex == rightEnd || Cross2(apex, leftEnd, newRight) < 0.0 || apex == leftEnd)
      {
        rightEnd = newRight;
        right = i;
      }
      else
      {
        bends.push_back({ left, true });
        i = restart(leftEnd, left);
        continue;
      }
    }
    if (Cross2(apex, leftEnd, newLeft) <= 0.0)
    {
      if (apex == leftEnd || Cross2(apex, rightEnd, newLeft) > 0.0 || apex == rightEnd)
      {
        leftEnd = newLeft;
        left = i;
      }
      else
      {
        bends.push_back({ right, false });
        i = restart(rightEnd, right);
        continue;
      }
    }
  }
  // The end itself, met as a corner, is no bend.
  while (!bends.empty() && bends.back().Edge >= n)
  {
    bends.pop_back();
  }
  return bends;
}

/// Where the polyline p, bends, q crosses each edge, as fractions from From to To.
std::vector<double> CrossingsOf(
  const UnfoldedStrip& plane, const std::vector<Bend>& bends, const Point2& p, const Point2& q)
{
  const std::size_t n = plane.From.size() - 1;
  std::vector<double> fraction(n, 0.0);
  Point2 here = p;
  std::size_t edge = 1;
  for (std::size_t b = 0; b <= bends.size(); ++b)
  {
    const bool last = b == bends.size();
    const Point2 there =
      last ? q : (bends[b].AtFrom ? plane.From[bends[b].Edge] : plane.To[bends[b].Edge]);
    for (const std::size_t end = last ? n : bends[b].Edge + 1; edge < end; ++edge)
    {
      const double a = Cross2(here, there, plane.From[edge]);
      const double c = Cross2(here, there, plane.To[edge]);
      fraction[edge] = a == c ? 0.5 : std::clamp(a / (a - c), 0.0, 1.0);
    }
    if (!last)
    {
      fraction[bends[b].Edge] = bends[b].AtFrom ? 0.0 : 1.0;
    }
    here = there;
  }
  return fraction;
}

}

std::vector<double> ShortestCrossings(const UnfoldedStrip& plane, const Point2& p, const Point2& q)
{
  return CrossingsOf(plane, Funnel(plane, p, q), p, q);
}

}
