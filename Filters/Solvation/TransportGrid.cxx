#include "Solvation/TransportGrid.h"

#include "Core/MemoryBudget.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Electrostatics/InterfaceMatrixRows.h"
#include "MolecularSurfaces/BallDistance.h"
#include "MolecularSurfaces/FlowField.h"
#include "MolecularSurfaces/SolventExcludedSurface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

constexpr double BytesPerNode = 220.0; // grid, potential, two species, network, output

}

std::array<double, 2> TransportDomain::AxialAndRadial(const Point3& place) const
{
  const Point3 from{ place[0] - this->Center[0], place[1] - this->Center[1],
    place[2] - this->Center[2] };
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

Point3 TransportDomain::Turned(const Point3& vector) const
{
  Point3 world{ 0.0, 0.0, 0.0 };
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      world[c] += vector[a] * this->Axes[a][c];
    }
  }
  return world;
}

Point3 TransportDomain::InAxes(const Point3& place) const
{
  Point3 local{ 0.0, 0.0, 0.0 };
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t c = 0; c < 3; ++c)
    {
      local[a] += (place[c] - this->Origin[c]) * this->Axes[a][c];
    }
  }
  return local;
}

namespace
{

/// The coordinate axis next to the normal.
std::size_t NextAxis(const Point3& normal)
{
  std::size_t next = 2;
  for (const std::size_t a : { std::size_t(1), std::size_t(0) })
  {
    next = std::abs(normal[a]) > std::abs(normal[next]) ? a : next;
  }
  return next;
}

/// The coordinate axes in the smallest turn that takes e, axis `next` or its opposite, to the
/// normal n: a vector x goes to x - (x (e + n)) (e + n) / (1 + e n) + 2 (x e) n.
// The smallest turn leaves a membrane along a coordinate axis, and its grid, as they are.
std::array<Point3, 3> AxesAlong(const Point3& normal, std::size_t next)
{
  const double sign = normal[next] < 0.0 ? -1.0 : 1.0;
  const Point3 along{ sign * normal[0], sign * normal[1], sign * normal[2] };
  std::array<Point3, 3> axes{ along, along, along };
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t c = 0; a != next && c < 3; ++c)
    {
      const double both = along[c] + (c == next ? 1.0 : 0.0);
      axes[a][c] = (a == c ? 1.0 : 0.0) - along[a] * both / (1.0 + along[next]);
    }
  }
  return axes;
}

}

TransportDomain DomainAround(
  const std::vector<Ball>& atoms, const IonTransportParameters& parameters)
{
  Check(parameters);
  const MembraneSlab& membrane = parameters;
  TransportDomain d;
  d.Spacing = parameters.Spacing;
  d.Center = membrane.MembraneCenter;
  const Point3& n = membrane.MembraneNormal;
  const double length = std::hypot(n[0], n[1], n[2]);
  d.Normal = { n[0] / length, n[1] / length, n[2] / length };
  double far = 0.5 * membrane.MembraneThickness;
  double wide = membrane.LumenRadius;
  for (const Ball& ball : atoms)
  {
    const auto [along, off] = d.AxialAndRadial(ball.Center);
    far = std::max(far, std::abs(along) + ball.Radius);
    wide = std::max(wide, off + ball.Radius);
  }
  d.Radius = wide + parameters.Padding;
  const double h = d.Spacing;
  // Whole spacings: the baths begin at planes of nodes.
  d.HalfLength = h * std::ceil((far + parameters.Padding) / h - 1e-6);
  const std::size_t next = NextAxis(d.Normal);
  d.Axes = AxesAlong(d.Normal, next);
  Point3 before{};
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double nodes = std::ceil((a == next ? d.HalfLength : d.Radius) / h - 1e-6) + 1.0;
    if (!(nodes < 1e9))
    {
      throw std::invalid_argument("A Spacing of " + FormatNumber(h) + " makes " +
        FormatNumber(2.0 * nodes) +
        " nodes along an axis: choose a larger one, or look for an "
        "atom or a MembraneCenter that lies far from the others.");
    }
    d.Dimensions[a] = 2 * static_cast<std::int64_t>(nodes) + 1;
    before[a] = h * nodes;
  }
  const Point3 half = d.Turned(before);
  d.Origin = { d.Center[0] - half[0], d.Center[1] - half[1], d.Center[2] - half[2] };
  MemoryBudget().RequireGrid(
    d.Dimensions, BytesPerNode, "choose a larger Spacing or a smaller Padding");
  return d;
}

