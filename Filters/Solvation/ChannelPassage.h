/**
 * @file ChannelPassage.h
 * @brief Determines whether a channel connects the two baths, and finds its bottleneck.
 *
 * The widest of all paths from bath to bath is the one whose smallest distance to atoms and
 * membrane is largest. The place with that distance is the bottleneck; if the distance is negative,
 * the channel is closed there.
 */
#ifndef isthmus_ChannelPassage_h
#define isthmus_ChannelPassage_h

#include "Solvation/TransportGrid.h"

namespace isthmus
{

struct ChannelPassage
{
  Point3 Bottleneck{ 0.0, 0.0, 0.0 };
  double Along = 0.0;  ///< of the bottleneck, from the membrane's center along its normal, angstrom
  double Radius = 0.0; ///< distance to the walls there, angstrom; negative: walls overlap
};

/// The bottleneck of the widest path, from node to node. O(n log n).
/// @throws std::runtime_error if the grid does not connect the baths at all.
ChannelPassage FindPassage(const TransportGrid& grid);

/// @throws std::runtime_error, with the place and what to do, where the channel is closed.
void RequireOpen(const ChannelPassage& passage);

/// True if water along the rim of the membrane's hole leads from one side of the membrane to the
/// other although the hole contains atoms: ions pass beside the molecule. O(n).
bool IsRimOpen(
  const TransportGrid& grid, const std::vector<Ball>& atoms, const MembraneSlab& membrane);

/// Closes the faces between nodes that are not connected to a bath by water, because the
/// concentrations of ions in such pockets are undetermined.
/// @throws std::runtime_error if no remaining faces connect the baths.
void CloseIsolatedPockets(TransportGrid& grid);

}

#endif
