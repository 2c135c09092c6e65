/**
 * @file CoupledFlow.h
 * @brief Steps shared by flows that are coupled with an electric field: a period of flow under a
 * fixed pull, and the extension of the pull away from the surface.
 *
 * SolvationFlow.h and MovingChannel.h alternate between the flow of the surface and the solution
 * for the field. A period has steps of dt = 0.16 spacing^2. Distances are restored after every
 * fourth step. The period may end when the volume converges, and a part of the motion may be
 * undone. The last steps are the same for all policies.
 *
 * The pull of the field (BoundaryForces.h: the derivative of the electrostatic energy with respect
 * to the position of the surface; thesis 4.18 with the jump instead of its smeared permittivity) is
 * an energy per volume and never negative: the field pulls the solvent towards the charges, and
 * only an obstacle stops it. The osmotic pressure of the ions is omitted, because it is smaller by
 * kappa^2 times a squared length of the surface.
 */
#ifndef isthmus_CoupledFlow_h
#define isthmus_CoupledFlow_h

#include "Electrostatics/BoundaryForces.h"
#include "MolecularSurfaces/FlowField.h"
#include "Solvation/SolvationParameters.h"

#include <vector>

namespace isthmus
{

/// Restores signed distances in the whole band, within the bounds.
void RestoreDistances(FlowField& field);

/// Moves the surface for one period; returns the time of the flow, square angstrom.
double EvolveForPeriod(FlowField& field, const UpdatePolicy& policy);

/// The fraction of the nodes next to the surface that its obstacle holds.
double FractionOnObstacle(const FlowField& field);

/// Limits a pull (in spacings) so that the surface moves by at most 0.4 spacings in a step.
void LimitPull(std::vector<float>& pull);

/// field.Pull <- part (steady + scale more) + (1 - part) field.Pull, limited.
void UpdatePull(FlowField& field, const std::vector<float>& steady, const std::vector<float>& more,
  double scale, double part);

/**
 * Extends values at the crossings to the nodes of the grid of a flow. Nodes of a crossed edge get
 * the mean of their crossings, nodes farther away the mean of their neighbours that have a value,
 * layer by layer, so that values are extended to both sides of the surface. The volume of the level
 * is the grid without its margin. O(nodes), serial; 5 bytes for each node.
 */
std::vector<float> ExtendOffSurface(const SolverBox& box,
  const std::vector<InterfaceCrossing>& crossings, const std::vector<double>& values,
  const FlowGrid& grid);

}

#endif