std::vector<float> DistanceToAtoms(const TransportDomain& domain, const std::vector<Ball>& atoms,
  double probeRadius, const ProgressCallback& progress)
{
  const FlowGrid flow(DensityGrid{ {}, domain.Dimensions, domain.Spacing });
  std::vector<Ball> balls = atoms;
  for (Ball& ball : balls)
  {
    ball.Center = domain.InAxes(ball.Center);
  }
  std::vector<float> to(static_cast<std::size_t>(flow.NumberOfNodes()), FlowGrid::Band);
  if (probeRadius > 0.0)
  {
    SolventExcludedDistance(flow, balls, probeRadius, to, progress);
  }
  else
  {
    DistanceToBalls(flow, balls, 1.0, 0.0, static_cast<double>(FlowGrid::Band), to, progress);
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

namespace
{

/// Data shared by the loops over nodes and faces.
class Builder
{
public:
  Builder(TransportGrid& grid, const IonTransportParameters& parameters, PermittivityMean kind)
    : Grid(grid)
    , Domain(grid.Domain)
    , Parameters(parameters)
    , Kind(kind)
    , Steps(grid.Domain.Steps())
    , Side(static_cast<std::size_t>(grid.Domain.Size()))
  {
  }

  void Distances(const std::vector<float>& solute);
  void Faces(const ProgressCallback& progress);
  void MergeCutCells();
  void Charges(const std::vector<ChargedAtom>& charges);

private:
  bool IsWet(std::int64_t node) const
  {
    return this->Grid.Distance[static_cast<std::size_t>(node)] > 0.0F;
  }
  std::int64_t DeepestStep(std::int64_t node, std::int64_t other, std::size_t skip) const;
  void FillNode(std::int64_t node, double solute);
  void FillEdge(std::int64_t node, const std::array<std::int64_t, 3>& at, std::size_t axis);
  double FacePart(const std::vector<float>& values, std::int64_t node, std::size_t axis) const;
  std::array<double, 2> SlopesAcross(
    const std::vector<float>& values, std::int64_t node, std::size_t axis) const;
  double EdgePermittivity(std::int64_t node, std::size_t axis) const;

  TransportGrid& Grid;
  const TransportDomain& Domain;
  const IonTransportParameters& Parameters;
  const PermittivityMean Kind;
  const std::array<std::int64_t, 3> Steps;
  std::vector<float> Side; ///< distance to the side of the cylinder, positive within
};

void Builder::FillNode(std::int64_t node, double solute)
{
  const auto n = static_cast<std::size_t>(node);
  const double h = this->Domain.Spacing;
  const auto [along, off] = this->Domain.AxialAndRadial(this->Domain.Place(node));
  const MembraneSlab& m = this->Parameters;
  // Negative in the slab, except in its hole.
  const double membrane =
    std::max(std::abs(along) - 0.5 * m.MembraneThickness, m.LumenRadius - off);
  const double distance = std::min(solute, membrane - MembraneExcess * h);
  this->Grid.Distance[n] = static_cast<float>(distance);
  this->Grid.Along[n] = static_cast<float>(along);
  this->Side[n] = static_cast<float>(this->Domain.Radius - off);
  const auto cell = [h](double to) { return std::clamp(0.5 + to / h, 0.0, 1.0); };
  this->Grid.Water[n] = static_cast<float>(cell(distance) * cell(this->Domain.Radius - off));
  const double bath = this->Domain.HalfLength - 1e-6 * h;
  const Bath which = along < -bath ? Bath::Below : along > bath ? Bath::Above : Bath::None;
  this->Grid.Baths[n] = static_cast<unsigned char>(which);
}

void Builder::Distances(const std::vector<float>& solute)
{
  ParallelFor(0, this->Domain.Size(), 1 << 14,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        this->FillNode(node,
          solute.empty() ? std::numeric_limits<double>::infinity()
                         : static_cast<double>(solute[static_cast<std::size_t>(node)]));
      }
    });
}

double Builder::FacePart(
  const std::vector<float>& values, std::int64_t node, std::size_t axis) const
{
  const auto value = [&values](std::int64_t at)
  { return static_cast<double>(values[static_cast<std::size_t>(at)]); };
  const std::int64_t next = node + this->Steps[axis];
  const double middle = 0.5 * (value(node) + value(next));
  if (std::abs(middle) > this->Domain.Spacing) // a distance changes by less than that on a face
  {
    return middle > 0.0 ? 1.0 : 0.0;
  }
  const auto [first, second] = this->SlopesAcross(values, node, axis);
  return PositiveFraction(middle, first, second);
}

/// Changes of the values from side to side of the face between a node and the next.
std::array<double, 2> Builder::SlopesAcross(
  const std::vector<float>& values, std::int64_t node, std::size_t axis) const
{
  const auto value = [&values](std::int64_t at)
  { return static_cast<double>(values[static_cast<std::size_t>(at)]); };
  const std::int64_t next = node + this->Steps[axis];
  std::array<double, 2> slopes{};
  for (std::size_t b = 0; b < 2; ++b)
  {
    const std::int64_t step = this->Steps[(axis + 1 + b) % 3];
    slopes[b] =
      0.25 * (value(node + step) - value(node - step) + value(next + step) - value(next - step));
  }
  return slopes;
}

/// The permittivity of the edge from a node to the next, or the mean of lines along it, spread over
/// the face between.
double Builder::EdgePermittivity(std::int64_t node, std::size_t axis) const
{
  constexpr int lines = 4; // along each side
  const std::vector<float>& distances = this->Grid.Distance;
  const auto here = static_cast<double>(distances[static_cast<std::size_t>(node)]);
  const auto there =
    static_cast<double>(distances[static_cast<std::size_t>(node + this->Steps[axis])]);
  const double solute = this->Parameters.SoluteDielectric;
  const double solvent = this->Parameters.SolventDielectric;
  const double low = std::min(here, there);
  const double high = std::max(here, there);
  if (low > this->Domain.Spacing || high < -this->Domain.Spacing)
  {
    return here > 0.0 ? solvent : solute;
  }
  const auto ofLine = [&](double off) // distances there differ by `off` from those on the edge
  {
    const double inside = high + off < 0.0 ? 1.0
      : low + off >= 0.0                   ? 0.0
                                           : -(low + off) / (high - low);
    return SeriesPermittivity(solute, solvent, inside);
  };
  if (this->Kind == PermittivityMean::AlongEdge)
  {
    return ofLine(0.0);
  }
  const auto [first, second] = this->SlopesAcross(distances, node, axis);
  double sum = 0.0;
  for (int line = 0; line < lines * lines; ++line)
  {
    const auto place = [](int i) { return (i + 0.5) / lines - 0.5; };
    const double off = first * place(line % lines) + second * place(line / lines);
    sum += ofLine(off);
  }
  return sum / (lines * lines);
}

void Builder::FillEdge(std::int64_t node, const std::array<std::int64_t, 3>& at, std::size_t axis)
{
  const auto& n = this->Domain.Dimensions;
  const auto p = static_cast<std::size_t>(node);
  bool inner = true; // border nodes lie beyond the domain
  for (std::size_t a = 0; a < 3; ++a)
  {
    inner = inner && at[a] > 0 && at[a] + (a == axis ? 2 : 1) < n[a];
  }
  const double part = inner ? this->FacePart(this->Side, node, axis) : 0.0;
  if (part == 0.0)
  {
    return;
  }
  this->Grid.Permittivity[axis][p] = static_cast<float>(part * this->EdgePermittivity(node, axis));
  this->Grid.Aperture[axis][p] =
    static_cast<float>(part * this->FacePart(this->Grid.Distance, node, axis));
}

void Builder::Faces(const ProgressCallback& progress)
{
  ParallelFor(
    0, this->Domain.Dimensions[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first * this->Steps[2]; node < last * this->Steps[2]; ++node)
      {
        const std::array<std::int64_t, 3> at = this->Domain.Indices(node);
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          this->FillEdge(node, at, axis);
        }
      }
    },
    progress);
}

