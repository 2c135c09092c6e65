/**
 * @file TetrahedronWays.h
 * @brief The ways from tetrahedron to tetrahedron around a vertex, as small tables.
 *
 * A spoke is a dart that starts at the vertex. The three faces at the vertex are told by a spoke's
 * local dart, and the spoke beyond a face by the local dart that the table H2D of the map gives
 * there: beta1 of beta3, as CellType has them.
 */
#ifndef isthmus_TetrahedronWays_h
#define isthmus_TetrahedronWays_h

#include "CellComplex/CellType.h"

#include <array>
#include <cstdint>

namespace isthmus
{

struct TetrahedronWays
{
  /// A face at the vertex; `Position` is that of the spoke within it, as StarWalk crosses it.
  struct Way
  {
    std::uint8_t Face = 0, Position = 0;
  };

  static constexpr unsigned Darts = 13; ///< local ones; 0: outside

  /// By spoke, the face of the spoke itself first, else in the order of its vertex' darts.
  std::array<std::array<Way, 3>, Darts> Onward;
  std::array<std::array<std::uint8_t, 3>, Darts> Spoke; ///< by dart across and position

  TetrahedronWays()
    : Onward{}
    , Spoke{}
  {
    const CellType& type = CellType::Tetrahedron();
    for (unsigned dart = 1; dart < Darts; ++dart)
    {
      const CellType::Dart& spoke = type.At(dart);
      for (unsigned i = 0, next = 1; i < 3; ++i)
      {
        const CellType::Dart& local = type.At(type.VertexDart(spoke.Start, i));
        const Way way{ static_cast<std::uint8_t>(local.Face),
          static_cast<std::uint8_t>(local.Position) };
        this->Onward[dart][local.Face == spoke.Face ? 0 : next++] = way;
        this->Spoke[dart][i] = static_cast<std::uint8_t>(type.At(type.Back(dart, i)).Next);
      }
    }
  }
};

}

#endif
