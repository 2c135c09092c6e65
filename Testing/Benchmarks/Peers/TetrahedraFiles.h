/**
 * @file TetrahedraFiles.h
 * @brief Tetrahedral meshes with a value at each point, as input of other programs.
 *
 * Little-endian: 64-bit integers (magic 7453010314, number of points, number of tetrahedra), three
 * doubles for each point, a double for each point's value, four 64-bit ids from 0 for each
 * tetrahedron. It needs nothing but the standard library.
 */
#ifndef isthmus_TetrahedraFiles_h
#define isthmus_TetrahedraFiles_h

#include "DiphaFiles.h"

namespace isthmus::testing
{

struct ValuedTetrahedra
{
  std::vector<std::array<double, 3>> Points;
  std::vector<double> Values;
  std::vector<std::array<std::int64_t, 4>> Tetrahedra;
};

constexpr std::int64_t TetrahedraMagic = 7453010314;

inline void WriteTetrahedra(const std::string& name, const ValuedTetrahedra& mesh)
{
  std::ofstream file(name, std::ios::binary);
  const std::int64_t header[] = { TetrahedraMagic, static_cast<std::int64_t>(mesh.Points.size()),
    static_cast<std::int64_t>(mesh.Tetrahedra.size()) };
  WriteRaw(file, header, 3);
  WriteRaw(file, mesh.Points.data(), mesh.Points.size());
  WriteRaw(file, mesh.Values.data(), mesh.Values.size());
  WriteRaw(file, mesh.Tetrahedra.data(), mesh.Tetrahedra.size());
  if (!file.flush())
  {
    throw std::runtime_error(name + " cannot be written.");
  }
}

inline ValuedTetrahedra ReadTetrahedra(const std::string& name)
{
  std::ifstream file(name, std::ios::binary);
  std::int64_t header[3];
  ReadRaw(file, header, 3, name);
  if (header[0] != TetrahedraMagic)
  {
    throw std::runtime_error(name + " is no mesh of tetrahedra with values.");
  }
  ValuedTetrahedra mesh;
  mesh.Points.resize(static_cast<std::size_t>(header[1]));
  mesh.Values.resize(mesh.Points.size());
  mesh.Tetrahedra.resize(static_cast<std::size_t>(header[2]));
  ReadRaw(file, mesh.Points.data(), mesh.Points.size(), name);
  ReadRaw(file, mesh.Values.data(), mesh.Values.size(), name);
  ReadRaw(file, mesh.Tetrahedra.data(), mesh.Tetrahedra.size(), name);
  return mesh;
}

}

#endif
