/**
 * @file MesherTrial.h
 * @brief The input of a mesher, its messages, and the volumes it fills.
 */
#ifndef isthmus_MesherTrial_h
#define isthmus_MesherTrial_h

#include "Tetrahedra/TetrahedralMesher.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <map>
#include <string>

namespace isthmus::testing
{

inline double Volume(const TetrahedralMesh& mesh, std::size_t i)
{
  const Tetrahedron& t = mesh.Tetrahedra[i];
  const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
  return Dot(Cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) / 6.0;
}

inline std::map<int, double> Volumes(const TetrahedralMesh& mesh)
{
  std::map<int, double> sum;
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    EXPECT_GE(Volume(mesh, i), 0.0);
    sum[mesh.Regions[i]] += Volume(mesh, i);
  }
  return sum;
}

inline std::string CatchMessage(const TriangleMesh& mesh, const TetrahedralParameters& parameters)
{
  try
  {
    MeshTetrahedra(mesh, parameters);
  }
  catch (const std::exception& error)
  {
    return error.what();
  }
  return {};
}

inline TetrahedralParameters With(TetrahedralLibrary library, MeshedSide side)
{
  TetrahedralParameters parameters;
  parameters.Library = library;
  parameters.Side = side;
  parameters.TetGen.Limits = { 60.0, std::uint64_t{ 4 } << 30 };
  return parameters;
}

}

#endif
