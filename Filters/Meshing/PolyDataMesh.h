/**
 * @file PolyDataMesh.h
 * @brief Between vtkPolyData and TriangleMesh, for the vtk classes of this room.
 */
#ifndef isthmus_PolyDataMesh_h
#define isthmus_PolyDataMesh_h

#include "TriangleMesh.h"
#include "vtkIsthmusModule.h"

#include <vtkPolyData.h>

namespace isthmus
{

/// The polygons and strips of `surface` as triangles (vtkTriangleFilter where they are not), with
/// all its points in their order. Vertices and lines are left out.
VTKISTHMUS_EXPORT TriangleMesh MeshOf(vtkPolyData* surface);

/// Makes `surface` the points (double) and triangles of `mesh`.
VTKISTHMUS_EXPORT void SetMesh(const TriangleMesh& mesh, vtkPolyData* surface);

}

#endif
