#include "QuadraticErrors.h"

#include <Eigen/Dense>

#include <limits>

namespace isthmus
{

void QuadraticErrors::Add(const Point3& p, const Point3& n)
{
  for (std::size_t r = 0; r < 3; ++r)
  {
    this->Matrix[r] = this->Matrix[r] + n[r] * n;
  }
  this->Sum = this->Sum + p;
  this->Planes.push_back({ p, n });
}

double QuadraticErrors::At(const Point3& x) const
{
  double sum = 0.0;
  for (const auto& [p, n] : this->Planes)
  {
    const double d = Dot(n, x - p);
    sum += d * d;
  }
  return sum;
}

Point3 QuadraticErrors::Least(const Bounds3& box, double threshold) const
{
  const Point3 mean = (1.0 / static_cast<double>(this->Planes.size())) * this->Sum;
  Eigen::Matrix3d a;
  Eigen::Vector3d b = Eigen::Vector3d::Zero();
  for (int r = 0; r < 3; ++r)
  {
    a.row(r) = Eigen::Map<const Eigen::Vector3d>(this->Matrix[static_cast<std::size_t>(r)].data());
  }
  for (const auto& [p, n] : this->Planes)
  {
    b += Dot(n, p - mean) * Eigen::Map<const Eigen::Vector3d>(n.data());
  }
  const double largest =
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(a, Eigen::EigenvaluesOnly).eigenvalues()[2];

  Point3 best = mean;
  double least = std::numeric_limits<double>::infinity();
  // Each coordinate is free (0) or at the lower (1) or upper (2) side: 27 cases, all free first.
  for (int sides = 0; sides < 27; ++sides)
  {
    const std::array<int, 3> side{ sides % 3, sides / 3 % 3, sides / 9 };
    Eigen::Vector3d x = Eigen::Vector3d::Zero();
    Eigen::Matrix3d free = Eigen::Matrix3d::Identity();
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto i = static_cast<std::size_t>(axis);
      if (side[i] > 0)
      {
        x[axis] = (side[i] == 1 ? box.Min[i] : box.Max[i]) - mean[i];
        free(axis, axis) = 0.0;
      }
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(free * a * free);
    const Eigen::Vector3d rest = free * (b - a * x);
    for (int k = 0; k < 3; ++k)
    {
      const double value = solver.eigenvalues()[k];
      if (value > threshold * largest && value > 0.0)
      {
        const Eigen::Vector3d v = solver.eigenvectors().col(k);
        x += (v.dot(rest) / value) * v;
      }
    }
    Point3 candidate;
    bool fits = true;
    for (std::size_t i = 0; i < 3; ++i)
    {
      candidate[i] = mean[i] + x[static_cast<Eigen::Index>(i)];
      const double slack = 1e-9 * (box.Max[i] - box.Min[i]);
      fits = fits && candidate[i] >= box.Min[i] - slack && candidate[i] <= box.Max[i] + slack;
      candidate[i] = std::min(box.Max[i], std::max(box.Min[i], candidate[i]));
    }
    const double value = this->At(candidate);
    if (fits && value < least)
    {
      best = candidate;
      least = value;
    }
    if (fits && sides == 0)
    {
      break;
    }
  }
  return best;
}

}
