/**
 * @file TransportGrid.h
 * @brief A channel in a membrane between two baths, as finite volumes around the nodes of a grid.
 *
 * The domain is a cylinder around the channel's axis (through the membrane's centre, along its
 * normal), so that nothing depends on how these lie to the grid. Beyond its flat ends are the
 * baths, its side lets nothing through. In it, atoms and membrane are one region, water the rest.
 *
 * Nodes have cubes of one spacing around them. The part of each face that is water comes from the
 * signed distance, taken as linear there, so walls lie between the nodes: the area of a pore is
 * second order. Cubes whose node is not in the water are merged with neighbours that are. The
 * permittivity of an edge is that of its two parts in series (smeared over the surface instead, it
 * was 14 to 35 % off for a Born ion).
 */
#ifndef isthmus_TransportGrid_h
#define isthmus_TransportGrid_h

#include "Solvation/TransportDomain.h"
#include "vtkIsthmusFiltersSolvationModule.h"

namespace isthmus
{

/// Which bath a node belongs to.
enum class Bath : unsigned char
{
  None = 0,
  Below = 1,
  Above = 2
};

/// 50 bytes a node.
struct TransportGrid
{
  TransportDomain Domain;
  std::vector<float> Distance; ///< to atoms and membrane, angstrom, negative within
  std::vector<float> Along;    ///< of TransportDomain::AlongAndOff
  /// Of edges from a node to the next: permittivity times the part of the face in the domain, and
  /// the part of it that is water, with what was closed beside it (so it may be above 1). 0 where
  /// there is no next node, or one of the two is not in the water.
  std::array<std::vector<float>, 3> Permittivity, Aperture;
  std::vector<float> Water;         ///< the part of a node's cube that ions fill, likewise
  std::vector<unsigned char> Baths; ///< Bath of each node
  std::vector<double> Charge;       ///< e
};

/// `solute` are distances as of DistanceToAtoms() (TransportDomain.h), or nothing where there is a
/// membrane only; charges are spread over eight nodes each. O(nodes). Parallel.
/// @throws Cancelled.
VTKISTHMUSFILTERSSOLVATION_EXPORT TransportGrid MakeTransportGrid(const TransportDomain& domain,
  const std::vector<float>& solute, const std::vector<ChargedAtom>& charges,
  const IonTransportParameters& parameters, const ProgressCallback& progress = {});

/// The part of a unit square on which distance + g1 u + g2 v is positive, u and v in [-1/2, 1/2].
VTKISTHMUSFILTERSSOLVATION_EXPORT double PositivePart(double distance, double g1, double g2);

}

#endif
