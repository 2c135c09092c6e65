/**
 * @file TransportGrid.h
 * @brief A channel in a membrane between two baths: the domain, and finite volumes around the nodes
 * of a grid.
 *
 * The domain is a cylinder around the channel's axis (through the membrane's center, along its
 * normal) that contains all atoms with a margin on all sides. The grid is the box around it, turned
 * so that one of its axes is the normal: the baths begin at planes of nodes, and the current does
 * not depend on how molecule and membrane lie in space. A node is in the membrane's center, and a
 * layer of nodes beyond the cylinder. The baths are beyond the flat ends of the
 * cylinder; its side is impermeable. Inside, atoms and membrane are one region, and the rest is
 * water.
 *
 * Nodes have cubes of one spacing around them. The fraction of each face that is water is computed
 * from the signed distance, which is assumed to be linear there. Thus walls lie between the nodes,
 * and the area of a pore is second order. Cubes whose node is not in the water are merged with
 * neighbours whose node is. The permittivity of an edge is that of its parts in the water and in
 * the atoms in series, or the mean of lines along it over its face: PermittivityMean.
 */
#ifndef isthmus_TransportGrid_h
#define isthmus_TransportGrid_h

#include "Atoms/Ball.h"
#include "Core/Progress.h"
#include "Solvation/IonTransportParameters.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// Position and size of the domain, before anything is computed on it.
struct TransportDomain
{
  std::array<std::int64_t, 3> Dimensions{ 0, 0, 0 };
  Point3 Origin{ 0.0, 0.0, 0.0 }; ///< of the first node
  double Spacing = 1.0;
  /// Unit vectors along the axes of the grid; one of them is the normal or its opposite.
  std::array<Point3, 3> Axes{ { { 1.0, 0.0, 0.0 }, { 0.0, 1.0, 0.0 }, { 0.0, 0.0, 1.0 } } };
  Point3 Center{ 0.0, 0.0, 0.0 };
  Point3 Normal{ 0.0, 0.0, 1.0 }; ///< of length 1
  double Radius = 0.0;            ///< of the cylinder
  double HalfLength = 0.0;        ///< from the center to the baths, whole spacings

  std::int64_t Size() const
  {
    return this->Dimensions[0] * this->Dimensions[1] * this->Dimensions[2];
  }
  std::array<std::int64_t, 3> Steps() const
  {
    return { 1, this->Dimensions[0], this->Dimensions[0] * this->Dimensions[1] };
  }
  std::array<std::int64_t, 3> Indices(std::int64_t node) const
  {
    const auto& n = this->Dimensions;
    return { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
  }
  Point3 Place(std::int64_t node) const
  {
    const std::array<std::int64_t, 3> at = this->Indices(node);
    const double h = this->Spacing;
    const Point3 turned = this->Turned({ h * static_cast<double>(at[0]),
      h * static_cast<double>(at[1]), h * static_cast<double>(at[2]) });
    return { this->Origin[0] + turned[0], this->Origin[1] + turned[1],
      this->Origin[2] + turned[2] };
  }
  /// A vector along the axes of the grid in world coordinates.
  Point3 Turned(const Point3& vector) const;
  /// A place relative to the first node along the axes of the grid, in angstrom.
  Point3 InAxes(const Point3& place) const;
  /// Coordinates of a place: along the axis, from the center of the membrane, and its distance from
  /// the axis.
  std::array<double, 2> AxialAndRadial(const Point3& place) const;
};

/// @throws std::invalid_argument for parameters out of range, std::runtime_error with the size
/// if there is not enough memory for it.
TransportDomain DomainAround(
  const std::vector<Ball>& atoms, const IonTransportParameters& parameters);

/// The distance from each node to the solvent-excluded surface of atoms
/// (SolventExcludedSurface.h), or for ProbeRadius 0 to the atoms, in angstrom, negative inside, and
/// clamped to 4.5 spacings. Parallel.
/// @throws Cancelled.
std::vector<float> DistanceToAtoms(const TransportDomain& domain, const std::vector<Ball>& atoms,
  double probeRadius, const ProgressCallback& progress = {});

/// Spacings by which the membrane is enlarged, so that nodes on its walls are in the membrane
/// despite rounding on a rotated grid.
constexpr double MembraneExcess = 1e-6;

/// The bath to which a node belongs.
enum class Bath : unsigned char
{
  None = 0,
  Below = 1,
  Above = 2
};

/// The mean over faces avoids steps of the walls along the grid: the current depends less on how
/// the channel is turned about its axis. The potential at nodes next to a wall, and so the force
/// that is fitted to it (WallForce.h), is more accurate with the permittivity of the edge alone.
enum class PermittivityMean
{
  OverFace,
  AlongEdge
};

/// 50 bytes per node.
struct TransportGrid
{
  TransportDomain Domain;
  std::vector<float> Distance; ///< to atoms and membrane, angstrom, negative within
  std::vector<float> Along;    ///< of TransportDomain::AxialAndRadial
  /// Of edges from a node to the next: permittivity times the part of the face in the domain, and
  /// the part of it that is water, including the water of closed cubes beside it (so it may be
  /// above 1). 0 where there is no next node, or one of the two is not in the water.
  std::array<std::vector<float>, 3> Permittivity, Aperture;
  std::vector<float> Water;         ///< the part of a node's cube that ions fill, likewise
  std::vector<unsigned char> Baths; ///< Bath of each node
  std::vector<double> Charge;       ///< e
};

/// `solute` are distances as of DistanceToAtoms(), or nothing where there is a
/// membrane only; charges are spread over eight nodes each. O(nodes). Parallel.
/// @throws Cancelled.
TransportGrid MakeTransportGrid(const TransportDomain& domain, const std::vector<float>& solute,
  const std::vector<ChargedAtom>& charges, const IonTransportParameters& parameters,
  PermittivityMean permittivity = PermittivityMean::OverFace,
  const ProgressCallback& progress = {});

/// The fraction of a unit square on which distance + g1 u + g2 v is positive, with u and v in
/// [-1/2, 1/2].
double PositiveFraction(double distance, double g1, double g2);

}

#endif
