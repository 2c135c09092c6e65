/**
 * @file CrossingValues.h
 * @brief What the two sides' functions are across the surface, at the ends of an edge it crosses.
 */
#ifndef isthmus_CrossingValues_h
#define isthmus_CrossingValues_h

#include "ChargeSums.h"
#include "InterfaceFit.h"
#include "vtkIsthmusModule.h"

namespace isthmus
{

/// What the values are made of.
struct InterfaceProblem
{
  const SolverBox* Box = nullptr;
  const std::vector<unsigned char>* Inside = nullptr;
  const std::vector<InterfaceCrossing>* Crossings = nullptr;
  const std::vector<SecondOrderTaylor>* Charges = nullptr; ///< G at each crossing, kT/e
  FitMedium Medium;
  /// K / phi0 at each crossing where the ions reach the surface; empty: Medium.KappaSquared.
  std::vector<double> KappaSquared;
};

/// The nodes around the edge of a crossing, with weights, for a fit at the crossing.
VTKISTHMUS_EXPORT FitNodes NodesAroundCrossing(const SolverBox& box,
  const std::vector<unsigned char>& inside, const InterfaceCrossing& crossing, double length);

/// A fictitious value as a sum over nodes and a constant.
struct Continuation
{
  std::array<double, 36> Coefficient;
  double Constant;
};

/// Of a crossing: the function of the lower end's side at the upper end, and the reverse.
struct CrossingValues
{
  std::array<std::int64_t, 36> Id;
  Continuation AtUpper, AtLower;
  FitQuality Quality;
};

/// By InterfaceFit, or by the ghost-fluid values where nothing can be fitted.
CrossingValues ValuesAtCrossing(const InterfaceProblem& problem, std::size_t index);

}

#endif
