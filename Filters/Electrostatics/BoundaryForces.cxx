#include "Electrostatics/BoundaryForces.h"

#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/SurfacePotential.h"

#include <cmath>

namespace isthmus
{
namespace
{

std::vector<Point3> PlacesOfCrossings(const PotentialOnBox& solution)
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

/// Takes (weight times shares) from the forces of the atoms that carry a point.
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

double IonPressure(const PotentialOnBox& solution, std::size_t layer, double phi)
{
  const IonAtmosphere& ions = solution.GetIons();
  const double pressure = solution.GetParameters().Nonlinear ? ions.Pressure(layer, phi)
                                                             : ions.LinearPressure(layer, phi);
  return std::isfinite(pressure) ? pressure : 0.0;
}

/// The ions that keep off the surface: access goes from 0 to 1 over IonBorderWidth, and with it.
void AddDistantIons(const PotentialOnBox& solution, std::size_t layer, const SurfaceMotion& motion,
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
    const double phi = solution.GetPotential()[static_cast<std::size_t>(node.Node)];
    Subtract(shares, weight * IonPressure(solution, layer, phi), forces);
  }
}

}

std::vector<double> PullAtCrossings(const PotentialOnBox& solution, double kelvin)
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

BoundaryForces ForcesOnBoundary(const PotentialOnBox& solution, const SurfaceMotion& motion)
{
  const double kelvin = solution.GetParameters().Temperature;
  const SolverBox& box = solution.GetBox();
  const std::vector<Point3> places = PlacesOfCrossings(solution);
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

}
