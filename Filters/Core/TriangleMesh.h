/**
 * @file TriangleMesh.h
 * @brief Triangle surfaces: an owning type, which functions that change a surface take and return,
 * and a view, which functions that only read a surface take.
 */
#ifndef isthmus_TriangleMesh_h
#define isthmus_TriangleMesh_h

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/View.h"

#include <vtkType.h>

#include <algorithm>
#include <array>
#include <vector>

namespace isthmus
{

/// A triangle, given by the ids of its corners.
using Triangle = std::array<vtkIdType, 3>;

/// Indexed triangles, counter-clockwise seen from outside. Lengths are in the units of the data
/// (angstrom for molecular surfaces).
struct TriangleMesh
{
  std::vector<Point3> Points;
  std::vector<Triangle> Triangles;
};

/**
 * Non-owning view of a triangle surface, to which a TriangleMesh converts implicitly at no cost.
 * Code that reads a surface takes `const SurfaceView&`, and stores a copy of the view if it needs
 * to. Code that changes a surface takes and returns a TriangleMesh.
 *
 * Triangles are counter-clockwise seen from outside. Lengths are in the units of the data (angstrom
 * for molecular surfaces). Unless an algorithm states that it checks for defects itself, every
 * corner id lies in [0, NumberOfPoints()) and all coordinates of points that triangles use are
 * finite: PolyDataTriangles ensures both.
 */
struct SurfaceView
{
  SurfaceView() = default;
  SurfaceView(const isthmus::View<Point3>& points, const isthmus::View<Triangle>& triangles)
    : Points(points)
    , Triangles(triangles)
  {
  }
  /// @pre `mesh` outlives the view, and its vectors do not change.
  SurfaceView(const TriangleMesh& mesh)
    : Points(mesh.Points)
    , Triangles(mesh.Triangles)
  {
  }

  vtkIdType NumberOfPoints() const { return static_cast<vtkIdType>(this->Points.size()); }
  vtkIdType NumberOfTriangles() const { return static_cast<vtkIdType>(this->Triangles.size()); }
  const Point3& Point(vtkIdType point) const { return this->Points[At(point)]; }
  const Triangle& Corners(vtkIdType triangle) const { return this->Triangles[At(triangle)]; }

  View<Point3> Points;
  View<Triangle> Triangles;
};

/// A copy, for code that changes a surface given as a view.
inline TriangleMesh CopyMesh(const SurfaceView& surface)
{
  return { { surface.Points.begin(), surface.Points.end() },
    { surface.Triangles.begin(), surface.Triangles.end() } };
}

/// The points of `surface` relative to `origin`, for algorithms on a grid that begins there.
/// Together with the triangles of `surface` they form a view again.
inline std::vector<Point3> TranslatedPoints(const Point3& origin, const SurfaceView& surface)
{
  std::vector<Point3> points(surface.Points.size());
  std::transform(surface.Points.begin(), surface.Points.end(), points.begin(),
    [&origin](const Point3& p) { return p - origin; });
  return points;
}

inline double SurfaceArea(const SurfaceView& surface)
{
  double sum = 0.0;
  for (const Triangle& t : surface.Triangles)
  {
    sum += TriangleArea(surface.Point(t[0]), surface.Point(t[1]), surface.Point(t[2]));
  }
  return sum;
}

}

#endif
