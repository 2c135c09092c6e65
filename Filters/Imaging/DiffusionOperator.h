/**
 * @file DiffusionOperator.h
 * @brief The right-hand side of a high-order diffusion equation.
 *
 * The rate of change of u is
 *
 *     leading * div(c grad W) + fidelity * (input - u) + source,   W = sum_p weight_p L^p u,
 *
 * with L the 7-point Laplacian, L^p by repetition, c one coefficient for all orders. It is
 * evaluated by DiffusionEvaluation.h.
 */
#ifndef isthmus_DiffusionOperator_h
#define isthmus_DiffusionOperator_h

#include "Imaging/DiffusionRows.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Source of the coefficient c of the divergence.
enum class DiffusionCoefficient
{
  Constant, ///< c = 1
  Gaussian, ///< c = exp(-|grad u|^2), the gradient in units of GradientScale (4.34)
  Gram      ///< 1/sqrt(g), and sqrt(g) before the divergence, g = 1 + |grad W|^2 (4.36)
};

/// The discrete operator. Lengths are in the grid's unit; every volume has the grid's dimensions.
template <typename T>
struct DiffusionOperator
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  DiffusionCoefficient Coefficient = DiffusionCoefficient::Constant;
  double GradientScale = 1.0;     ///< Gradients are divided by this value, which is sigma sqrt(2)
                                  ///< for equation 4.34.
  std::vector<T> Weights{ T(1) }; ///< weight_p; the last is that of the highest order and 1.
  T Leading = 1;
  /// If not null, precomputed values that are read: exp(-|grad u|^2), or |grad W|^2 for Gram.
  const T* StoredCoefficient = nullptr;
  T Fidelity = 0;
  const T* Input = nullptr;  ///< Used if Fidelity is not 0.
  const T* Source = nullptr; ///< May be null.

  int Order() const { return static_cast<int>(this->Weights.size()) - 1; }

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }

  /// Distance, in nodes along an axis, of the farthest node that one evaluation reads: 1 to 5.
  int Reach() const;

  /// Bound on the modulus of the operator's eigenvalues: forward Euler needs steps <= 2 / bound.
  double SpectralBound() const;
};

/// Number of planes by which each quantity lags behind the plane of u that an evaluation reads.
struct DiffusionLags
{
  template <typename T>
  explicit DiffusionLags(const DiffusionOperator<T>& diffusion);

  int W; ///< and L^m u: m
  int C;
  int Out;
};

/// Volumes that the stages of a pass read and write.
template <typename T>
struct StageSum
{
  T* Volume = nullptr;
  /// volume += StageFactors[s] (stage s - first); stages without a factor add nothing.
  std::vector<T> StageFactors;
};

/**
 * Consecutive stages of a time step in one pass over memory, each
 *
 *     out = update of (current, previous, first, rate of current, first rate),
 *
 * where `current` and `previous` of a stage are the results of the two before it. With more than
 * one stage, no volume that is written is read.
 */
template <typename T>
struct DiffusionPass
{
  std::vector<RowUpdate<T>> Updates; ///< one for each stage, in their order
  const T* Current = nullptr;        ///< of the first stage
  const T* Previous = nullptr;   ///< of the first stage; if there is only one stage, it may be Out
  const T* First = nullptr;      ///< If null, stages are explicit steps (current and rate only).
  const T* FirstRate = nullptr;  ///< If null, FirstRateFactor must be 0.
  T* Out = nullptr;              ///< of the last stage; never the same volume as Current
  T* OutBefore = nullptr;        ///< Receives the second-last stage, if not null.
  T* StoreRate = nullptr;        ///< Receives the first stage's rate, if not null.
  T* StoreCoefficient = nullptr; ///< Receives the values of a StoredCoefficient, if not null.
  std::vector<StageSum<T>> Sums; ///< need First

  int Stages() const { return static_cast<int>(this->Updates.size()); }
};

}

#endif
