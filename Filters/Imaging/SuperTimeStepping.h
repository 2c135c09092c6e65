/**
 * @file SuperTimeStepping.h
 * @brief Time steps to an end time, and the stages of a Runge-Kutta-Legendre or other recurrence.
 *
 * Explicit (Euler) steps and super steps of Runge-Kutta-Legendre methods of first and second order
 * (C. D. Meyer, D. S. Balsara, T. D. Aslam, J. Comput. Phys. 257 (2014) 594). The stages of a step,
 * like those of any three-term recurrence, are evaluated several in each pass over memory.
 */
#ifndef isthmus_SuperTimeStepping_h
#define isthmus_SuperTimeStepping_h

#include "Core/Progress.h"
#include "Imaging/DiffusionGrid.h"
#include "Imaging/DiffusionOperator.h"
#include "vtkIsthmusFiltersImagingModule.h"

#include <array>
#include <memory>
#include <vector>

namespace isthmus
{

/// One step of an integrator: its length and how often it evaluates the right-hand side.
struct TimeStep
{
  double Length;
  int Stages;
};

/// The most stages of one super step: round-off grows with their square (see README).
constexpr int MaximumStages = 199;

/// Evaluations of the right-hand side that one evolution may take: steps are refused, with their
/// number, before they are made. A hundred times what denoising takes at most.
constexpr double MaximumEvaluations = 1e6;

/// @throws std::invalid_argument unless `evaluations` is at most MaximumEvaluations.
VTKISTHMUSFILTERSIMAGING_EXPORT void RequireEvaluations(double evaluations);

/// Explicit steps of at most `limit` that lead to `time`; `count` equal ones if it is not 0.
/// @throws std::invalid_argument, naming the limit, if these would be longer than it.
VTKISTHMUSFILTERSIMAGING_EXPORT std::vector<TimeStep> EulerSteps(
  double time, double limit, int count);

/**
 * Super steps that lead to `time`, where one explicit step may be at most `limit`.
 *
 * By default each is twice as long as the one before, from one explicit step's length up to the
 * time over max(12, 0.19 sqrt(time / limit)), or seven explicit steps' length: one super step only
 * halves what decays much faster than it is long, so that fast modes need early short steps, and so
 * do the edges, which appear while the noise goes; and what happened early counts for more later
 * (README has the measurements). With `count`, that many equal ones.
 * @throws std::invalid_argument, naming the limit, if one would need more than MaximumStages.
 */
VTKISTHMUSFILTERSIMAGING_EXPORT std::vector<TimeStep> SuperSteps(
  double time, double limit, int count);

/// How many stages a super step of this length takes: odd, at least three.
int SuperStages(double length, double limit);

/// The same for a step of the first-order method: about 0.7 times as many, at least one.
int FirstOrderStages(double length, double limit);

/// Factors of stage j (1 to `stages`) of a Runge-Kutta-Legendre step, second order.
template <typename T>
RowUpdate<T> LegendreStage(int j, int stages, double length);

/// The same of first order, for where a step is only to be looked ahead.
template <typename T>
RowUpdate<T> FirstOrderLegendreStage(int j, int stages, double length);

/// Each stage goes from the two before it (and the first values) to the next; see DiffusionPass.
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
  std::vector<StageSum<T>> Sums; ///< Each may be for the first stages only.
};

/// How many stages one pass does: on several ranks one, since each needs its own halo.
template <typename T>
int StagesPerPass(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion);

/// Does all stages (one at least) and returns the volume that holds the last one's result; bit for
/// bit the same however many stages a pass does. @throws Cancelled when progress says so.
template <typename T>
T* EvaluateStages(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion,
  const StageSequence<T>& sequence, const ProgressCallback& progress);

/// As many volumes as EvaluateStages needs, 2 or 4.
template <typename T>
class StageVolumes
{
public:
  StageVolumes(const DiffusionGrid<T>& grid, const DiffusionOperator<T>& diffusion);

  std::array<T*, 4> Pointers() const;

private:
  std::array<std::unique_ptr<T[]>, 4> Owned;
};

/// A volume's memory, left uninitialised: whoever writes it first touches it first.
template <typename T>
std::unique_ptr<T[]> NewVolume(std::int64_t size);

}

#endif
