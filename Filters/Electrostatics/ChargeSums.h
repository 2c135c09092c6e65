/**
 * @file ChargeSums.h
 * @brief Sums over point charges: the Coulomb potential with two derivatives, and the Debye-Hueckel
 * potential.
 */
#ifndef isthmus_ChargeSums_h
#define isthmus_ChargeSums_h

#include "Electrostatics/PoissonBoltzmannParameters.h"

#include <vector>

namespace isthmus
{

/// Charges in four arrays, so that loops over them use vector instructions.
struct ChargeList
{
  std::vector<double> X, Y, Z, Charge;

  void Add(const Point3& position, double charge)
  {
    this->X.push_back(position[0]);
    this->Y.push_back(position[1]);
    this->Z.push_back(position[2]);
    this->Charge.push_back(charge);
  }
  /// The charges [first, last) of another list.
  void Append(const ChargeList& from, std::size_t first, std::size_t last)
  {
    const auto append = [&](std::vector<double>& to, const std::vector<double>& values)
    {
      to.insert(to.end(), values.begin() + static_cast<std::ptrdiff_t>(first),
        values.begin() + static_cast<std::ptrdiff_t>(last));
    };
    append(this->X, from.X);
    append(this->Y, from.Y);
    append(this->Z, from.Z);
    append(this->Charge, from.Charge);
  }
  void Clear()
  {
    this->X.clear();
    this->Y.clear();
    this->Z.clear();
    this->Charge.clear();
  }
  std::size_t Size() const { return this->X.size(); }
};

/// A function at a point: value, gradient, and second derivatives xx, yy, zz, xy, xz, yz.
struct SecondOrderTaylor
{
  double Value = 0.0;
  Point3 Gradient{ 0.0, 0.0, 0.0 };
  std::array<double, 6> Hessian{ 0.0, 0.0, 0.0, 0.0, 0.0, 0.0 };

  /// The value of the Taylor polynomial at the offset y from the point.
  double At(const Point3& y) const
  {
    const auto& h = this->Hessian;
    return this->Value + this->Gradient[0] * y[0] + this->Gradient[1] * y[1] +
      this->Gradient[2] * y[2] +
      0.5 * (h[0] * y[0] * y[0] + h[1] * y[1] * y[1] + h[2] * y[2] * y[2]) + h[3] * y[0] * y[1] +
      h[4] * y[0] * y[2] + h[5] * y[1] * y[2];
  }
};

/// sum q / |x - r| and its derivatives. O(charges).
SecondOrderTaylor CoulombSum(const ChargeList& charges, const Point3& x);

/// sum q / max(|x - r|, nearest).
double CoulombValue(const ChargeList& charges, const Point3& x, double nearest);

/// sum q exp(-kappa |x - r|) / |x - r| over charges [first, last).
double ScreenedSum(
  const ChargeList& charges, double kappa, const Point3& x, std::size_t first, std::size_t last);

/// Over all.
inline double ScreenedSum(const ChargeList& charges, double kappa, const Point3& x)
{
  return ScreenedSum(charges, kappa, x, 0, charges.Size());
}

}

#endif
