/**
 * @file ChannelPassage.h
 * @brief Whether water leads from bath to bath, and where the way is narrowest.
 *
 * Of all ways from bath to bath, the widest is the one whose least distance to atoms and membrane
 * is greatest. Where that is, is the bottleneck; where even there the distance is negative, the
 * channel is closed, and that is the place where it closes.
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

/// The widest way, from node to node. O(n log n).
/// @throws std::runtime_error where the grid does not lead from bath to bath at all.
VTKISTHMUSFILTERSSOLVATION_EXPORT ChannelPassage FindPassage(const TransportGrid& grid);

/// @throws std::runtime_error, with the place and what to do, where the way is closed.
VTKISTHMUSFILTERSSOLVATION_EXPORT void DemandOpen(const ChannelPassage& passage);

/// Closes the faces between nodes that no water connects to a bath: nothing says what ions are in
/// such pockets.
/// @throws std::runtime_error where none are left that lead from bath to bath.
VTKISTHMUSFILTERSSOLVATION_EXPORT void ClosePockets(TransportGrid& grid);

}

#endif
