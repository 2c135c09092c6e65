#include "Electrostatics/LocalPolynomial.h"

#include <cmath>

namespace isthmus
{

LineWeights WeightsAt(double t)
{
  LineWeights w{};
  for (int i = 0; i < Reach; ++i)
  {
    // The Lagrange polynomial as a product, carried along with its two derivatives.
    double p = 1.0, d = 0.0, s = 0.0;
    for (int j = 0; j < Reach; ++j)
    {
      if (j == i)
      {
        continue;
      }
      const double c = 1.0 / static_cast<double>(i - j);
      const double f = (t - static_cast<double>(j - Before)) * c;
      s = s * f + 2.0 * d * c;
      d = d * f + p * c;
      p *= f;
    }
    w.Value[i] = p;
    w.First[i] = d;
    w.Second[i] = s;
  }
  return w;
}

double Sample(
  const LevelFunction& level, const SolverBox& box, const std::array<std::int64_t, 3>& p)
{
  return level(box.First[0] + p[0] * box.Stride, box.First[1] + p[1] * box.Stride,
    box.First[2] + p[2] * box.Stride);
}

LocalPolynomial::LocalPolynomial(const LevelFunction& level, const SolverBox& box, const Point3& x)
{
  std::array<std::int64_t, 3> low;
  LineWeights w[3];
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double place = (x[a] - box.Corner[a]) / box.Spacing[a];
    low[a] = static_cast<std::int64_t>(std::floor(place));
    w[a] = WeightsAt(place - std::floor(place));
    for (int i = 0; i < Reach; ++i)
    {
      w[a].First[i] /= box.Spacing[a];
      w[a].Second[i] /= box.Spacing[a] * box.Spacing[a];
    }
  }
  for (int k = 0; k < Reach; ++k)
  {
    for (int j = 0; j < Reach; ++j)
    {
      for (int i = 0; i < Reach; ++i)
      {
        const double s =
          Sample(level, box, { low[0] + i - Before, low[1] + j - Before, low[2] + k - Before });
        const double vx = w[0].Value[i], vy = w[1].Value[j], vz = w[2].Value[k];
        this->Value += s * vx * vy * vz;
        this->Gradient[0] += s * w[0].First[i] * vy * vz;
        this->Gradient[1] += s * vx * w[1].First[j] * vz;
        this->Gradient[2] += s * vx * vy * w[2].First[k];
        this->Hessian[0][0] += s * w[0].Second[i] * vy * vz;
        this->Hessian[1][1] += s * vx * w[1].Second[j] * vz;
        this->Hessian[2][2] += s * vx * vy * w[2].Second[k];
        this->Hessian[0][1] += s * w[0].First[i] * w[1].First[j] * vz;
        this->Hessian[0][2] += s * w[0].First[i] * vy * w[2].First[k];
        this->Hessian[1][2] += s * vx * w[1].First[j] * w[2].First[k];
      }
    }
  }
  this->Hessian[1][0] = this->Hessian[0][1];
  this->Hessian[2][0] = this->Hessian[0][2];
  this->Hessian[2][1] = this->Hessian[1][2];
}

}
