/**
 * @file VTKVersions.h
 * @brief The only file that depends on VTK's version, for functions without a common call in all
 * versions from that of ParaView 5.11 to the newest.
 */
#ifndef isthmus_VTKVersions_h
#define isthmus_VTKVersions_h

#include <vtkVersionMacros.h>

#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
#include <vtkMarchingCellsContourCases.h>
#else
#include <vtkMarchingCubesTriangleCases.h>
#endif

#include <cstdint>

namespace isthmus
{

/// The triangles of a case of marching cubes, each given by three edges of vtkHexahedron, with -1
/// after the last. Bit k of `cell` is set if its k-th corner is above the level.
inline const int* MarchingCubesCase(std::uint8_t cell)
{
#if VTK_VERSION_NUMBER >= VTK_VERSION_CHECK(9, 7, 0)
  return vtkMarchingCellsContourCases::GetHexahedronCase(cell);
#else
  return vtkMarchingCubesTriangleCases::GetCases()[cell].edges;
#endif
}

}

#endif
