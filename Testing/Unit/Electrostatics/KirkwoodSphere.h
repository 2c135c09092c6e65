/**
 * @file KirkwoodSphere.h
 * @brief Charges in a dielectric sphere in salt water, by series.
 *
 * J. G. Kirkwood, J. Chem. Phys. 2 (1934) 351: for each degree l, r^l and r^-(l+1) in the sphere and
 * in the layer without ions, k_l(kappa r) beyond, joined by continuity of phi and eps phi'.
 */
#ifndef isthmus_KirkwoodSphere_h
#define isthmus_KirkwoodSphere_h

#include "ElectrostaticUnits.h"
#include "PoissonBoltzmannParameters.h"

#include <cmath>
#include <utility>
#include <vector>

namespace isthmus::testing
{

class KirkwoodSphere
{
public:
  Vector3 Centre{ 0.0, 0.0, 0.0 };
  double Radius = 1.0, Solute = 2.0, Solvent = 80.0, Kappa = 0.0, Layer = 0.0, Kelvin = 298.15;
  std::vector<ChargedAtom> Charges;

  /// Total potential outside of the sphere, kT/e.
  double Outside(const Vector3& x) const
  {
    double sum = 0.0;
    for (const ChargedAtom& q : this->Charges)
    {
      sum += q.Charge * this->Sum(q.Position, x, true);
    }
    return units::CoulombLength(this->Kelvin) * sum;
  }
  /// Reaction potential inside.
  double Reaction(const Vector3& x) const
  {
    double sum = 0.0;
    for (const ChargedAtom& q : this->Charges)
    {
      sum += q.Charge * this->Sum(q.Position, x, false);
    }
    return units::CoulombLength(this->Kelvin) * sum;
  }
  /// The charges' own potential in a medium like the sphere's.
  double Coulomb(const Vector3& x) const
  {
    double sum = 0.0;
    for (const ChargedAtom& q : this->Charges)
    {
      sum += q.Charge / this->Solute /
        std::hypot(x[0] - q.Position[0], x[1] - q.Position[1], x[2] - q.Position[2]);
    }
    return units::CoulombLength(this->Kelvin) * sum;
  }
  /// 1/2 sum q u, kT.
  double Energy() const
  {
    double sum = 0.0;
    for (const ChargedAtom& q : this->Charges)
    {
      sum += 0.5 * q.Charge * this->Reaction(q.Position);
    }
    return sum;
  }
  double Distance(const Vector3& x) const
  {
    return std::hypot(x[0] - this->Centre[0], x[1] - this->Centre[1], x[2] - this->Centre[2]);
  }

private:
  static constexpr int Degrees = 120;

  /// k_l and k_l' of x, times e^x x.
  static std::pair<double, double> Bessel(int l, double x)
  {
    double before = 1.0;            // k_0
    double now = 1.0 + 1.0 / x;     // k_1
    if (l == 0)
    {
      return { before, -now };
    }
    for (int i = 1; i < l; ++i)
    {
      const double next = before + (2.0 * i + 1.0) / x * now;
      before = now;
      now = next;
    }
    return { now, -before - (l + 1.0) / x * now };
  }

  /// One charge's potential at x over C: the outside's or the reaction field inside.
  double Sum(const Vector3& charge, const Vector3& x, bool outside) const
  {
    const double rq = this->Distance(charge);
    const double r = this->Distance(x);
    double cosine = 1.0;
    if (rq > 0.0 && r > 0.0)
    {
      cosine = 0.0;
      for (std::size_t a = 0; a < 3; ++a)
      {
        cosine += (charge[a] - this->Centre[a]) * (x[a] - this->Centre[a]) / (rq * r);
      }
    }
    double legendre = 1.0, previous = 0.0, sum = 0.0;
    for (int l = 0; l < Degrees; ++l)
    {
      sum += this->Term(l, rq, r, outside) * legendre;
      const double next = ((2.0 * l + 1.0) * cosine * legendre - l * previous) / (l + 1.0);
      previous = legendre;
      legendre = next;
    }
    return sum;
  }

  double Term(int l, double rq, double r, bool outside) const
  {
    const double R = this->Radius;
    const double a = R + this->Layer;
    // In the layer D (r/R)^l + E (r/R)^-(l+1); from beyond, phi' / phi at a is s / a.
    double s = -(l + 1.0);
    const bool salt = this->Kappa > 0.0;
    if (salt)
    {
      const auto k = Bessel(l, this->Kappa * a);
      s = this->Kappa * a * k.second / k.first;
    }
    const double up = std::pow(a / R, l);
    const double down = std::pow(a / R, -(l + 1.0));
    // D up (l - s) = E down (s + l + 1).
    const double d = down * (s + l + 1.0) / (up * (l - s)); // D / E
    // Charge: g (r/R)^-(l+1), g = rq^l / (eps_m R^(l+1)); reaction B (r/R)^l.
    const double g = (l == 0 ? 1.0 : std::pow(rq / R, l)) / (this->Solute * R);
    // g + B = E (1 + d);  eps_m (-(l+1) g + l B) = eps_s E (l d - (l + 1)).
    const double flux = this->Solvent * (l * d - (l + 1.0)) / (1.0 + d);
    const double b = g * (this->Solute * (l + 1.0) + flux) / (this->Solute * l - flux);
    if (!outside)
    {
      return b * (l == 0 ? 1.0 : std::pow(r / R, l));
    }
    const double e = (g + b) / (1.0 + d);
    if (r <= a || !salt)
    {
      return e * (d * std::pow(r / R, l) + std::pow(r / R, -(l + 1.0)));
    }
    const auto here = Bessel(l, this->Kappa * r);
    const auto there = Bessel(l, this->Kappa * a);
    return e * (d * up + down) * here.first / there.first * std::exp(-this->Kappa * (r - a)) * a / r;
  }
};

}

#endif