/// The step to a neighbour across `skip` (3: any) that lies deepest in the water, with that of
/// `other`; 0 where none has both there.
std::int64_t Builder::DeepestStep(std::int64_t node, std::int64_t other, std::size_t skip) const
{
  std::int64_t deepest = 0;
  float depth = 0.0F;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (const std::int64_t step : { this->Steps[a], -this->Steps[a] })
    {
      const std::int64_t p = node + step, q = other + step;
      const std::int64_t last = this->Domain.Size();
      if (a != skip && std::min(p, q) >= 0 && std::max(p, q) < last && this->IsWet(p) &&
        this->IsWet(q))
      {
        const float least = std::min(this->Grid.Distance[static_cast<std::size_t>(p)],
          this->Grid.Distance[static_cast<std::size_t>(q)]);
        deepest = least > depth ? step : deepest;
        depth = std::max(least, depth);
      }
    }
  }
  return deepest;
}

/**
 * A node within atoms or membrane has their potential, that of their charges, not the water's in
 * the rest of its cube. So these nodes have no ions; the water in their cubes and faces is counted
 * with their neighbours in the water.
 */
void Builder::MergeCutCells()
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    std::vector<float>& aperture = this->Grid.Aperture[a];
    for (std::int64_t node = 0; node + this->Steps[a] < this->Domain.Size(); ++node)
    {
      const std::int64_t next = node + this->Steps[a];
      float& part = aperture[static_cast<std::size_t>(node)];
      if (part > 0.0F && !(this->IsWet(node) && this->IsWet(next)))
      {
        const std::int64_t step = this->DeepestStep(node, next, a);
        if (step != 0 && this->Grid.Permittivity[a][static_cast<std::size_t>(node + step)] > 0.0F)
        {
          aperture[static_cast<std::size_t>(node + step)] += part;
        }
        part = 0.0F;
      }
    }
  }
  for (std::int64_t node = 0; node < this->Domain.Size(); ++node)
  {
    float& part = this->Grid.Water[static_cast<std::size_t>(node)];
    if (part > 0.0F && !this->IsWet(node))
    {
      const std::int64_t step = this->DeepestStep(node, node, 3);
      if (step != 0)
      {
        this->Grid.Water[static_cast<std::size_t>(node + step)] += part;
      }
      part = 0.0F;
    }
  }
}

