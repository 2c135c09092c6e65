#include "Electrostatics/ChargeTree.h"

#include "Core/ParallelFor.h"
#include "Electrostatics/ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

// 5^3 equivalent charges at Chebyshev points, used up to half their distance in size: relative
// errors of about 1e-5. Boxes with fewer charges than that are leaves.
constexpr std::size_t Order1D = 5;
constexpr std::size_t StandInsOfBox = Order1D * Order1D * Order1D;
constexpr double OpeningRatio = 0.5;

using Points = std::array<double, Order1D>;

Points ChebyshevPoints(double low, double high)
{
  Points points;
  for (std::size_t m = 0; m < Order1D; ++m)
  {
    const double angle = (static_cast<double>(m) + 0.5) * Pi / Order1D;
    points[m] = 0.5 * (low + high) + 0.5 * (high - low) * std::cos(angle);
  }
  return points;
}

/// The contribution of a charge at x to the equivalent charges at `points` along one axis.
Points LagrangeWeights(const Points& points, double x)
{
  Points weights;
  for (std::size_t m = 0; m < Order1D; ++m)
  {
    weights[m] = 1.0;
    for (std::size_t k = 0; k < Order1D; ++k)
    {
      weights[m] *= k == m ? 1.0 : (x - points[k]) / (points[m] - points[k]);
    }
  }
  return weights;
}

const std::vector<double>& Coordinate(const ChargeList& charges, std::size_t axis)
{
  return axis == 0 ? charges.X : axis == 1 ? charges.Y : charges.Z;
}

}

ChargeTree::ChargeTree(const ChargeList& charges)
{
  std::vector<std::size_t> order(charges.Size());
  std::iota(order.begin(), order.end(), std::size_t(0));
  if (!order.empty())
  {
    this->Build(charges, order, 0, order.size());
  }
  ParallelFor(0, static_cast<std::int64_t>(this->Boxes.size()), 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t b = first; b < last; ++b)
      {
        Box& box = this->Boxes[static_cast<std::size_t>(b)];
        if (box.Children[0] >= 0)
        {
          AddStandIns(charges, order, box);
        }
      }
    });
  for (const std::size_t c : order)
  {
    this->Sorted.Add({ charges.X[c], charges.Y[c], charges.Z[c] }, charges.Charge[c]);
  }
}

std::int64_t ChargeTree::Build(
  const ChargeList& charges, std::vector<std::size_t>& order, std::size_t first, std::size_t last)
{
  Box box;
  box.First = first;
  box.Last = last;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto& x = Coordinate(charges, a);
    box.Low[a] = box.High[a] = x[order[first]];
    for (std::size_t i = first; i < last; ++i)
    {
      box.Low[a] = std::min(box.Low[a], x[order[i]]);
      box.High[a] = std::max(box.High[a], x[order[i]]);
    }
    // Flat boxes get a thickness, so that their points differ.
    const double thin = 1e-3;
    if (box.High[a] - box.Low[a] < thin)
    {
      box.High[a] += thin;
      box.Low[a] -= thin;
    }
  }
  const auto id = static_cast<std::int64_t>(this->Boxes.size());
  this->Boxes.push_back(box);
  if (last - first <= StandInsOfBox)
  {
    return id;
  }
  std::size_t longest = 0;
  for (std::size_t a = 1; a < 3; ++a)
  {
    longest = box.High[a] - box.Low[a] > box.High[longest] - box.Low[longest] ? a : longest;
  }
  const auto& x = Coordinate(charges, longest);
  const std::size_t middle = first + (last - first) / 2;
  const auto at = [&](std::size_t i) { return order.begin() + static_cast<std::ptrdiff_t>(i); };
  // Ties are decided by index: the tree depends only on the charges.
  std::nth_element(at(first), at(middle), at(last),
    [&](std::size_t i, std::size_t j) { return x[i] != x[j] ? x[i] < x[j] : i < j; });
  const std::int64_t low = this->Build(charges, order, first, middle);
  const std::int64_t high = this->Build(charges, order, middle, last);
  this->Boxes[static_cast<std::size_t>(id)].Children[0] = low;
  this->Boxes[static_cast<std::size_t>(id)].Children[1] = high;
  return id;
}

void ChargeTree::AddStandIns(
  const ChargeList& charges, const std::vector<std::size_t>& order, Box& box)
{
  const Points px = ChebyshevPoints(box.Low[0], box.High[0]);
  const Points py = ChebyshevPoints(box.Low[1], box.High[1]);
  const Points pz = ChebyshevPoints(box.Low[2], box.High[2]);
  std::vector<double> sums(StandInsOfBox, 0.0);
  for (std::size_t i = box.First; i < box.Last; ++i)
  {
    const std::size_t c = order[i];
    const Points wx = LagrangeWeights(px, charges.X[c]);
    const Points wy = LagrangeWeights(py, charges.Y[c]);
    const Points wz = LagrangeWeights(pz, charges.Z[c]);
    for (std::size_t s = 0; s < StandInsOfBox; ++s)
    {
      sums[s] += charges.Charge[c] * wx[s % Order1D] * wy[s / Order1D % Order1D] *
        wz[s / (Order1D * Order1D)];
    }
  }
  for (std::size_t s = 0; s < StandInsOfBox; ++s)
  {
    box.StandIns.Add(
      { px[s % Order1D], py[s / Order1D % Order1D], pz[s / (Order1D * Order1D)] }, sums[s]);
  }
}

/// Whether the box's equivalent charges may replace its charges, for targets within a ball.
bool ChargeTree::IsFar(const Box& box, const Point3& center, double radius)
{
  double size2 = 0.0;
  double distance2 = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double half = 0.5 * (box.High[a] - box.Low[a]);
    const double off = center[a] - 0.5 * (box.High[a] + box.Low[a]);
    size2 += half * half;
    distance2 += off * off;
  }
  return std::sqrt(size2) < OpeningRatio * (std::sqrt(distance2) - radius);
}

void ChargeTree::Gather(const Point3& center, double radius, ChargeList& seen) const
{
  seen.Clear();
  if (!this->Boxes.empty())
  {
    this->Gather(0, center, radius, seen);
  }
}

void ChargeTree::Gather(
  std::int64_t id, const Point3& center, double radius, ChargeList& seen) const
{
  const Box& box = this->Boxes[static_cast<std::size_t>(id)];
  const bool leaf = box.Children[0] < 0;
  const bool far = !leaf && IsFar(box, center, radius);
  // Leaves use their charges directly; their range of Sorted is consecutive.
  if (leaf || far)
  {
    const ChargeList& from = far ? box.StandIns : this->Sorted;
    seen.Append(from, far ? 0 : box.First, far ? from.Size() : box.Last);
    return;
  }
  this->Gather(box.Children[0], center, radius, seen);
  this->Gather(box.Children[1], center, radius, seen);
}

double ChargeTree::ScreenedSum(const Point3& x, double kappa) const
{
  return this->Boxes.empty() ? 0.0 : this->ScreenedSum(0, x, kappa);
}

double ChargeTree::ScreenedSum(std::int64_t id, const Point3& x, double kappa) const
{
  const Box& box = this->Boxes[static_cast<std::size_t>(id)];
  if (box.Children[0] < 0)
  {
    return isthmus::ScreenedSum(this->Sorted, kappa, x, box.First, box.Last);
  }
  if (IsFar(box, x, 0.0))
  {
    return isthmus::ScreenedSum(box.StandIns, kappa, x);
  }
  return this->ScreenedSum(box.Children[0], x, kappa) +
    this->ScreenedSum(box.Children[1], x, kappa);
}

}
