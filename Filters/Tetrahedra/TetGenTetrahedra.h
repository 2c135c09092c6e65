/**
 * @file TetGenTetrahedra.h
 * @brief The text files through which we talk with TetGen's program.
 */
#ifndef isthmus_TetGenTetrahedra_h
#define isthmus_TetGenTetrahedra_h

#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "Surfaces/ShellNesting.h"

#include <filesystem>

namespace isthmus
{

/// Writes points, triangles, a hole for each of `holes` and a region for each of `regions` (its
/// place in the list, from 1, being its attribute) as TetGen's .smesh, all digits kept.
void WriteTetGenSurface(const std::filesystem::path& file, const std::vector<SurfaceView>& surfaces,
  const std::vector<SpaceRegion>& holes, const std::vector<SpaceRegion>& regions);

/// Reads NAME.1.node and NAME.1.ele; Regions holds the attributes as they are.
/// @throws std::runtime_error when one is missing or ends early.
TetrahedralMesh ReadTetGenMesh(const std::filesystem::path& folder, const std::string& name);

}

#endif
