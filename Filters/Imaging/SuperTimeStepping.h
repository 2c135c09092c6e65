/**
 * @file SuperTimeStepping.h
 * @brief Time steps to an end time, and the stages of a Runge-Kutta-Legendre or other recurrence.
 *
 * Explicit (Euler) steps and super steps of Runge-Kutta-Legendre methods of first and second order
 * (C. D. Meyer, D. S. Balsara, T. D. Aslam, J. Comput. Phys. 257 (2014) 594). Several stages of a
 * step, or of any other three-term recurrence, are evaluated in each pass over memory.
 */
#ifndef isthmus_SuperTimeStepping_h
#define isthmus_SuperTimeStepping_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "Imaging/DiffusionOperator.h"

#include <array>
#include <memory>
#include <vector>

namespace isthmus
{

/// One step of an integrator: its length and the number of evaluations of the right-hand side.
struct TimeStep
{
  double Length;
  int Stages;
};

/// Maximum number of stages of one super step; round-off grows with its square.
constexpr int MaximumStages = 199;

/// Maximum number of evaluations of the right-hand side in one evolution. Steps that need more are
/// refused, with their number, before they start. This is a hundred times the number that
/// denoising needs at most.
constexpr double MaximumEvaluations = 1e6;

/// @throws std::invalid_argument unless `evaluations` is at most MaximumEvaluations.
void RequireEvaluations(double evaluations);

/// Explicit steps of length at most `limit` that lead to `time`; `count` equal steps if it is not
/// 0.
/// @throws std::invalid_argument, naming the limit, if these steps would exceed it.
std::vector<TimeStep> EulerSteps(double time, double limit, int count);

/**
 * Super steps that lead to `time` if one explicit step may be at most `limit`.
 *
 * By default each step is twice as long as the one before, from the length of one explicit step up
 * to time / max(12, 0.19 sqrt(time / limit)), or the length of seven explicit steps. With `count`,
 * this many equal steps.
 * @throws std::invalid_argument, naming the limit, if a step would need more than MaximumStages.
 */
std::vector<TimeStep> SuperSteps(double time, double limit, int count);

/// Number of stages of a super step of this length: odd, at least three.
int SuperStages(double length, double limit);

/// The same for a step of the first-order method, which needs about 0.7 times as many stages, at
/// least one.
int FirstOrderStages(double length, double limit);

/// Factors of stage j (1 to `stages`) of a Runge-Kutta-Legendre step, second order.
template <typename T>
RowUpdate<T> LegendreStage(int j, int stages, double length);

/// The same for the first-order method, for steps that only look ahead.
template <typename T>
RowUpdate<T> FirstOrderLegendreStage(int j, int stages, double length);

/// Each stage is computed from the two before it (and the first values); see DiffusionPass.
template <typename T>
struct StageSequence
{
  std::vector<RowUpdate<T>> Updates; ///< one for each stage
  const T* Before = nullptr;         ///< If null, the first stage is an explicit step.
  const T* Current = nullptr;
  const T* First = nullptr;
  const T* FirstRate = nullptr; ///< may be null, see DiffusionPass
  /// Where stages are written; Before and Current may be among them. The third and fourth are used
  /// where StagesPerPass is more than 1.
  std::array<T*, 4> Volumes{};
  std::vector<StageSum<T>> Sums; ///< Each may cover only the first stages.
};

/// Number of stages in one pass; one on several ranks, since each stage needs its own halo.
template <typename T>
int StagesPerPass(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion);

/// Does all stages (at least one) and returns the volume that holds the result of the last one. The
/// result is bitwise the same for any number of stages in a pass.
/// @throws Cancelled if `progress` returns false.
template <typename T>
T* EvaluateStages(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion,
  const StageSequence<T>& sequence, const ProgressCallback& progress);

/// The number of volumes that EvaluateStages needs, 2 or 4.
template <typename T>
class StageVolumes
{
public:
  StageVolumes(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion);

  std::array<T*, 4> Pointers() const;

private:
  std::array<std::unique_ptr<T[]>, 4> Owned;
};

/// Memory of a volume, left uninitialised, so that the thread that first writes a page also
/// allocates it.
template <typename T>
std::unique_ptr<T[]> NewVolume(std::int64_t size);

}

#endif
