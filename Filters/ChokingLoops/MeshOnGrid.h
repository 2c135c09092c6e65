/**
 * @file MeshOnGrid.h
 * @brief A TriangleMesh as the algorithms on grids see it.
 */
#ifndef isthmus_MeshOnGrid_h
#define isthmus_MeshOnGrid_h

#include "SurfaceCrossings.h"
#include "TriangleMesh.h"

#include <vector>

namespace isthmus
{

/// Copy of a mesh with coordinates from the grid's first node, and ids of VTK's type.
class MeshOnGrid
{
public:
  MeshOnGrid(const TriangleMesh& mesh, const Point3& origin)
  {
    this->Points.reserve(3 * mesh.Points.size());
    for (const Point3& p : mesh.Points)
    {
      const Point3 local = p - origin;
      this->Points.insert(this->Points.end(), local.begin(), local.end());
    }
    this->Corners.reserve(3 * mesh.Triangles.size());
    for (const isthmus::Triangle& t : mesh.Triangles)
    {
      this->Corners.insert(this->Corners.end(), t.begin(), t.end());
    }
  }

  SurfaceView View() const
  {
    return { this->Points.data(), static_cast<vtkIdType>(this->Points.size() / 3),
      this->Corners.data(), static_cast<vtkIdType>(this->Corners.size() / 3) };
  }

private:
  std::vector<double> Points;
  std::vector<vtkIdType> Corners;
};

inline GridShape ShapeOf(const DistanceGrid& grid)
{
  return { grid.Dimensions, { grid.Spacing, grid.Spacing, grid.Spacing } };
}

}

#endif
