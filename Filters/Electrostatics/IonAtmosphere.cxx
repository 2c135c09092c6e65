#include "IonAtmosphere.h"

#include "ElectrostaticUnits.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr double Highest = 50.0; // kT/e

double Distance(const InterfaceCrossing& c, const Vector3& y)
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
  // Behind the centre of a hollow the paraboloid says nothing.
  return focus > 0.3 ? std::clamp(s + 0.5 * bend / focus, 0.0, length) : length;
}

/// Which crossing is nearest to each node of a band outside, found front by front.
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
                 : Distance(this->Crossings[static_cast<std::size_t>(c)], this->From(node, c));
  }

private:
  Vector3 From(std::int64_t node, std::int32_t c) const
  {
    const auto& crossing = this->Crossings[static_cast<std::size_t>(c)];
    const Vector3 x = this->Box.Position(node);
    Vector3 y = this->Box.Position(crossing.Node);
    const auto a = static_cast<std::size_t>(crossing.Axis);
    y[a] += crossing.Fraction * this->Box.Spacing[a];
    return { x[0] - y[0], x[1] - y[1], x[2] - y[2] };
  }
  double Squared(std::int64_t node, std::int32_t c) const
  {
    const Vector3 y = this->From(node, c);
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

IonAtmosphere::IonAtmosphere(const std::vector<IonSpecies>& species, double kelvin)
  : Factor(4.0 * Pi * units::CoulombLength(kelvin))
{
  double net = 0.0;
  double total = 0.0;
  for (const IonSpecies& s : species)
  {
    if (!(s.Concentration >= 0.0) || !std::isfinite(s.Concentration) || !std::isfinite(s.Valence))
    {
      throw std::invalid_argument("An ion has the valence " + std::to_string(s.Valence) +
        " and the concentration " + std::to_string(s.Concentration) +
        " mol/l, but concentrations are 0 or more and both are finite numbers.");
    }
    if (s.Concentration > 0.0 && s.Valence != 0.0)
    {
      this->Species.push_back({ s.Valence, s.Concentration * units::IonsPerCubicAngstrom });
      net += s.Valence * s.Concentration;
      total += std::abs(s.Valence) * s.Concentration;
    }
  }
  if (std::abs(net) > 1e-6 * total)
  {
    throw std::invalid_argument("The ions of the salt carry " + std::to_string(net) +
      " mol/l of charge in all, but a solution is neutral: change a concentration.");
  }
}

double IonAtmosphere::Charge(double u) const
{
  const double v = std::clamp(u, -Highest, Highest);
  double sum = 0.0;
  for (const IonSpecies& s : this->Species)
  {
    sum -= s.Valence * s.Concentration * std::exp(-s.Valence * v);
  }
  return this->Factor * sum + (u - v) * (u == v ? 0.0 : this->Derivative(u));
}

double IonAtmosphere::Derivative(double u) const
{
  const double v = std::clamp(u, -Highest, Highest);
  double sum = 0.0;
  for (const IonSpecies& s : this->Species)
  {
    sum += s.Valence * s.Valence * s.Concentration * std::exp(-s.Valence * v);
  }
  return this->Factor * sum;
}

double IonAtmosphere::Energy(double u) const
{
  double sum = 0.0;
  for (const IonSpecies& s : this->Species)
  {
    const double e = std::exp(-s.Valence * std::clamp(u, -Highest, Highest));
    sum -= s.Concentration * (0.5 * s.Valence * e * u + (e - 1.0));
  }
  return sum;
}

std::vector<float> IonAccess(const SolverBox& box, const std::vector<unsigned char>& inside,
  const std::vector<InterfaceCrossing>& crossings, double layer)
{
  std::vector<float> access(inside.size());
  std::transform(inside.begin(), inside.end(), access.begin(),
    [](unsigned char in) { return in ? 0.0F : 1.0F; });
  if (layer <= 0.0)
  {
    return access;
  }
  const double h = std::cbrt(box.Spacing[0] * box.Spacing[1] * box.Spacing[2]);
  const double widest = *std::max_element(box.Spacing.begin(), box.Spacing.end());
  NearestCrossings nearest(box, inside, crossings);
  nearest.Spread(layer + 2.0 * widest);
  for (std::size_t node = 0; node < access.size(); ++node)
  {
    const double d = inside[node] ? -1.0 : nearest.At(static_cast<std::int64_t>(node));
    if (d >= 0.0)
    {
      access[node] = static_cast<float>(std::clamp(0.5 + (d - layer) / h, 0.0, 1.0));
    }
  }
  return access;
}

}
