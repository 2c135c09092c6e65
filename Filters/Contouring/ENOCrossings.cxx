#include "Contouring/ENOCrossings.h"

#include "Core/Geometry.h"

#include <algorithm>
#include <cmath>

namespace isthmus
{
namespace
{

/// A kink's second difference is this many times those beyond it and around it.
constexpr double KinkFactor = 3.0;

/// Values along a line of the grid, numbered from a node of it.
template <typename T>
struct GridLine
{
  const T* Node;
  std::int64_t Step;
  std::int64_t First, Last; ///< the available nodes

  bool Has(std::int64_t j) const { return j >= this->First && j <= this->Last; }
  double At(std::int64_t j) const { return static_cast<double>(this->Node[j * this->Step]); }
  /// Second difference; 0 at the ends of the line.
  double Bend(std::int64_t j) const
  {
    return this->Has(j - 1) && this->Has(j + 1)
      ? (this->At(j - 1) - this->At(j)) + (this->At(j + 1) - this->At(j))
      : 0.0;
  }
};

/// A slope at a node, per step, and the second difference in it.
struct Slope
{
  double Value = 0.0;
  double Bend = 0.0;
};

/// With second differences d_j, in the unit of the values, the slope jumps by |d_j + d_{j+1}| at a
/// kink between nodes j and j+1. `beyond`: the two d beyond it, on the side that is then used.
bool IsKink(double jump, double beyond, double rough)
{
  return std::abs(jump) > KinkFactor * std::max(beyond, rough);
}

/// On the side towards `ahead`, 1 or -1: of second order where there are two nodes.
template <typename T>
Slope SlopeTowards(const GridLine<T>& line, std::int64_t ahead)
{
  if (!line.Has(ahead))
  {
    return {};
  }
  const double bend = line.Bend(ahead);
  const double step = line.At(ahead) - line.At(0) - 0.5 * bend;
  return { static_cast<double>(ahead) * step,
    std::max(std::abs(bend), std::abs(line.Bend(2 * ahead))) };
}

/// (v_1 - v_{-1}) / 2; where a kink is on one side of the node, of second order on the other.
template <typename T>
Slope SlopeAt(const GridLine<T>& line, double rough)
{
  const Slope up = SlopeTowards(line, 1), down = SlopeTowards(line, -1);
  if (!line.Has(-1) || !line.Has(1))
  {
    return line.Has(1) ? up : down;
  }
  const bool isUp = line.Has(2) && IsKink(line.Bend(-1) + line.Bend(0), up.Bend, rough);
  const bool isDown = line.Has(-2) && IsKink(line.Bend(0) + line.Bend(1), down.Bend, rough);
  if (isUp || isDown)
  {
    return isUp && !(isDown && down.Bend < up.Bend) ? up : down;
  }
  return { 0.5 * (line.At(1) - line.At(-1)), std::abs(line.Bend(0)) };
}

/// v + t slope + t (t + 1) / 2 bend: from a node on, t from 0 to 1, away from the nodes that define
/// it.
struct Parabola
{
  double Value, Slope, Bend;

  double At(double t) const
  {
    return this->Value + t * (this->Slope + 0.5 * (t + 1.0) * this->Bend);
  }
  double SlopeAt(double t) const { return this->Slope + (t + 0.5) * this->Bend; }
};

struct Root
{
  double Fraction;
  double Slope; ///< where a kink is next to it
  int Side;     ///< of the kink: -1, before it; 1, behind it; 0 where there is none
};

/// The fraction up to which `isBefore` holds.
template <typename Before>
double Bisect(const Before& isBefore)
{
  double low = 0.0, high = 1.0;
  for (int halving = 0; halving < 40; ++halving)
  {
    const double middle = 0.5 * (low + high);
    (isBefore(middle) ? low : high) = middle;
  }
  return 0.5 * (low + high);
}

/// The crossing between nodes 0 and 1: of the parabola through both with the smaller one of d_0 and
/// d_1; where a kink lies between them, of the greater (jump > 0) or smaller one of the two
/// parabolas that end there.
template <typename T>
Root RootOn(const GridLine<T>& line, double level, double rough)
{
  const double a = line.At(0), b = line.At(1);
  const bool rises = b > a;
  const double jump = line.Bend(0) + line.Bend(1);
  const double beyond = std::max(std::abs(line.Bend(-1)), std::abs(line.Bend(2)));
  if (!line.Has(-2) || !line.Has(3) || !IsKink(jump, beyond, rough))
  {
    const double least = std::min(std::abs(line.Bend(0)), std::abs(line.Bend(1)));
    const double bend =
      line.Bend(0) * line.Bend(1) > 0.0 ? std::copysign(least, line.Bend(0)) : 0.0;
    const Parabola both{ a, b - a - bend, bend };
    return { Bisect([&](double t) { return (both.At(t) < level) == rises; }), 0.0, 0 };
  }
  const Parabola before{ a, a - line.At(-1), line.Bend(-1) };
  const Parabola behind{ b, b - line.At(2), line.Bend(2) };
  const auto isBefore = [&](double t)
  { return (before.At(t) > behind.At(1.0 - t)) == (jump > 0.0); };
  const double t = Bisect(
    [&](double x) { return ((isBefore(x) ? before.At(x) : behind.At(1.0 - x)) < level) == rises; });
  return isBefore(t) ? Root{ t, before.SlopeAt(t), -1 } : Root{ t, -behind.SlopeAt(1.0 - t), 1 };
}

template <typename T>
class LayerCrossings
{
public:
  using Index = std::array<std::int64_t, 3>;

