/**
 * @file PolyDataMesh.h
 * @brief Between vtkPolyData and TriangleMesh, for all vtk classes that make or take surfaces.
 */
#ifndef isthmus_PolyDataMesh_h
#define isthmus_PolyDataMesh_h

#include "SurfaceView.h"
#include "TriangleMesh.h"
#include "vtkIsthmusModule.h"

#include <vtkPolyData.h>

namespace isthmus
{

/// The polygons and strips of `surface` as triangles (vtkTriangleFilter where they are not), with
/// all its points in their order. Vertices and lines are left out. Triangles are not checked: for
/// what checks (SurfaceCheck.h) or mends the mesh itself.
/// @throws std::invalid_argument, with the polygon, for a corner that is no point.
VTKISTHMUS_EXPORT TriangleMesh MeshOf(vtkPolyData* surface);

/// The same of a surface whose corners and points PolyDataTriangles found to be sound.
VTKISTHMUS_EXPORT TriangleMesh MeshOf(const SurfaceView& surface);

/// Makes `surface` the points (double) and triangles of `mesh`.
VTKISTHMUS_EXPORT void SetMesh(const TriangleMesh& mesh, vtkPolyData* surface);

}

#endif
