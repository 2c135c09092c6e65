// A tube of charged atoms in a thin membrane: the channel of several tests.
#ifndef ChannelTube_h
#define ChannelTube_h

#include "Atoms/Ball.h"
#include "Electrostatics/ElectrostaticUnits.h"
#include "Solvation/IonTransportParameters.h"

#include <cmath>
#include <vector>

namespace isthmus::testing
{

/// Rings of atoms around an axis through `center` along `normal`, with charges on the atoms: the
/// same from both ends.
struct Tube
{
  std::vector<Ball> Balls;
  std::vector<ChargedAtom> Charges;
};

/// Unit vectors along `normal` and across it.
struct AxisFrame
{
  Point3 Along, First, Second;
};

inline AxisFrame FrameAlong(const Point3& normal)
{
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const Point3 n{ normal[0] / length, normal[1] / length, normal[2] / length };
  const Point3 other = std::abs(n[2]) < 0.9 ? Point3{ 0.0, 0.0, 1.0 } : Point3{ 1.0, 0.0, 0.0 };
  Point3 u{ n[1] * other[2] - n[2] * other[1], n[2] * other[0] - n[0] * other[2],
    n[0] * other[1] - n[1] * other[0] };
  const double size = std::hypot(u[0], u[1], u[2]);
  for (double& x : u)
  {
    x /= size;
  }
  const Point3 v{ n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0] };
  return { n, u, v };
}

inline Tube MakeTube(const MembraneSlab& m, double radius, double charge)
{
  constexpr int rings = 4, around = 10;
  constexpr double ball = 1.9;
  const auto [n, u, v] = FrameAlong(m.MembraneNormal);
  Tube tube;
  for (int ring = 0; ring < rings; ++ring)
  {
    const double along = 2.0 * (ring - 0.5 * (rings - 1));
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * i / around;
      Point3 at = m.MembraneCenter;
      for (std::size_t a = 0; a < 3; ++a)
      {
        at[a] += along * n[a] + (radius + ball) * (std::cos(angle) * u[a] + std::sin(angle) * v[a]);
      }
      tube.Balls.push_back({ at, ball });
      tube.Charges.push_back({ at, charge, ball });
    }
  }
  return tube;
}

inline IonTransportParameters TubeParameters(double radius)
{
  IonTransportParameters p;
  p.Species = { { "K", 1.0, 0.1, 0.1, 1.96, 1.0 }, { "Cl", -1.0, 0.1, 0.1, 2.03, 1.0 } };
  p.MembraneThickness = 6.0;
  p.LumenRadius = radius + 1.9;
  p.Spacing = 1.0;
  p.Padding = 4.0;
  return p;
}

}

#endif
