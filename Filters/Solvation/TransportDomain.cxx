#include "Solvation/TransportDomain.h"

#include "Core/MemoryBudget.h"
#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SolventExcludedSurface.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr double BytesPerNode = 220.0; // grid, potential, two species, network, output

}

void RequireMemory(const TransportDomain& d, double bytesPerNode)
{
  double nodes = 1.0;
  for (const std::int64_t n : d.Dimensions)
  {
    nodes *= static_cast<double>(n);
  }
  MemoryBudget().Require(bytesPerNode * nodes,
    "A grid of " + std::to_string(d.Dimensions[0]) + " x " + std::to_string(d.Dimensions[1]) +
      " x " + std::to_string(d.Dimensions[2]) + " nodes (Spacing " + std::to_string(d.Spacing) +
      ")",
    "choose a larger Spacing or a smaller Padding");
}

std::array<double, 2> TransportDomain::AlongAndOff(const Point3& place) const
{
  const Point3 from{ place[0] - this->Centre[0], place[1] - this->Centre[1],
    place[2] - this->Centre[2] };
  const double along =
    from[0] * this->Normal[0] + from[1] * this->Normal[1] + from[2] * this->Normal[2];
  double square = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double off = from[a] - along * this->Normal[a];
    square += off * off;
  }
  return { along, std::sqrt(square) };
}

TransportDomain DomainAround(
  const std::vector<Ball>& atoms, const IonTransportParameters& parameters)
{
  CheckTransport(parameters);
  const MembraneSlab& membrane = parameters.Membrane;
  TransportDomain d;
  d.Spacing = parameters.Spacing;
  d.Centre = membrane.Centre;
  const Point3& n = membrane.Normal;
  const double length = std::hypot(n[0], n[1], n[2]);
  d.Normal = { n[0] / length, n[1] / length, n[2] / length };
  double far = 0.5 * membrane.Thickness;
  double wide = membrane.LumenRadius;
  for (const Ball& ball : atoms)
  {
    const auto [along, off] = d.AlongAndOff(ball.Centre);
    far = std::max(far, std::abs(along) + ball.Radius);
    wide = std::max(wide, off + ball.Radius);
  }
  d.Radius = wide + parameters.Padding;
  const double h = d.Spacing;
  d.HalfLength = h * std::ceil((far + parameters.Padding) / h - 1e-6);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double across = std::sqrt(std::max(0.0, 1.0 - d.Normal[a] * d.Normal[a]));
    const double half = std::abs(d.Normal[a]) * d.HalfLength + across * d.Radius;
    const double nodes = std::ceil(half / h - 1e-6) + 1.0;
    if (!(nodes < 1e9))
    {
      throw std::invalid_argument("A Spacing of " + std::to_string(h) + " makes " +
        std::to_string(2.0 * nodes) +
        " nodes along an axis: choose a larger one, or look for an "
        "atom or a MembraneCenter that lies far from the others.");
    }
    d.Dimensions[a] = 2 * static_cast<std::int64_t>(nodes) + 1;
    d.Origin[a] = d.Centre[a] - h * nodes;
  }
  RequireMemory(d, BytesPerNode);
  return d;
}

std::vector<float> DistanceToAtoms(const TransportDomain& domain, const std::vector<Ball>& atoms,
  double probeRadius, const ProgressCallback& progress)
{
  const FlowGrid flow(DensityGrid{ domain.Origin, domain.Dimensions, domain.Spacing });
  std::vector<float> to(static_cast<std::size_t>(flow.NumberOfNodes()), FlowGrid::Band);
  if (probeRadius > 0.0)
  {
    SolventExcludedDistance(flow, atoms, probeRadius, to, progress);
  }
  else
  {
    DistanceToBalls(flow, atoms, 1.0, 0.0, static_cast<double>(FlowGrid::Band), to, progress);
  }
  std::vector<float> distances;
  distances.reserve(static_cast<std::size_t>(domain.Size()));
  for (std::int64_t node = 0; node < domain.Size(); ++node)
  {
    const std::array<std::int64_t, 3> at = domain.Indices(node);
    distances.push_back(static_cast<float>(domain.Spacing) *
      to[static_cast<std::size_t>(flow.Index(at[0], at[1], at[2]))]);
  }
  return distances;
}

}
