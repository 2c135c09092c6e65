/**
 * @file ChargesOnGrid.h
 * @brief The Coulomb potential G of the charges where a solution needs it: at crossings and at
 * nodes.
 */
#ifndef isthmus_ChargesOnGrid_h
#define isthmus_ChargesOnGrid_h

#include "Electrostatics/ChargeSums.h"
#include "Electrostatics/InterfaceGeometry.h"

namespace isthmus
{

/// G with derivatives at each point, directly or, with many charges, by a tree for each brick of
/// 8^3 nodes of the box. Parallel.
std::vector<SecondOrderTaylor> ChargesAtPoints(const ChargeList& charges, const SolverBox& box,
  const std::vector<Point3>& points, const ProgressCallback& progress = {});

/// The values of the same charges at the crossings of a surface with the same box, in the order of
/// the crossings.
struct KnownCharges
{
  const std::vector<InterfaceCrossing>* Crossings = nullptr;
  const std::vector<SecondOrderTaylor>* Values = nullptr;
};

/// The same at each crossing; computed only for crossings that are not bitwise equal to known ones.
std::vector<SecondOrderTaylor> ChargesAtCrossings(const ChargeList& charges, const SolverBox& box,
  const std::vector<InterfaceCrossing>& crossings, const KnownCharges& known,
  const ProgressCallback& progress = {});

/**
 * Calls use(node, G) for the nodes of the box, in parallel, bricks of 8^3 at a time. At nodes
 * nearer to a charge than a quarter of the shortest spacing, its potential is that at this
 * distance. Beyond a few hundred charges a tree is used, with a relative error of 1e-5.
 */
void ChargesAtNodes(const ChargeList& charges, const SolverBox& box,
  const std::function<void(std::int64_t node, double g)>& use,
  const ProgressCallback& progress = {});

}

#endif
