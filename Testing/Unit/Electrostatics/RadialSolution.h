/**
 * @file RadialSolution.h
 * @brief The nonlinear Poisson-Boltzmann equation around a charged sphere, by shooting.
 */
#ifndef isthmus_RadialSolution_h
#define isthmus_RadialSolution_h

#include "Electrostatics/ElectrostaticUnits.h"
#include "Electrostatics/IonAtmosphere.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace isthmus::testing
{

/// phi(r) outside a sphere of charge q at its center: (r^2 phi')' = r^2 f(phi) / eps_s from a on,
/// phi' = -C q / (eps_s r^2) before. Integrated inwards from the Debye-Hueckel tail, whose height
/// is found by bisection.
class RadialSolution
{
public:
  RadialSolution(double charge, double radius, double layer, const IonAtmosphere& ions)
    : Radius(radius)
    , Layer(layer)
    , Inner(radius + 1e9)
    , Solvent(80.0)
    , Strength(units::CoulombLength(298.15) * charge / this->Solvent)
    , Ions(ions)
  {
    for (std::size_t l = 0; l < ions.NumberOfLayers(); ++l)
    {
      this->Inner = std::min(this->Inner, this->Begin(l));
    }
    double low = 0.0, high = 200.0 * std::abs(this->Strength);
    for (int step = 0; step < 200; ++step)
    {
      const double height = 0.5 * (low + high);
      (this->Integrate(height) > std::abs(this->Strength) ? high : low) = height;
    }
  }

  double operator()(double r) const
  {
    if (r < this->Inner)
    {
      return this->Values.front() + this->Strength * (1.0 / r - 1.0 / this->Inner);
    }
    const double place = (r - this->Inner) / Step;
    const auto i = std::min(static_cast<std::size_t>(place), this->Values.size() - 2);
    const double t = place - static_cast<double>(i);
    return (1.0 - t) * this->Values[i] + t * this->Values[i + 1];
  }

private:
  static constexpr double Step = 0.002;
  static constexpr std::size_t Count = 30000; // 60 angstrom

  /// Where the ions of a layer begin.
  double Begin(std::size_t layer) const
  {
    const double own = this->Ions.LayerRadius(layer);
    return this->Radius + (own < 0.0 ? this->Layer : own);
  }

  double ChargeOfIons(double r, double phi) const
  {
    double sum = 0.0;
    for (std::size_t l = 0; l < this->Ions.NumberOfLayers(); ++l)
    {
      sum += r >= this->Begin(l) - 1e-9 ? this->Ions.Charge(l, phi) : 0.0;
    }
    return sum;
  }

  /// -r^2 phi' at the inner radius for a tail of that height; Runge-Kutta inwards.
  double Integrate(double height)
  {
    const double kappa = std::sqrt(this->Ions.Linear() / this->Solvent);
    const double sign = this->Strength < 0.0 ? -1.0 : 1.0;
    double r = this->Inner + Step * static_cast<double>(Count);
    double phi = sign * height * std::exp(-kappa * (r - this->Inner)) / r;
    double flux = -r * (1.0 + kappa * r) * phi; // r^2 phi'
    this->Values.assign(Count + 1, 0.0);
    this->Values[Count] = phi;
    const auto slopes = [&](double x, double p, double f)
    {
      return std::pair<double, double>(
        f / (x * x), x * x * this->ChargeOfIons(x, p) / this->Solvent);
    };
    for (std::size_t i = Count; i-- > 0;)
    {
      const double d = -Step;
      const auto k1 = slopes(r, phi, flux);
      const auto k2 = slopes(r + 0.5 * d, phi + 0.5 * d * k1.first, flux + 0.5 * d * k1.second);
      const auto k3 = slopes(r + 0.5 * d, phi + 0.5 * d * k2.first, flux + 0.5 * d * k2.second);
      const auto k4 = slopes(r + d, phi + d * k3.first, flux + d * k3.second);
      phi += d / 6.0 * (k1.first + 2.0 * k2.first + 2.0 * k3.first + k4.first);
      flux += d / 6.0 * (k1.second + 2.0 * k2.second + 2.0 * k3.second + k4.second);
      r += d;
      this->Values[i] = phi;
      if (std::abs(phi) > 40.0)
      {
        return 1e9;
      }
    }
    return std::abs(flux);
  }

  double Radius, Layer, Inner, Solvent, Strength;
  const IonAtmosphere& Ions;
  std::vector<double> Values;
};

}

#endif
