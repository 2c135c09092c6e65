/**
 * @file StarMatching.h
 * @brief The best matching of every lower star that can occur on a grid, each computed once.
 */
#ifndef isthmus_StarMatching_h
#define isthmus_StarMatching_h

#include "Core/Handles.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// A cell of the star of a node, given by its number in the star.
using StarCell = Handle<struct StarCellKind, int>;

/**
 * The cells around a node, numbered 0-5 (edges), 6-17 (faces), 18-25 (cubes); 26 is the node.
 *
 * These are also the numbers of the bits in a star mask. A star is closed: a face is in it only
 * with its edges.
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
extern const std::array<std::uint8_t, 27> GetCellId;
/// Direction of a cell.
extern const std::array<std::int8_t, 27> DirectionOf;
/// The two edges of a face, at [face - FirstFace]: along its first and its second axis.
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

/// The matching of one kind of lower star.
struct StarMatching
{
  /// The cell with which it is matched, the cell itself if it is critical, or Star::Absent if it is
  /// not in the star.
  std::array<std::uint8_t, 27> Partner;
  /// Bits of the critical cells.
  std::uint32_t Critical = 0;
  /// Bits of the edges that are matched with a face.
  std::uint32_t EdgesWithFaces = 0;
  /// Vertices - edges + faces - cubes.
  int EulerNumber = 0;
};

/**
 * Matches the cells of the star by simple expansions; if none is possible, a cell of the lowest
 * dimension becomes critical (V. Robins, P. J. Wood, A. P. Sheppard, IEEE Trans. PAMI 33, 2011).
 * The link of the star is a part of the surface of an octahedron, for which this is optimal in any
 * order: the number of critical cells equals the number of classes that appear or end with the
 * node.
 */
StarMatching MatchStar(std::uint32_t mask);

}

#endif
