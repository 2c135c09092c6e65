/**
 * @file IonAccess.h
 * @brief Where ions that keep off the surface get.
 */
#ifndef isthmus_IonAccess_h
#define isthmus_IonAccess_h

#include "Electrostatics/InterfaceGeometry.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <cmath>

namespace isthmus
{

/// A node whose cell the border of the ions cuts, and the surface next to it.
struct IonBorderNode
{
  std::int64_t Node;
  Point3 Foot;   ///< nearest point of the surface, frame of the volume
  Point3 Normal; ///< there, outwards
};

/**
 * The part of each node's cell that ions reach: 0 inside and within `layer` (angstrom) of the
 * surface, 1 beyond, clamp(1/2 + D / h) where that border, at signed distance D, cuts the cell (h:
 * IonBorderWidth). Distances are those to the osculating paraboloid of the nearest crossing. With
 * layer 0: 0 inside, 1 outside. The nodes in between go to `border`, if any is given. O(nodes +
 * crossings layer^3 / h^3), serial.
 */
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<float> IonAccess(const SolverBox& box,
  const std::vector<unsigned char>& inside, const std::vector<InterfaceCrossing>& crossings,
  double layer, std::vector<IonBorderNode>* border = nullptr);

/// A node whose cell the surface cuts.
struct CutCell
{
  std::int64_t Node;
  std::size_t Crossing; ///< the nearest on an edge of the node
  double Excess; ///< the part of the cell outside, clamp(1/2 + D / h), less 1 for a node outside
};

/// The cells that a sum over nodes outside takes wholly or not at all, by node. O(crossings).
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<CutCell> CutCells(const SolverBox& box,
  const std::vector<unsigned char>& inside, const std::vector<InterfaceCrossing>& crossings);

/// The distance over which the access goes from 0 to 1.
inline double IonBorderWidth(const SolverBox& box)
{
  return std::cbrt(box.Spacing[0] * box.Spacing[1] * box.Spacing[2]);
}

}

#endif
