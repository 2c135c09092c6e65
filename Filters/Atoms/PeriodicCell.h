/**
 * @file PeriodicCell.h
 * @brief The cell by whose vectors the atoms of a crystal or of a simulation repeat.
 */
#ifndef isthmus_PeriodicCell_h
#define isthmus_PeriodicCell_h

#include "Core/Geometry.h"
#include "vtkIsthmusFiltersAtomsModule.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

class vtkDataObject;

namespace isthmus
{

/// Whole cells along each vector.
using CellShift = std::array<int, 3>;

constexpr CellShift NoCellShift{ 0, 0, 0 };

inline CellShift Add(const CellShift& a, const CellShift& b)
{
  return { a[0] + b[0], a[1] + b[1], a[2] + b[2] };
}

inline CellShift Negative(const CellShift& a)
{
  return { -a[0], -a[1], -a[2] };
}

class PeriodicCell
{
public:
  /// Three vectors that are not in one plane.
  explicit PeriodicCell(const std::vector<Point3>& vectors)
    : Vectors(vectors)
  {
    const double volume = Dot(vectors[0], Cross(vectors[1], vectors[2]));
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Inverse.push_back((1.0 / volume) * Cross(vectors[(k + 1) % 3], vectors[(k + 2) % 3]));
    }
  }

  Point3 Fractions(const Point3& place) const
  {
    return { Dot(this->Inverse[0], place), Dot(this->Inverse[1], place),
      Dot(this->Inverse[2], place) };
  }

  Point3 Vector(const CellShift& shift) const
  {
    return shift[0] * this->Vectors[0] + shift[1] * this->Vectors[1] + shift[2] * this->Vectors[2];
  }

  const std::vector<Point3>& GetVectors() const { return this->Vectors; }

  double Volume() const
  {
    return std::fabs(Dot(this->Vectors[0], Cross(this->Vectors[1], this->Vectors[2])));
  }

  /// Distance of the faces that vector `k` joins.
  double Height(std::size_t k) const { return 1.0 / Length(this->Inverse[k]); }

  /// The shift of `to` by which it comes nearest to `from`, for points closer than half a cell.
  CellShift NearestImage(const Point3& from, const Point3& to) const
  {
    const Point3 f = this->Fractions(from - to);
    return { static_cast<int>(std::lround(f[0])), static_cast<int>(std::lround(f[1])),
      static_cast<int>(std::lround(f[2])) };
  }

private:
  std::vector<Point3> Vectors;
  std::vector<Point3> Inverse; ///< rows
};

/**
 * The periodic cell of the atoms: the field array `CellVectors` of vtkMacromoleculeReader. Adds a
 * warning to `warnings` where the field array `SpaceGroup` says that the atoms may be a part of the
 * cell only. Throws std::invalid_argument if there is no cell, or if it is flat.
 */
VTKISTHMUSFILTERSATOMS_EXPORT PeriodicCell ReadPeriodicCell(
  vtkDataObject* atoms, std::vector<std::string>& warnings);

}

#endif
