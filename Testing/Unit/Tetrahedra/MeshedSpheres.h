/**
 * @file MeshedSpheres.h
 * @brief The limits under which spheres are meshed, and the resulting volume.
 */
#ifndef isthmus_MeshedSpheres_h
#define isthmus_MeshedSpheres_h

#include "SphereMesh.h"
#include "Tetrahedra/AutomaticMesher.h"
#include "TetrahedralChecks.h"

namespace isthmus::testing
{

inline TetrahedralParameters LimitedParameters()
{
  TetrahedralParameters parameters;
  parameters.TetGen.Limits = { 240.0, std::uint64_t{ 4 } << 30 };
  return parameters;
}

inline double Solids(const TetrahedralMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [region, volume] : ComputeVolumes(mesh))
  {
    sum += region > 0 ? volume : 0.0;
  }
  return sum;
}

}

#endif
