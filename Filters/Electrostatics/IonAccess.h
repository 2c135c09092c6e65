/**
 * @file IonAccess.h
 * @brief The region that ions can reach if they keep a distance from the surface.
 */
#ifndef isthmus_IonAccess_h
#define isthmus_IonAccess_h

#include "Electrostatics/InterfaceGeometry.h"

#include <cmath>

namespace isthmus
{

/// A node whose cell is cut by the boundary of the ions, and the nearest surface.
struct IonBorderNode
{
  std::int64_t Node;
  Point3 Foot;   ///< nearest point of the surface, frame of the volume
  Point3 Normal; ///< there, outwards
};

/**
 * The fraction of each node's cell that ions reach: 0 inside and within `layer` (angstrom) of the
 * surface, 1 beyond, and clamp(1/2 + D / h) where the boundary of the ions, at signed distance D,
 * cuts the cell (h: IonBorderWidth). Distances are those to the osculating paraboloid of the
 * nearest crossing. With layer 0: 0 inside, 1 outside. The nodes in between are stored in `border`,
 * unless it is null. O(nodes + crossings layer^3 / h^3), serial.
 */
std::vector<float> IonAccess(const SolverBox& box, const std::vector<unsigned char>& inside,
  const std::vector<InterfaceCrossing>& crossings, double layer,
  std::vector<IonBorderNode>* border = nullptr);

/// A node whose cell the surface cuts.
struct CutCell
{
  std::int64_t Node;
  std::size_t Crossing; ///< the nearest on an edge of the node
  double Excess; ///< the part of the cell outside, clamp(1/2 + D / h), less 1 for a node outside
};

/// The cells, by node, that a sum over nodes outside includes either entirely or not at all.
/// O(crossings).
std::vector<CutCell> CutCells(const SolverBox& box, const std::vector<unsigned char>& inside,
  const std::vector<InterfaceCrossing>& crossings);

/// The distance over which the access goes from 0 to 1.
inline double IonBorderWidth(const SolverBox& box)
{
  return std::cbrt(box.Spacing[0] * box.Spacing[1] * box.Spacing[2]);
}

}

#endif
