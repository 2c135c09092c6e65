/**
 * @file LevelFunction.h
 * @brief A level set of a volume on a box of nodes that may reach beyond it: below 0 inside.
 */
#ifndef isthmus_LevelFunction_h
#define isthmus_LevelFunction_h

#include "Core/GridView.h"
#include "Electrostatics/PoissonBoltzmannParameters.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace isthmus
{

/// A box of nodes on (or between) the nodes of a volume: every `Stride`-th, from `First` on.
struct SolverBox
{
  std::array<std::int64_t, 3> First{ 0, 0, 0 }; ///< in nodes of the volume; may be negative
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  std::int64_t Stride = 1;
  Point3 Spacing{ 1.0, 1.0, 1.0 }; ///< between nodes of the box
  Point3 Corner{ 0.0, 0.0, 0.0 };  ///< position of its first node in the frame of the volume

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }
  Point3 Position(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return { this->Corner[0] + static_cast<double>(i) * this->Spacing[0],
      this->Corner[1] + static_cast<double>(j) * this->Spacing[1],
      this->Corner[2] + static_cast<double>(k) * this->Spacing[2] };
  }
  Point3 Position(std::int64_t node) const
  {
    const std::int64_t row = node / this->Dimensions[0];
    return this->Position(
      node % this->Dimensions[0], row % this->Dimensions[1], row / this->Dimensions[1]);
  }
  std::array<std::int64_t, 3> Steps() const
  {
    return { 1, this->Dimensions[0], this->Dimensions[0] * this->Dimensions[1] };
  }
};

/**
 * The volume's scalar S as a function that is 0 at the level and below 0 inside.
 *
 * Its derivatives give normals and curvatures, so it should be as linear as possible across the
 * surface; for a sum of Gaussians its logarithm is used, -log(S / level). Nothing is copied; one of
 * the two views is set. Beyond the volume it is extrapolated linearly, but nodes outside never
 * become nodes inside.
 */
struct LevelFunction
{
  GridView<const float> Floats;
  GridView<const double> Doubles;
  double Level = 0.0;
  bool InsideIsHigher = true;
  bool Logarithm = false;

  const std::array<std::int64_t, 3>& Dimensions() const
  {
    return this->Floats.Data ? this->Floats.Dimensions : this->Doubles.Dimensions;
  }
  const std::array<double, 3>& Spacing() const
  {
    return this->Floats.Data ? this->Floats.Spacing : this->Doubles.Spacing;
  }

  double Scalar(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    return this->Floats.Data ? static_cast<double>(this->Floats(i, j, k)) : this->Doubles(i, j, k);
  }

  /// Nodes exactly at the level are outside.
  bool Inside(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const double s = this->Scalar(i, j, k);
    return this->InsideIsHigher ? s > this->Level : s < this->Level;
  }

  double Node(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const double s = this->Scalar(i, j, k);
    const double up =
      this->Logarithm ? std::log(std::max(s, 1e-300) / this->Level) : s - this->Level;
    return this->InsideIsHigher ? -up : up;
  }

  /// The value at any node, even beyond the volume.
  double operator()(std::int64_t i, std::int64_t j, std::int64_t k) const
  {
    const auto& n = this->Dimensions();
    const std::array<std::int64_t, 3> at{ i, j, k };
    std::array<std::int64_t, 3> near;
    bool beyond = false;
    for (std::size_t a = 0; a < 3; ++a)
    {
      near[a] = std::clamp<std::int64_t>(at[a], 0, n[a] - 1);
      beyond = beyond || near[a] != at[a];
    }
    const double border = this->Node(near[0], near[1], near[2]);
    if (!beyond)
    {
      return border;
    }
    double value = border;
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (near[a] == at[a] || n[a] < 2)
      {
        continue;
      }
      auto before = near;
      before[a] += at[a] > near[a] ? -1 : 1;
      value += static_cast<double>(std::abs(at[a] - near[a])) *
        (border - this->Node(before[0], before[1], before[2]));
    }
    return std::max(value, border > 0.0 ? 0.5 * border : border);
  }
};

}

#endif
