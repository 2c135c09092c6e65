/**
 * @file KirkwoodSphere.h
 * @brief Charges in a dielectric sphere in salt water, by series.
 *
 * J. G. Kirkwood, J. Chem. Phys. 2 (1934) 351: for each degree l, r^l and r^-(l+1) in the sphere
 * and in the layer without ions, k_l(kappa r) beyond, joined by continuity of phi and eps phi'.
 */
#ifndef isthmus_KirkwoodSphere_h
#define isthmus_KirkwoodSphere_h

#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/PoissonBoltzmannParameters.h"

#include <cmath>
#include <utility>
#include <vector>

namespace isthmus::testing
{

class KirkwoodSphere
{
public:
  Point3 Center{ 0.0, 0.0, 0.0 };
  double Radius = 1.0, Solute = 2.0, Solvent = 80.0, Kappa = 0.0, Layer = 0.0, Kelvin = 298.15;
  std::vector<ChargedAtom> Charges;

  /// Total potential outside of the sphere, kT/e.
  double Outside(const Point3& x) const
  {
    double sum = 0.0;
    for (const ChargedAtom& q : this->Charges)
    {
      sum += q.Charge * this->Sum(q.Position, x, true);
    }
    return units::CoulombLength(this->Kelvin) * sum;
  }
  /// Reaction potential inside.
  double Reaction(const Point3& x) const
  {
    double sum = 0.0;
    for (const ChargedAtom& q : this->Charges)
    {
      sum += q.Charge * this->Sum(q.Position, x, false);
    }
    return units::CoulombLength(this->Kelvin) * sum;
  }
  /// The charges' own potential in a medium like the sphere's.
  double Coulomb(const Point3& x) const
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
  double Distance(const Point3& x) const
  {
    return std::hypot(x[0] - this->Center[0], x[1] - this->Center[1], x[2] - this->Center[2]);
  }

private:
  static constexpr int Degrees = 160;

  /// Joins the pieces at R and R + Layer for one degree, for a charge term g = 1 at the surface:
  /// reaction b, layer e (d (r/R)^l + (r/R)^-(l+1)), and beyond `outer` times k_l(r) / k_l(a).
  struct Joint
  {
    double b, d, e, outer;
  };

  /// Recursion of k_l e^x x upwards: k_(l+1) = k_(l-1) + (2l + 1) / x k_l.
  struct Bessel
  {
    double x, now = 1.0, next;
    int l = 0;
    explicit Bessel(double at)
      : x(at)
      , next(1.0 + 1.0 / at)
    {
    }
    double Slope() const { return this->l / this->x * this->now - this->next; }
    void Up()
    {
      const double after = this->now + (2.0 * this->l + 3.0) / this->x * this->next;
      this->now = this->next;
      this->next = after;
      ++this->l;
    }
  };

  Joint Join(int l, const Bessel* k) const
  {
    const double a = (this->Radius + this->Layer) / this->Radius;
    // From beyond, phi' / phi at a is s / a.
    const double s = k ? k->x * k->Slope() / k->now : -(l + 1.0);
    const double up = std::pow(a, l);
    const double down = std::pow(a, -(l + 1.0));
    Joint j;
    // d up (l - s) = down (s + l + 1).
    j.d = down * (s + l + 1.0) / (up * (l - s));
    // 1 + b = e (1 + d);  eps_m (-(l+1) + l b) = eps_s e (l d - (l + 1)).
    const double flux = this->Solvent * (l * j.d - (l + 1.0)) / (1.0 + j.d);
    j.b = (this->Solute * (l + 1.0) + flux) / (this->Solute * l - flux);
    j.e = (1.0 + j.b) / (1.0 + j.d);
    j.outer = j.e * (j.d * up + down) / (k ? k->now : 1.0);
    return j;
  }

  /// One charge's potential at x over C: the total outside, the reaction field inside.
  double Sum(const Point3& charge, const Point3& x, bool outside) const
  {
    const double rq = this->Distance(charge);
    const double r = this->Distance(x);
    double cosine = 1.0;
    if (rq > 0.0 && r > 0.0)
    {
      cosine = 0.0;
      for (std::size_t a = 0; a < 3; ++a)
      {
        cosine += (charge[a] - this->Center[a]) * (x[a] - this->Center[a]) / (rq * r);
      }
    }
    const double R = this->Radius;
    const double a = R + this->Layer;
    const bool salt = this->Kappa > 0.0;
    Bessel there(salt ? this->Kappa * a : 1.0), here(salt ? this->Kappa * r : 1.0);
    const double decay = salt ? std::exp(-this->Kappa * (r - a)) * a / r : 1.0;
    double legendre = 1.0, previous = 0.0, sum = 0.0, g = 1.0 / (this->Solute * R);
    double rl = 1.0; // (r / R)^l
    for (int l = 0; l < Degrees && g > 1e-14; ++l)
    {
      const Joint j = this->Join(l, salt ? &there : nullptr);
      double term = j.b * rl;
      if (outside)
      {
        term = salt && r > a ? j.outer * here.now * decay : j.e * (j.d * rl + R / (r * rl));
      }
      sum += g * term * legendre;
      const double next = ((2.0 * l + 1.0) * cosine * legendre - l * previous) / (l + 1.0);
      previous = legendre;
      legendre = next;
      g *= rq / R;
      rl *= r / R;
      there.Up();
      here.Up();
      // Only ratios of the two matter, and both exceed the range of a double.
      if (there.now > 1e200)
      {
        for (double* k : { &there.now, &there.next, &here.now, &here.next })
        {
          *k *= 1e-200;
        }
      }
    }
    return sum;
  }
};

}

#endif
