/**
 * @file TetrahedralChecks.h
 * @brief Properties of tetrahedral meshes that tests check: volumes, faces, angles.
 */
#ifndef isthmus_TetrahedralChecks_h
#define isthmus_TetrahedralChecks_h

#include "Core/Geometry.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "Tetrahedra/MeshQuality.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <set>

namespace isthmus::testing
{

inline double ComputeVolume(const TetrahedralMesh& mesh, std::size_t i)
{
  const Tetrahedron& t = mesh.Tetrahedra[i];
  const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
  return Dot(Cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) / 6.0;
}

/// Volume of each region.
inline std::map<int, double> ComputeVolumes(const TetrahedralMesh& mesh)
{
  std::map<int, double> sum;
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    sum[mesh.Regions[i]] += ComputeVolume(mesh, i);
  }
  return sum;
}

inline QualitySummary MeasureQualityRange(const TetrahedralMesh& mesh)
{
  std::vector<CellAngles> cells;
  return MeasureQuality(mesh.Points, mesh.Tetrahedra, 18, cells);
}

struct FaceCounts
{
  std::set<Triangle> Skin;      ///< faces, sorted, of one tetrahedron
  std::set<Triangle> Interface; ///< between two of different regions
  std::int64_t Crowded = 0;     ///< faces of more than two
};

inline FaceCounts CountFaces(const TetrahedralMesh& mesh)
{
  std::map<Triangle, std::vector<int>> regions;
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    const Tetrahedron& t = mesh.Tetrahedra[i];
    for (std::size_t c = 0; c < 4; ++c)
    {
      Triangle face{ t[(c + 1) % 4], t[(c + 2) % 4], t[(c + 3) % 4] };
      std::sort(face.begin(), face.end());
      regions[face].push_back(mesh.Regions[i]);
    }
  }
  FaceCounts counts;
  for (const auto& [face, sides] : regions)
  {
    if (sides.size() == 1)
    {
      counts.Skin.insert(face);
    }
    counts.Crowded += sides.size() > 2 ? 1 : 0;
    if (sides.size() == 2 && sides[0] != sides[1])
    {
      counts.Interface.insert(face);
    }
  }
  return counts;
}

inline Bounds3 ComputeBounds(const TetrahedralMesh& mesh)
{
  Bounds3 bounds{ mesh.Points.at(0), mesh.Points.at(0) };
  for (const Point3& p : mesh.Points)
  {
    bounds.Add(p);
  }
  return bounds;
}

}

#endif
