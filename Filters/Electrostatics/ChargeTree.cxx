#include "ChargeTree.h"

#include "ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace isthmus
{
namespace
{

constexpr std::size_t Order1D = 5;
constexpr std::size_t StandInsOfBox = Order1D * Order1D * Order1D;
constexpr double OpeningRatio = 0.5;

using Points = std::array<double, Order1D>;

Points ChebyshevPoints(double low, double high)
{
  Points points;
  for (std::size_t m = 0; m < Order1D; ++m)
  {
    const double angle = (static_cast<double>(m) + 0.5) * units::Pi / Order1D;
    points[m] = 0.5 * (low + high) + 0.5 * (high - low) * std::cos(angle);
  }
  return points;
}

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
  : Charges(charges)
  , Order(charges.Size())
{
  std::iota(this->Order.begin(), this->Order.end(), std::size_t(0));
  if (!this->Order.empty())
  {
    this->Build(0, this->Order.size());
  }
}

std::int64_t ChargeTree::Build(std::size_t first, std::size_t last)
{
  Box box;
  box.First = first;
  box.Last = last;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto& x = Coordinate(this->Charges, a);
    box.Low[a] = box.High[a] = x[this->Order[first]];
    for (std::size_t i = first; i < last; ++i)
    {
      box.Low[a] = std::min(box.Low[a], x[this->Order[i]]);
      box.High[a] = std::max(box.High[a], x[this->Order[i]]);
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
  const auto& x = Coordinate(this->Charges, longest);
  const std::size_t middle = first + (last - first) / 2;
  std::nth_element(this->Order.begin() + static_cast<std::ptrdiff_t>(first),
    this->Order.begin() + static_cast<std::ptrdiff_t>(middle),
    this->Order.begin() + static_cast<std::ptrdiff_t>(last),
    [&](std::size_t i, std::size_t j) { return x[i] != x[j] ? x[i] < x[j] : i < j; });
  this->AddStandIns(this->Boxes[static_cast<std::size_t>(id)]);
  const std::int64_t low = this->Build(first, middle);
  const std::int64_t high = this->Build(middle, last);
  this->Boxes[static_cast<std::size_t>(id)].Children[0] = low;
  this->Boxes[static_cast<std::size_t>(id)].Children[1] = high;
  return id;
}

void ChargeTree::AddStandIns(Box& box) const
{
  const Points px = ChebyshevPoints(box.Low[0], box.High[0]);
  const Points py = ChebyshevPoints(box.Low[1], box.High[1]);
  const Points pz = ChebyshevPoints(box.Low[2], box.High[2]);
  std::vector<double> sums(StandInsOfBox, 0.0);
  for (std::size_t i = box.First; i < box.Last; ++i)
  {
    const std::size_t c = this->Order[i];
    const Points wx = LagrangeWeights(px, this->Charges.X[c]);
    const Points wy = LagrangeWeights(py, this->Charges.Y[c]);
    const Points wz = LagrangeWeights(pz, this->Charges.Z[c]);
    for (std::size_t s = 0; s < StandInsOfBox; ++s)
    {
      sums[s] += this->Charges.Charge[c] * wx[s % Order1D] * wy[s / Order1D % Order1D] *
        wz[s / (Order1D * Order1D)];
    }
  }
  for (std::size_t s = 0; s < StandInsOfBox; ++s)
  {
    box.StandIns.Add(
      { px[s % Order1D], py[s / Order1D % Order1D], pz[s / (Order1D * Order1D)] }, sums[s]);
  }
}

void ChargeTree::Gather(const Vector3& centre, double radius, ChargeList& seen) const
{
  seen.Clear();
  if (!this->Boxes.empty())
  {
    this->Gather(0, centre, radius, seen);
  }
}

void ChargeTree::Gather(
  std::int64_t id, const Vector3& centre, double radius, ChargeList& seen) const
{
  const Box& box = this->Boxes[static_cast<std::size_t>(id)];
  double size2 = 0.0;
  double distance2 = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double half = 0.5 * (box.High[a] - box.Low[a]);
    const double off = centre[a] - 0.5 * (box.High[a] + box.Low[a]);
    size2 += half * half;
    distance2 += off * off;
  }
  const bool leaf = box.Children[0] < 0;
  if (!leaf && std::sqrt(size2) < OpeningRatio * (std::sqrt(distance2) - radius))
  {
    const ChargeList& s = box.StandIns;
    for (std::size_t i = 0; i < s.Size(); ++i)
    {
      seen.Add({ s.X[i], s.Y[i], s.Z[i] }, s.Charge[i]);
    }
    return;
  }
  if (leaf)
  {
    for (std::size_t i = box.First; i < box.Last; ++i)
    {
      const std::size_t c = this->Order[i];
      seen.Add(
        { this->Charges.X[c], this->Charges.Y[c], this->Charges.Z[c] }, this->Charges.Charge[c]);
    }
    return;
  }
  this->Gather(box.Children[0], centre, radius, seen);
  this->Gather(box.Children[1], centre, radius, seen);
}

}
