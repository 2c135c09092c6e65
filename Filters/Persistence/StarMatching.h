/**
 * @file StarMatching.h
 * @brief The best matching of every lower star that can occur on a grid, each made once.
 */
#ifndef isthmus_StarMatching_h
#define isthmus_StarMatching_h

#include "Core/Handles.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// A cell of the star of a node by its number there.
using StarCell = Handle<struct StarCellKind, int>;

/**
 * The cells round a node, numbered 0-5 (edges), 6-17 (faces), 18-25 (cubes); 26 is the node.
 *
 * Bits of a star mask have these numbers. A star is closed: a face is in it only with its edges.
 */
namespace Star
{
constexpr int Node = 26;
constexpr int FirstFace = 6;
constexpr int FirstCube = 18;
constexpr std::uint8_t Absent = 255;

/// Step from the node to the opposite corner, by cell.
extern const std::array<std::array<int, 3>, 27> Steps;
/// Cell of a direction (see CubicalCell): inverse of Steps.
extern const std::array<std::uint8_t, 27> CellOf;
/// Direction of a cell.
extern const std::array<std::int8_t, 27> DirectionOf;
/// The two edges of a face, [face - FirstFace]: along its first and its second axis.
extern const std::array<std::array<std::uint8_t, 2>, 12> FaceEdges;
/// Faces that a star with these edges can have, as bits of a star mask.
extern const std::array<std::uint32_t, 64> FacesOfEdges;
/// Cubes that a star with these faces can have, as bits of a star mask.
extern const std::array<std::uint32_t, 4096> CubesOfFaces;

/// 0 to 3.
constexpr int Dimension(int cell)
{
  return cell == Node ? 0 : cell < FirstFace ? 1 : cell < FirstCube ? 2 : 3;
}
}

/// What happens in one kind of lower star.
struct StarMatching
{
  /// The cell it is matched with; the cell itself: critical; Star::Absent: not in the star.
  std::array<std::uint8_t, 27> Partner;
  /// Bits of the critical cells.
  std::uint32_t Critical = 0;
  /// Bits of the edges that are matched with a face.
  std::uint32_t EdgesWithFaces = 0;
  /// Vertices - edges + faces - cubes.
  int EulerNumber = 0;
};

/**
 * Matches the cells of the star by simple expansions, a critical cell of the lowest dimension where
 * none is possible (V. Robins, P. J. Wood, A. P. Sheppard, IEEE Trans. PAMI 33, 2011). The link of
 * the star is a part of the octahedron's surface, where this is optimal whatever the order: the
 * critical cells are as many as the classes that come or go with the node.
 */
StarMatching MatchStar(std::uint32_t mask);

}

#endif