  LayerCrossings(const LevelView<T>& level, std::vector<GridCrossing>& crossings)
    : Level(level)
    , Crossings(crossings)
    , Size(level.Grid.Dimensions)
    , Step{ 1, Size[0], Size[0] * Size[1] }
  {
  }

  void Run(std::int64_t k)
  {
    for (std::int64_t j = 0; j < this->Size[1]; ++j)
    {
      for (std::int64_t i = 0; i < this->Size[0]; ++i)
      {
        const T* const value = this->Level.Grid.Data + this->Level.Grid.Index(i, j, k);
        const bool isInside = this->IsInside(*value);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          const Index index{ i, j, k };
          if (index[axis] + 1 < this->Size[axis] &&
            this->IsInside(value[this->Step[axis]]) != isInside)
          {
            this->Add(index, axis);
          }
        }
      }
    }
  }

private:
  bool IsInside(T value) const { return this->Level.IsInside(static_cast<double>(value)); }

  GridLine<T> Line(const Index& i, std::size_t axis) const
  {
    return { this->Level.Grid.Data + this->Level.Grid.Index(i[0], i[1], i[2]), this->Step[axis],
      -i[axis], this->Size[axis] - 1 - i[axis] };
  }

  /// Eight times the lower quartile of the second differences at the nodes around an edge.
  double RoughnessAround(const Index& lower, std::size_t axis) const
  {
    std::array<double, 108> bends{};
    std::size_t count = 0;
    Index low, high;
    for (std::size_t a = 0; a < 3; ++a)
    {
      low[a] = std::max<std::int64_t>(0, lower[a] - 1);
      high[a] = std::min(this->Size[a] - 1, lower[a] + (a == axis ? 2 : 1));
    }
    for (Index i = low; i[2] <= high[2]; ++i[2])
    {
      for (i[1] = low[1]; i[1] <= high[1]; ++i[1])
      {
        for (i[0] = low[0]; i[0] <= high[0]; ++i[0])
        {
          for (std::size_t a = 0; a < 3; ++a)
          {
            bends[count++] = std::abs(this->Line(i, a).Bend(0));
          }
        }
      }
    }
    const auto at = [&bends](std::size_t i)
    { return bends.begin() + static_cast<std::ptrdiff_t>(i); };
    std::nth_element(bends.begin(), at(count / 4), at(count));
    return 8.0 * *at(count / 4);
  }

  /// The slope along `along` at the crossing, from the two nodes of the edge or, beside a kink,
  /// from the nearer one and the next on its side.
  double SlopeThere(
    const Index& lower, std::size_t axis, std::size_t along, const Root& root, double rough) const
  {
    const auto at = [&](std::int64_t j)
    {
      Index i = lower;
      i[axis] += j;
      return SlopeAt(this->Line(i, along), rough);
    };
    const double t = root.Fraction;
    const Slope near = at(root.Side > 0 ? 1 : 0);
    const Slope far = at(root.Side < 0 ? -1 : root.Side > 0 ? 2 : 1);
    if (IsKink(far.Bend, near.Bend, rough))
    {
      return near.Value;
    }
    if (root.Side == 0 && IsKink(near.Bend, far.Bend, rough))
    {
      return far.Value;
    }
    const double towardsFar = root.Side < 0 ? -t : root.Side > 0 ? t - 1.0 : t;
    return near.Value + towardsFar * (far.Value - near.Value);
  }

  void Add(const Index& lower, std::size_t axis)
  {
    const GridLine<T> line = this->Line(lower, axis);
    const double rough = this->RoughnessAround(lower, axis);
    const Root root = RootOn(line, this->Level.Level, rough);
    Point3 gradient;
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double slope =
        a == axis && root.Side != 0 ? root.Slope : this->SlopeThere(lower, axis, a, root, rough);
      gradient[a] = slope / this->Level.Grid.Spacing[a];
    }
    if (!(Length(gradient) > 0.0) || !std::isfinite(Length(gradient)))
    {
      gradient = {};
      gradient[axis] = line.At(1) > line.At(0) ? 1.0 : -1.0;
    }
    const double outwards = this->Level.InsideIsHigher ? -1.0 : 1.0;
    this->Crossings.push_back({ this->Level.Grid.Index(lower[0], lower[1], lower[2]),
      static_cast<int>(axis), root.Fraction, (outwards / Length(gradient)) * gradient });
  }

  const LevelView<T>& Level;
  std::vector<GridCrossing>& Crossings;
  const Index Size;
  const Index Step;
};

}

template <typename T>
void AppendENOCrossings(
  const LevelView<T>& level, std::int64_t k, std::vector<GridCrossing>& crossings)
{
  LayerCrossings<T>(level, crossings).Run(k);
}

template void AppendENOCrossings(const LevelView<float>&, std::int64_t, std::vector<GridCrossing>&);
template void AppendENOCrossings(
  const LevelView<double>&, std::int64_t, std::vector<GridCrossing>&);

}
