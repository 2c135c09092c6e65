/**
 * @file TimeSteps.h
 * @brief Which steps lead to an end time, and the coefficients of a Runge-Kutta-Legendre step.
 */
#ifndef isthmus_TimeSteps_h
#define isthmus_TimeSteps_h

#include "Imaging/DiffusionRows.h"
#include "vtkIsthmusFiltersImagingModule.h"

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
VTKISTHMUSFILTERSIMAGING_EXPORT void DemandEvaluations(double evaluations);

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

}

#endif
