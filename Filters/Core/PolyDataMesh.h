/**
 * @file PolyDataMesh.h
 * @brief From vtkPolyData to a TriangleMesh that is to be mended or changed, and back.
 */
#ifndef isthmus_PolyDataMesh_h
#define isthmus_PolyDataMesh_h

#include "Core/SurfaceView.h"
#include "vtkIsthmusFiltersCoreModule.h"

#include <vtkPolyData.h>

namespace isthmus
{

/// The triangles of `surface` as PolyDataTriangles makes them, damage kept: for what looks for it
/// (SurfaceCheck.h) or mends it.
/// @throws std::invalid_argument, with the cell, for a corner that is no point, where some cells
/// are not triangles.
VTKISTHMUSFILTERSCORE_EXPORT TriangleMesh MeshOf(vtkPolyData* surface);

/// Makes `surface` the points (double) and triangles of `mesh`.
VTKISTHMUSFILTERSCORE_EXPORT void SetMesh(const SurfaceView& mesh, vtkPolyData* surface);

}

#endif
