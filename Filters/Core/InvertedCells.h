/**
 * @file InvertedCells.h
 * @brief Finds the cells of a volume mesh whose corners are ordered opposite to the others.
 */
#ifndef isthmus_InvertedCells_h
#define isthmus_InvertedCells_h

#include "Core/Geometry.h"

#include "vtkIsthmusFiltersCoreModule.h" // for the export macro

#include <vtkType.h>

#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

/// Six times the signed volume of a tetrahedron, (p1-p0)x(p2-p0).(p3-p0).
inline double SixSignedVolumes(
  const Point3& p0, const Point3& p1, const Point3& p2, const Point3& p3)
{
  return Dot(Cross(p1 - p0, p2 - p0), p3 - p0);
}

/**
 * Finds the cells of a mesh that are inverted: ordered opposite to the other cells, as where a mesh
 * overlaps itself. Whether the mesh as a whole follows VTK's order or the opposite one does not
 * matter: the sign of its total volume decides.
 */
class VTKISTHMUSFILTERSCORE_EXPORT InvertedCells
{
public:
  /// Adds a cell with its signed volume, in any unit.
  void Add(vtkIdType cell, double signedVolume);

  /// Number of inverted cells.
  std::int64_t Count() const;
  /// Total volume, each inverted cell counted as negative; not below 0.
  double Volume() const;
  /// A warning with number and ids of inverted cells; empty if there are none.
  std::string Message() const;

private:
  static constexpr std::size_t Named = 5; ///< ids in the message

  struct Side
  {
    std::int64_t Count = 0;
    std::vector<vtkIdType> First;
  };

  const Side& Minority() const;

  double Sum = 0.0;
  Side Positive, Negative;
};

}

#endif
