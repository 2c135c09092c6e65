/**
 * @file TwoSpheres.h
 * @brief Two dielectric spheres with charges on their axis in a solvent, by multipoles.
 *
 * Sphere j has its center on the z axis. Inside, phi = G + sum a_n (r/R)^n P_n; outside, the sum
 * over both spheres of b_n (R/r)^(n+1) P_n about each center. The multipoles of one sphere about
 * the other's center follow from the translation of solid harmonics along the axis,
 *
 *     P_n(cos t) / r^(n+1)  about a center at distance D  =  sum_m (+-) binom(n + m, n) r^m P_m /
 * D^(n+m+1)
 *
 * (J. D. Jackson, Classical Electrodynamics, chapter 3; bispherical coordinates give the same
 * numbers). Continuity of phi and eps phi' on each sphere makes a linear system for the b_n.
 */
#ifndef isthmus_TwoSpheres_h
#define isthmus_TwoSpheres_h

#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/PoissonBoltzmannParameters.h"

#include <Eigen/Dense>

#include <cmath>
#include <vector>

namespace isthmus::testing
{

class TwoSpheres
{
public:
  static constexpr int Degrees = 60;

  struct Sphere
  {
    double Z, Radius;      ///< center on the axis
    double Charge, Offset; ///< a charge on the axis, so far above the center
  };

  TwoSpheres(const Sphere& low, const Sphere& high, double solute, double solvent)
    : Spheres{ low, high }
    , Solute(solute)
    , Solvent(solvent)
  {
    constexpr int n = Degrees;
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(2 * n, 2 * n);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(2 * n);
    const double distance = high.Z - low.Z;
    for (int s = 0; s < 2; ++s)
    {
      const Sphere& here = this->Spheres[s];
      const Sphere& there = this->Spheres[1 - s];
      double g = here.Charge / (solute * here.Radius); // of G: (offset / R)^l
      for (int l = 0; l < n; ++l, g *= here.Offset / here.Radius)
      {
        // phi:  g + a = b + sum T b';   eps phi' R:  eps_m (-(l+1) g + l a) = eps_s (-(l+1) b + l
        // sum T b'). Without a:  (eps_m l + eps_s (l+1)) b + (eps_m - eps_s) l sum T b' = eps_m
        // (2l+1) g.
        const int row = s * n + l;
        matrix(row, row) = solute * l + solvent * (l + 1.0);
        right(row) = solute * (2.0 * l + 1.0) * g;
        for (int k = 0; k < n; ++k)
        {
          matrix(row, (1 - s) * n + k) =
            (solute - solvent) * l * this->Translation(s, k, l, here, there, distance);
        }
      }
    }
    const Eigen::VectorXd solution = matrix.partialPivLu().solve(right);
    this->B.assign(solution.data(), solution.data() + 2 * n);
  }

  /// Total potential outside both spheres, kT/e; x about the origin of the axis.
  double Outside(const Point3& x) const
  {
    return units::CoulombLength(298.15) * (this->Multipoles(0, x) + this->Multipoles(1, x));
  }

  /// At the charge of sphere s, the potential less the charge's own, kT/e.
  double ReactionAtCharge(int s) const
  {
    const Sphere& here = this->Spheres[s];
    const double distance = this->Spheres[1].Z - this->Spheres[0].Z;
    double sum = 0.0;
    double g = here.Charge / (this->Solute * here.Radius);
    double power = 1.0; // (offset / R)^l P_l(1)
    for (int l = 0; l < Degrees; ++l)
    {
      double a = this->B[static_cast<std::size_t>(s * Degrees + l)] - g;
      for (int k = 0; k < Degrees; ++k)
      {
        a += this->Translation(s, k, l, here, this->Spheres[1 - s], distance) *
          this->B[static_cast<std::size_t>((1 - s) * Degrees + k)];
      }
      sum += a * power;
      g *= here.Offset / here.Radius;
      power *= here.Offset / here.Radius;
    }
    return units::CoulombLength(298.15) * sum;
  }

  /// From a medium with the spheres' dielectric constant everywhere into the solvent, kT: 1/2 sum
  /// q u, less the energy of the charges with each other there.
  double Energy() const
  {
    const auto place = [&](int s) { return this->Spheres[s].Z + this->Spheres[s].Offset; };
    const double mutual = units::CoulombLength(298.15) * this->Spheres[0].Charge *
      this->Spheres[1].Charge / (this->Solute * std::abs(place(1) - place(0)));
    return -mutual + 0.5 * this->Spheres[0].Charge * this->ReactionAtCharge(0) +
      0.5 * this->Spheres[1].Charge * this->ReactionAtCharge(1);
  }

  Sphere Spheres[2];
  double Solute, Solvent;

private:
  /// The coefficient of (r/R)^l P_l about this center in (R'/r')^(k+1) P_k about the other one, at
  /// r = R.
  double Translation(
    int s, int k, int l, const Sphere& here, const Sphere& there, double distance) const
  {
    const double binomial =
      std::exp(std::lgamma(k + l + 1.0) - std::lgamma(k + 1.0) - std::lgamma(l + 1.0) +
        (k + 1.0) * std::log(there.Radius / distance) + l * std::log(here.Radius / distance));
    // Seen from the lower center the other lies above: r' cos t' = r cos t - D, and the sign is
    // (-1)^k; from the upper center it is (-1)^l.
    return ((s == 0 ? k : l) % 2 ? -1.0 : 1.0) * binomial;
  }

  double Multipoles(int s, const Point3& x) const
  {
    const Sphere& here = this->Spheres[s];
    const double z = x[2] - here.Z;
    const double r = std::hypot(x[0], x[1], z);
    double legendre = 1.0, previous = 0.0, sum = 0.0, decay = here.Radius / r;
    for (int l = 0; l < Degrees; ++l)
    {
      sum += this->B[static_cast<std::size_t>(s * Degrees + l)] * decay * legendre;
      const double next = ((2.0 * l + 1.0) * z / r * legendre - l * previous) / (l + 1.0);
      previous = legendre;
      legendre = next;
      decay *= here.Radius / r;
    }
    return sum;
  }

  std::vector<double> B;
};

}

#endif
