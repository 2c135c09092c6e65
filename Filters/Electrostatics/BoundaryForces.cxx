#include "Electrostatics/BoundaryForces.h"

#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/SurfacePotential.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus
{
namespace
{

std::vector<Point3> CrossingPositions(const GridPotential& solution)
{
  const SolverBox& box = solution.GetBox();
  std::vector<Point3> places;
  places.reserve(solution.GetCrossings().size());
  for (const InterfaceCrossing& crossing : solution.GetCrossings())
  {
    Point3 place = box.Position(crossing.Node);
    const auto axis = static_cast<std::size_t>(crossing.Axis);
    place[axis] += crossing.Fraction * box.Spacing[axis];
    places.push_back(place);
  }
  return places;
}

/// kT / angstrom^3; 0 where no field could be fitted.
double Pull(const SurfaceValues& field, std::size_t i, const FitMedium& medium, double coulomb)
{
  const double inside = medium.SoluteDielectric;
  const double outside = medium.SolventDielectric;
  const Point3& t = field.TangentialGradient[i];
  const double normal = outside * field.NormalField[i];
  const double value = ((1.0 / inside - 1.0 / outside) * normal * normal +
                         (outside - inside) * (t[0] * t[0] + t[1] * t[1] + t[2] * t[2])) /
    (8.0 * Pi * coulomb);
  return std::isfinite(value) ? value : 0.0;
}

/// Subtracts (weight times shares) from the forces of the atoms that share a point.
void Subtract(const std::vector<SurfaceShare>& shares, double weight, std::vector<Point3>& forces)
{
  for (const SurfaceShare& share : shares)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      forces[share.Atom][a] -= weight * share.Part[a];
    }
  }
}

double IonPressure(const GridPotential& solution, std::size_t layer, double phi)
{
  const IonAtmosphere& ions = solution.GetIons();
  const double pressure = solution.GetParameters().Nonlinear ? ions.Pressure(layer, phi)
                                                             : ions.LinearPressure(layer, phi);
  return std::isfinite(pressure) ? pressure : 0.0;
}

/// Ions kept away from the surface: access rises from 0 to 1 over IonBorderWidth.
void AddDistantIons(const GridPotential& solution, std::size_t layer, const SurfaceMotion& motion,
  std::vector<Point3>& forces)
{
  const SolverBox& box = solution.GetBox();
  std::vector<IonBorderNode> border;
  IonAccess(
    box, solution.GetInside(), solution.GetCrossings(), solution.LayerRadius(layer), &border);
  const double weight = box.Spacing[0] * box.Spacing[1] * box.Spacing[2] / IonBorderWidth(box);
  std::vector<SurfaceShare> shares;
  for (const IonBorderNode& node : border)
  {
    motion.At(node.Foot, node.Normal, shares);
    // Access changes from 0 to 1 across the border, so its derivative spreads the border's
    // pressure.
    const double phi = solution.GetPotential()[static_cast<std::size_t>(node.Node)];
    Subtract(shares, weight * IonPressure(solution, layer, phi), forces);
  }
}

}

std::vector<double> PullAtCrossings(const GridPotential& solution, double kelvin)
{
  const SurfaceValues field = EvaluateAtCrossings(solution, kelvin);
  std::vector<double> pull(solution.GetCrossings().size());
  for (std::size_t i = 0; i < pull.size(); ++i)
  {
    pull[i] = units::ThermalKilocalorie(kelvin) *
      Pull(field, i, solution.GetMedium(), units::CoulombLength(kelvin));
  }
  return pull;
}

