/**
 * @file ChannelPassage.h
 * @brief Whether a channel connects the two baths, and its bottleneck.
 *
 * Of all paths from bath to bath, the widest is the one whose least distance to atoms and membrane
 * is greatest. The place of that distance is the bottleneck; where it is negative, the channel is
 * closed there.
 */
#ifndef isthmus_ChannelPassage_h
#define isthmus_ChannelPassage_h

#include "Solvation/TransportGrid.h"
#include "vtkIsthmusFiltersSolvationModule.h"

namespace isthmus
{

struct ChannelPassage
{
  Point3 Bottleneck{ 0.0, 0.0, 0.0 };
  double Along = 0.0;  ///< of the bottleneck, from the membrane's centre along its normal, angstrom
  double Radius = 0.0; ///< distance to the walls there, angstrom; negative: walls overlap
};

/// The bottleneck of the widest path, from node to node. O(n log n).
/// @throws std::runtime_error where the grid does not lead from bath to bath at all.
VTKISTHMUSFILTERSSOLVATION_EXPORT ChannelPassage FindPassage(const TransportGrid& grid);

/// @throws std::runtime_error, with the place and what to do, where the channel is closed.
VTKISTHMUSFILTERSSOLVATION_EXPORT void RequireOpen(const ChannelPassage& passage);

/// Closes the faces between nodes that no water connects to a bath: the concentrations of ions in
/// such pockets are undetermined.
/// @throws std::runtime_error where none are left that lead from bath to bath.
VTKISTHMUSFILTERSSOLVATION_EXPORT void CloseIsolatedPockets(TransportGrid& grid);

}

#endif
