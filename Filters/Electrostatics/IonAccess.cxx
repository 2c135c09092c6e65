#include "Electrostatics/IonAccess.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace isthmus
{
namespace
{

double DistanceFrom(const InterfaceCrossing& c, const Point3& y)
{
  const auto& n = c.Frame.Normal;
  const auto& w = c.Frame.Curvature;
  const double s = n[0] * y[0] + n[1] * y[1] + n[2] * y[2];
  const double y2 = y[0] * y[0] + y[1] * y[1] + y[2] * y[2];
  const double t2 = std::max(y2 - s * s, 0.0);
  const double bend = w[0] * y[0] * y[0] + w[1] * y[1] * y[1] + w[2] * y[2] * y[2] +
    2.0 * (w[3] * y[0] * y[1] + w[4] * y[0] * y[2] + w[5] * y[1] * y[2]);
  const double length = std::sqrt(y2);
  if (t2 <= 0.0)
  {
    return length;
  }
  const double focus = 1.0 + s * bend / t2;
  // Beyond the center of curvature of a hollow the paraboloid is meaningless.
  return focus > 0.3 ? std::clamp(s + 0.5 * bend / focus, 0.0, length) : length;
}

/// The nearest crossing of each node of a band outside, found front by front.
class NearestCrossings
{
public:
  NearestCrossings(const SolverBox& box, const std::vector<unsigned char>& inside,
    const std::vector<InterfaceCrossing>& crossings)
    : Box(box)
    , Inside(inside)
    , Crossings(crossings)
    , Nearest(inside.size(), -1)
  {
  }

  /// Fronts from the crossings outwards: a node takes over the nearest crossing of its neighbours.
  void Spread(double reach)
  {
    std::vector<std::int64_t> front;
    const auto steps = this->Box.Steps();
    for (std::size_t c = 0; c < this->Crossings.size(); ++c)
    {
      const auto& crossing = this->Crossings[c];
      const std::int64_t upper = crossing.Node + steps[static_cast<std::size_t>(crossing.Axis)];
      for (const std::int64_t node : { crossing.Node, upper })
      {
        this->Offer(node, static_cast<std::int32_t>(c), reach, front);
      }
    }
    while (!front.empty())
    {
      std::vector<std::int64_t> next;
      for (const std::int64_t node : front)
      {
        const std::int32_t c = this->Nearest[static_cast<std::size_t>(node)];
        for (int n = 0; n < 27; ++n)
        {
          const std::int64_t other = this->Neighbour(node, n % 3 - 1, n / 3 % 3 - 1, n / 9 - 1);
          if (other >= 0)
          {
            this->Offer(other, c, reach, next);
          }
        }
      }
      front.swap(next);
    }
  }

  /// Distance of a node from the surface; negative where it is beyond reach.
  double At(std::int64_t node) const
  {
    const std::int32_t c = this->Nearest[static_cast<std::size_t>(node)];
    return c < 0 ? -1.0
                 : DistanceFrom(this->Crossings[static_cast<std::size_t>(c)], this->From(node, c));
  }

  /// The point of the surface next to a node within reach, and the normal there.
  IonBorderNode FindFoot(std::int64_t node, double distance) const
  {
    const auto& c =
      this->Crossings[static_cast<std::size_t>(this->Nearest[static_cast<std::size_t>(node)])];
    const Point3 y = this->From(node, this->Nearest[static_cast<std::size_t>(node)]);
    const auto& w = c.Frame.Curvature;
    Point3 m{ c.Frame.Normal[0] + w[0] * y[0] + w[3] * y[1] + w[4] * y[2],
      c.Frame.Normal[1] + w[3] * y[0] + w[1] * y[1] + w[5] * y[2],
      c.Frame.Normal[2] + w[4] * y[0] + w[5] * y[1] + w[2] * y[2] };
    const double length = std::sqrt(m[0] * m[0] + m[1] * m[1] + m[2] * m[2]);
    const Point3 x = this->Box.Position(node);
    IonBorderNode result{ node, {}, {} };
    for (std::size_t a = 0; a < 3; ++a)
    {
      result.Normal[a] = length > 0.0 ? m[a] / length : c.Frame.Normal[a];
      result.Foot[a] = x[a] - distance * result.Normal[a];
    }
    return result;
  }

private:
  Point3 From(std::int64_t node, std::int32_t c) const
  {
    const auto& crossing = this->Crossings[static_cast<std::size_t>(c)];
    const Point3 x = this->Box.Position(node);
    Point3 y = this->Box.Position(crossing.Node);
    const auto a = static_cast<std::size_t>(crossing.Axis);
    y[a] += crossing.Fraction * this->Box.Spacing[a];
    return { x[0] - y[0], x[1] - y[1], x[2] - y[2] };
  }
  double Squared(std::int64_t node, std::int32_t c) const
  {
    const Point3 y = this->From(node, c);
    return y[0] * y[0] + y[1] * y[1] + y[2] * y[2];
  }
  std::int64_t Neighbour(std::int64_t node, int i, int j, int k) const
  {
    const auto& n = this->Box.Dimensions;
    const std::int64_t x = node % n[0] + i;
    const std::int64_t y = node / n[0] % n[1] + j;
    const std::int64_t z = node / (n[0] * n[1]) + k;
    const bool within = x >= 0 && x < n[0] && y >= 0 && y < n[1] && z >= 0 && z < n[2];
    return within ? x + n[0] * (y + n[1] * z) : -1;
  }
  void Offer(std::int64_t node, std::int32_t c, double reach, std::vector<std::int64_t>& changed)
  {
    auto& nearest = this->Nearest[static_cast<std::size_t>(node)];
    if (this->Inside[static_cast<std::size_t>(node)] || nearest == c)
    {
      return;
    }
    const double squared = this->Squared(node, c);
    if (squared <= reach * reach && (nearest < 0 || squared < this->Squared(node, nearest)))
    {
      nearest = c;
      changed.push_back(node);
    }
  }

  const SolverBox& Box;
  const std::vector<unsigned char>& Inside;
  const std::vector<InterfaceCrossing>& Crossings;
  std::vector<std::int32_t> Nearest;
};

}

std::vector<float> IonAccess(const SolverBox& box, const std::vector<unsigned char>& inside,
  const std::vector<InterfaceCrossing>& crossings, double layer, std::vector<IonBorderNode>* border)
{
  std::vector<float> access(inside.size());
  std::transform(inside.begin(), inside.end(), access.begin(),
    [](unsigned char in) { return in ? 0.0F : 1.0F; });
  if (layer <= 0.0)
  {
    return access;
  }
  const double h = IonBorderWidth(box);
  const double widest = *std::max_element(box.Spacing.begin(), box.Spacing.end());
  NearestCrossings nearest(box, inside, crossings);
  // The border is blurred by one spacing, which a diagonal may exceed.
  nearest.Spread(layer + 2.0 * widest);
  for (std::size_t node = 0; node < access.size(); ++node)
  {
    const double d = inside[node] ? -1.0 : nearest.At(static_cast<std::int64_t>(node));
    if (d >= 0.0)
    {
      const double part = std::clamp(0.5 + (d - layer) / h, 0.0, 1.0);
      access[node] = static_cast<float>(part);
      if (border && part > 0.0 && part < 1.0)
      {
        border->push_back(nearest.FindFoot(static_cast<std::int64_t>(node), d));
      }
    }
  }
  return access;
}

std::vector<CutCell> CutCells(const SolverBox& box, const std::vector<unsigned char>& inside,
  const std::vector<InterfaceCrossing>& crossings)
{
  struct Candidate
  {
    std::int64_t Node;
    double Squared, Distance;
    std::size_t Crossing;
  };
  std::vector<Candidate> candidates;
  for (std::size_t c = 0; c < crossings.size(); ++c)
  {
    const auto a = static_cast<std::size_t>(crossings[c].Axis);
    const SurfaceFrame& frame = crossings[c].Frame;
    for (const bool upper : { false, true })
    {
      const double y =
        (upper ? 1.0 - crossings[c].Fraction : -crossings[c].Fraction) * box.Spacing[a];
      candidates.push_back({ crossings[c].Node + (upper ? box.Steps()[a] : 0), y * y,
        frame.Normal[a] * y + 0.5 * frame.Curvature[a] * y * y, c });
    }
  }
  std::sort(candidates.begin(), candidates.end(),
    [](const Candidate& one, const Candidate& other)
    {
      return std::tie(one.Node, one.Squared, one.Crossing) <
        std::tie(other.Node, other.Squared, other.Crossing);
    });
  std::vector<CutCell> cells;
  for (std::size_t i = 0; i < candidates.size(); ++i)
  {
    if (i == 0 || candidates[i].Node != candidates[i - 1].Node)
    {
      const double part = std::clamp(0.5 + candidates[i].Distance / IonBorderWidth(box), 0.0, 1.0);
      const bool in = inside[static_cast<std::size_t>(candidates[i].Node)] != 0;
      cells.push_back({ candidates[i].Node, candidates[i].Crossing, in ? part : part - 1.0 });
    }
  }
  return cells;
}

}
