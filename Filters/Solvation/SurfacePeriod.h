/**
 * @file SurfacePeriod.h
 * @brief A period of a surface's flow under a pull that stays, between two solutions for the field.
 *
 * What SolvationFlow.h and MovingChannel.h have in common: steps of dt = 0.16 spacing^2, distances
 * made anew every four, an end where the volume rests, a part of the motion taken back, and the
 * last steps the same for all policies.
 */
#ifndef isthmus_SurfacePeriod_h
#define isthmus_SurfacePeriod_h

#include "MolecularSurfaces/FlowField.h"

#include <vector>

namespace isthmus
{

/// How surface and field take turns.
struct UpdatePolicy
{
  int UpdatePeriod = 50;          ///< steps of the flow between solutions
  bool AdaptiveUpdate = true;     ///< end a period as soon as the volume rests
  double SurfaceRelaxation = 1.0; ///< alpha: the part of each period's motion that is taken
  double FieldRelaxation = 1.0;   ///< alpha': the part of each new field's force
  double Tolerance = 1e-3;        ///< of what is looked at, relative, twice in a row
  int MaximumUpdates = 20;
};

/// @throws std::invalid_argument, with a sentence, for what is out of range.
void CheckPolicy(const UpdatePolicy& policy);

/// Distances through the whole band, between the bounds.
void Settle(FlowField& field);

/// Moves the surface for one period; the time that passed, square angstrom.
double EvolveForPeriod(FlowField& field, const UpdatePolicy& policy);

/// The part of the nodes next to the surface that its obstacle holds, 0 to 1.
double PartOnObstacle(const FlowField& field);

/// Cuts a pull (spacings) where a step would move the surface by more than 0.4 spacings.
void CutPull(std::vector<float>& pull);

/// field.Pull <- part (steady + scale more) + (1 - part) field.Pull, cut.
void TakePull(FlowField& field, const std::vector<float>& steady, const std::vector<float>& more,
  double scale, double part);

}

#endif
