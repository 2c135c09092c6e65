/**
 * @file CoupledFlow.h
 * @brief The steps that flows coupled with an electric field share: a period of flow under a fixed
 * pull, and the pull of the field off the surface.
 *
 * SolvationFlow.h and MovingChannel.h alternate between the flow of the surface and the solution
 * for the field. A period has steps of dt = 0.16 spacing^2, distances are restored every four, it
 * may end where the volume converges, a part of the motion may be taken back, and the last steps
 * are the same for all policies.
 *
 * The pull of the field (BoundaryForces.h: the derivative of the electrostatic energy by the
 * surface's place; thesis 4.18 with the jump in place of its smeared permittivity) is an energy for
 * each volume, never negative: the field draws the solvent towards the charges, and only an
 * obstacle ends that. Ions' osmotic pressure is omitted: it is smaller by kappa^2 times a squared
 * length of the surface.
 */
#ifndef isthmus_CoupledFlow_h
#define isthmus_CoupledFlow_h

#include "Electrostatics/BoundaryForces.h"
#include "MolecularSurfaces/FlowField.h"
#include "vtkIsthmusFiltersSolvationModule.h"

#include <vector>

namespace isthmus
{

/// How surface and field alternate.
struct UpdatePolicy
{
  int UpdatePeriod = 50;          ///< steps of the flow between solutions
  bool AdaptiveUpdate = true;     ///< end a period as soon as the volume has converged
  double SurfaceRelaxation = 1.0; ///< alpha: the fraction of each period's motion that is used
  double FieldRelaxation = 1.0;   ///< alpha': the fraction of each new field's force
  double Tolerance = 1e-3;        ///< relative change of the monitored quantities, twice in a row
  int MaximumUpdates = 20;
};

/// @throws std::invalid_argument for parameters out of range.
void CheckPolicy(const UpdatePolicy& policy);

/// Restores signed distances in the whole band, between the bounds.
void RestoreDistances(FlowField& field);

/// Moves the surface for one period; returns the time of the flow, square angstrom.
double EvolveForPeriod(FlowField& field, const UpdatePolicy& policy);

/// The fraction of the nodes next to the surface that its obstacle holds.
double FractionOnObstacle(const FlowField& field);

/// Limits a pull (spacings) to what moves the surface by at most 0.4 spacings in a step.
void LimitPull(std::vector<float>& pull);

/// field.Pull <- part (steady + scale more) + (1 - part) field.Pull, limited.
void UpdatePull(FlowField& field, const std::vector<float>& steady, const std::vector<float>& more,
  double scale, double part);

/**
 * Values of the crossings at the nodes of a flow's grid: nodes of an edge that is crossed have the
 * mean of their crossings, those farther out that of their neighbours which have one, layer by
 * layer, so that values are carried off the surface to both sides. The level's volume is the grid
 * without its margin. O(nodes), serial; 5 bytes a node.
 */
VTKISTHMUSFILTERSSOLVATION_EXPORT std::vector<float> ExtendOffSurface(const SolverBox& box,
  const std::vector<InterfaceCrossing>& crossings, const std::vector<double>& values,
  const FlowGrid& grid);

}

#endif