BoundaryForces ForcesOnBoundary(const GridPotential& solution, const SurfaceMotion& motion)
{
  const double kelvin = solution.GetParameters().Temperature;
  const SolverBox& box = solution.GetBox();
  const std::vector<Point3> places = CrossingPositions(solution);
  const SurfaceValues field = EvaluateAtCrossings(solution, kelvin);
  const double coulomb = units::CoulombLength(kelvin);
  const std::size_t atoms = solution.GetReport().AtomForces.size();
  BoundaryForces forces;
  forces.Dielectric.assign(atoms, { 0.0, 0.0, 0.0 });
  forces.Ionic.assign(atoms, { 0.0, 0.0, 0.0 });
  std::vector<std::size_t> touching;
  for (std::size_t layer = 0; layer < solution.GetIons().NumberOfLayers(); ++layer)
  {
    if (solution.LayerRadius(layer) > 0.0)
    {
      AddDistantIons(solution, layer, motion, forces.Ionic);
    }
    else
    {
      touching.push_back(layer);
    }
  }
  std::vector<SurfaceShare> shares;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto axis = static_cast<std::size_t>(solution.GetCrossings()[i].Axis);
    const Point3& normal = field.Normal[i];
    // Crossings with grid lines sample the surface: each represents the part of a face that it
    // projects to (thesis 5.26).
    const double area =
      std::abs(normal[axis]) * box.Spacing[(axis + 1) % 3] * box.Spacing[(axis + 2) % 3];
    motion.At(places[i], normal, shares);
    Subtract(shares, area * Pull(field, i, solution.GetMedium(), coulomb), forces.Dielectric);
    for (const std::size_t layer : touching)
    {
      Subtract(shares, area * IonPressure(solution, layer, field.Potential[i]), forces.Ionic);
    }
  }
  return forces;
}

namespace
{

constexpr double SmallestTerm = 1e-6; // as in MolecularDensity

}

SurfaceMotion::SurfaceMotion(const std::vector<ChargedAtom>& atoms, double decay)
  : Atoms(atoms)
  , Decay(decay)
{
  Point3 high = atoms.front().Position;
  this->Low = high;
  for (const ChargedAtom& atom : atoms)
  {
    this->Largest = std::max(this->Largest, atom.Radius);
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Low[a] = std::min(this->Low[a], atom.Position[a]);
      high[a] = std::max(high[a], atom.Position[a]);
    }
  }
  double volume = 1.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    volume *= std::max(high[a] - this->Low[a], 1e-3);
  }
  // A few atoms per cell, and no more cells than atoms for any arrangement.
  const double longest =
    std::max({ high[0] - this->Low[0], high[1] - this->Low[1], high[2] - this->Low[2] });
  const auto count = static_cast<double>(atoms.size());
  this->Cell = std::max({ this->Largest, std::cbrt(4.0 * volume / count), longest / count, 1e-3 });
  for (std::size_t a = 0; a < 3; ++a)
  {
    this->Cells[a] = 1 + static_cast<std::int64_t>((high[a] - this->Low[a]) / this->Cell);
  }
  std::vector<std::size_t> cell(atoms.size());
  this->First.assign(
    static_cast<std::size_t>(this->Cells[0] * this->Cells[1] * this->Cells[2]) + 1, 0);
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const auto c = this->FindCell(atoms[i].Position);
    cell[i] = static_cast<std::size_t>(c[0] + this->Cells[0] * (c[1] + this->Cells[1] * c[2]));
    ++this->First[cell[i] + 1];
  }
  for (std::size_t c = 1; c < this->First.size(); ++c)
  {
    this->First[c] += this->First[c - 1];
  }
  std::vector<std::size_t> next(this->First.begin(), this->First.end() - 1);
  this->Order.resize(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    this->Order[next[cell[i]]++] = i;
  }
}

std::array<std::int64_t, 3> SurfaceMotion::FindCell(const Point3& x) const
{
  std::array<std::int64_t, 3> cell;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double place = std::floor((x[a] - this->Low[a]) / this->Cell);
    cell[a] =
      static_cast<std::int64_t>(std::clamp(place, 0.0, static_cast<double>(this->Cells[a] - 1)));
  }
  return cell;
}

