#include "Persistence/FastMarching.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace isthmus
{
namespace
{

class March
{
public:
  March(const std::array<std::int64_t, 3>& dimensions, double spacing, float greatest,
    std::vector<float>& values)
    : Size(dimensions)
    , Strides{ 1, dimensions[0], dimensions[0] * dimensions[1] }
    , Spacing(spacing)
    , Greatest(greatest)
    , Values(values)
    , Fixed(values.size(), 0)
  {
  }

  void Run(const std::vector<std::int64_t>& known)
  {
    for (const std::int64_t node : known)
    {
      this->Open.push({ this->Value(node), node });
    }
    while (!this->Open.empty())
    {
      const auto [value, node] = this->Open.top();
      this->Open.pop();
      if (this->Fixed[static_cast<std::size_t>(node)] || value > this->Value(node))
      {
        continue;
      }
      this->Fixed[static_cast<std::size_t>(node)] = 1;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        for (const std::int64_t side : { -1, 1 })
        {
          if (this->IsInside(node, axis, side))
          {
            this->Update(node + side * this->Strides[axis]);
          }
        }
      }
    }
  }

private:
  float& Value(std::int64_t node) { return this->Values[static_cast<std::size_t>(node)]; }

  bool IsInside(std::int64_t node, std::size_t axis, std::int64_t side) const
  {
    const std::int64_t to = node / this->Strides[axis] % this->Size[axis] + side;
    return to >= 0 && to < this->Size[axis];
  }

  void Update(std::int64_t node)
  {
    if (this->Fixed[static_cast<std::size_t>(node)])
    {
      return;
    }
    // The nearest fixed neighbour along each axis, nearest first.
    double near[3];
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      near[axis] = std::numeric_limits<double>::infinity();
      for (const std::int64_t side : { -1, 1 })
      {
        const std::int64_t beside = node + side * this->Strides[axis];
        if (this->IsInside(node, axis, side) && this->Fixed[static_cast<std::size_t>(beside)])
        {
          near[axis] = std::min(near[axis], static_cast<double>(this->Value(beside)));
        }
      }
    }
    std::sort(near, near + 3);
    const auto value = static_cast<float>(this->Solve(near));
    if (value < this->Value(node) && value < this->Greatest)
    {
      this->Value(node) = value;
      this->Open.push({ value, node });
    }
  }

  /// sum over the axes in use of (d - near)^2 = spacing^2; an axis is in use if d comes out above.
  double Solve(const double near[3]) const
  {
    double value = near[0] + this->Spacing;
    double sum = near[0];
    double squares = near[0] * near[0];
    for (int axes = 2; axes <= 3 && value > near[axes - 1]; ++axes)
    {
      sum += near[axes - 1];
      squares += near[axes - 1] * near[axes - 1];
      const double root = sum * sum - axes * (squares - this->Spacing * this->Spacing);
      value = (sum + std::sqrt(std::max(0.0, root))) / axes;
    }
    return value;
  }

  using Entry = std::pair<float, std::int64_t>;

  std::array<std::int64_t, 3> Size;
  std::array<std::int64_t, 3> Strides;
  double Spacing;
  float Greatest;
  std::vector<float>& Values;
  std::vector<char> Fixed;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<Entry>> Open;
};

}

void FastMarch(const std::array<std::int64_t, 3>& dimensions, double spacing,
  const std::vector<std::int64_t>& known, float greatest, std::vector<float>& values)
{
  March(dimensions, spacing, greatest, values).Run(known);
}

}