/// Shared among the eight nodes around, in proportion to the distances: the total is kept.
void Builder::Charges(const std::vector<ChargedAtom>& charges)
{
  for (const ChargedAtom& charge : charges)
  {
    std::int64_t node = 0;
    double t[3];
    const Point3 place = this->Domain.InAxes(charge.Position);
    for (std::size_t a = 0; a < 3; ++a)
    {
      const double at = place[a] / this->Domain.Spacing;
      const auto low = std::clamp<std::int64_t>(
        static_cast<std::int64_t>(std::floor(at)), 0, this->Domain.Dimensions[a] - 2);
      node += low * this->Steps[a];
      t[a] = std::clamp(at - static_cast<double>(low), 0.0, 1.0);
    }
    for (int corner = 0; corner < 8; ++corner)
    {
      double part = charge.Charge;
      std::int64_t to = node;
      for (std::size_t a = 0; a < 3; ++a)
      {
        const bool high = (corner >> a & 1) != 0;
        part *= high ? t[a] : 1.0 - t[a];
        to += high ? this->Steps[a] : 0;
      }
      this->Grid.Charge[static_cast<std::size_t>(to)] += part;
    }
  }
}

}

double PositiveFraction(double distance, double g1, double g2)
{
  const double a = std::max(std::abs(g1), std::abs(g2));
  const double b = std::min(std::abs(g1), std::abs(g2));
  if (std::abs(distance) >= 0.5 * (a + b))
  {
    return distance > 0.0 ? 1.0 : 0.0;
  }
  if (b < 1e-6 * a)
  {
    return std::clamp(0.5 + distance / a, 0.0, 1.0);
  }
  const auto square = [](double x) { return x > 0.0 ? x * x : 0.0; };
  return (square(distance + 0.5 * (a + b)) - square(distance + 0.5 * (a - b)) -
           square(distance - 0.5 * (a - b))) /
    (2.0 * a * b);
}

TransportGrid MakeTransportGrid(const TransportDomain& domain, const std::vector<float>& solute,
  const std::vector<ChargedAtom>& charges, const IonTransportParameters& parameters,
  PermittivityMean permittivity, const ProgressCallback& progress)
{
  TransportGrid grid;
  grid.Domain = domain;
  const auto size = static_cast<std::size_t>(domain.Size());
  for (std::vector<float>* all :
    { &grid.Distance, &grid.Along, &grid.Water, &grid.Permittivity[0], &grid.Permittivity[1],
      &grid.Permittivity[2], &grid.Aperture[0], &grid.Aperture[1], &grid.Aperture[2] })
  {
    all->assign(size, 0.0F);
  }
  grid.Baths.assign(size, 0);
  grid.Charge.assign(size, 0.0);
  Builder builder(grid, parameters, permittivity);
  builder.Distances(solute);
  builder.Faces(progress);
  builder.MergeCutCells();
  builder.Charges(charges);
  return grid;
}

}