/// Visits the atoms of the cells at a distance of `ring` cells, in their order.
template <class Visit>
void SurfaceMotion::ForEachNear(
  const std::array<std::int64_t, 3>& middle, std::int64_t ring, const Visit& visit) const
{
  std::array<std::int64_t, 3> first, last;
  for (std::size_t a = 0; a < 3; ++a)
  {
    first[a] = std::max<std::int64_t>(middle[a] - ring, 0);
    last[a] = std::min(middle[a] + ring, this->Cells[a] - 1);
  }
  for (std::int64_t k = first[2]; k <= last[2]; ++k)
  {
    for (std::int64_t j = first[1]; j <= last[1]; ++j)
    {
      const bool rim = std::abs(k - middle[2]) == ring || std::abs(j - middle[1]) == ring;
      for (std::int64_t i = first[0]; i <= last[0]; ++i)
      {
        if (!rim && std::abs(i - middle[0]) != ring)
        {
          continue;
        }
        const auto c = static_cast<std::size_t>(i + this->Cells[0] * (j + this->Cells[1] * k));
        for (std::size_t o = this->First[c]; o < this->First[c + 1]; ++o)
        {
          visit(this->Order[o]);
        }
      }
    }
  }
}

void SurfaceMotion::GaussianShares(const Point3& x, std::vector<SurfaceShare>& shares) const
{
  const double most = 1.0 - std::log(SmallestTerm) / this->Decay; // of (distance / radius)^2
  const auto rings =
    static_cast<std::int64_t>(std::ceil(this->Largest * std::sqrt(most) / this->Cell));
  const auto middle = this->FindCell(x);
  Point3 gradient{ 0.0, 0.0, 0.0 };
  const auto visit = [&](std::size_t i)
  {
    const ChargedAtom& atom = this->Atoms[i];
    const Point3 y{ x[0] - atom.Position[0], x[1] - atom.Position[1], x[2] - atom.Position[2] };
    const double r2 = atom.Radius * atom.Radius;
    const double d2 = y[0] * y[0] + y[1] * y[1] + y[2] * y[2];
    if (!(d2 < most * r2))
    {
      return;
    }
    const double slope = 2.0 * this->Decay / r2 * std::exp(-this->Decay * (d2 / r2 - 1.0));
    shares.push_back({ i, { slope * y[0], slope * y[1], slope * y[2] } });
    for (std::size_t a = 0; a < 3; ++a)
    {
      gradient[a] += slope * y[a];
    }
  };
  for (std::int64_t ring = 0; ring <= rings; ++ring)
  {
    this->ForEachNear(middle, ring, visit);
  }
  const double length =
    std::sqrt(gradient[0] * gradient[0] + gradient[1] * gradient[1] + gradient[2] * gradient[2]);
  // Beyond all terms: the point goes to the nearest ball, as without Gaussians.
  if (!(length > 0.0))
  {
    shares.clear();
    return;
  }
  for (SurfaceShare& share : shares)
  {
    for (double& part : share.Part)
    {
      part /= length;
    }
  }
}

std::size_t SurfaceMotion::Owner(const Point3& x) const
{
  const auto middle = this->FindCell(x);
  // If x lies beyond the cells, those of ring n are even farther away than this.
  double beyond = 0.0;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double high = this->Low[a] + this->Cell * static_cast<double>(this->Cells[a]);
    beyond = std::max({ beyond, this->Low[a] - x[a], x[a] - high });
  }
  double least = std::numeric_limits<double>::infinity();
  std::size_t owner = 0;
  const std::int64_t rings = *std::max_element(this->Cells.begin(), this->Cells.end());
  for (std::int64_t ring = 0; ring < rings; ++ring)
  {
    const double nearest = std::max(beyond, static_cast<double>(ring - 1) * this->Cell);
    if (nearest - this->Largest > least)
    {
      break;
    }
    this->ForEachNear(middle, ring,
      [&](std::size_t i)
      {
        const ChargedAtom& atom = this->Atoms[i];
        const double distance =
          std::hypot(x[0] - atom.Position[0], x[1] - atom.Position[1], x[2] - atom.Position[2]) -
          atom.Radius;
        if (distance < least || (distance == least && i < owner))
        {
          least = distance;
          owner = i;
        }
      });
  }
  return owner;
}

void SurfaceMotion::At(
  const Point3& x, const Point3& normal, std::vector<SurfaceShare>& shares) const
{
  shares.clear();
  if (this->Decay > 0.0)
  {
    this->GaussianShares(x, shares);
  }
  if (shares.empty())
  {
    shares.push_back({ this->Owner(x), normal });
  }
}

}
