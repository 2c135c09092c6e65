/**
 * @file MeshedSpheres.h
 * @brief Spheres to mesh, the limits to do that under, and the volume that came out.
 */
#ifndef isthmus_MeshedSpheres_h
#define isthmus_MeshedSpheres_h

#include "Core/PolyDataTriangles.h"
#include "Tetrahedra/AutomaticMesher.h"
#include "TetrahedralChecks.h"

#include <vtkNew.h>
#include <vtkSphereSource.h>

namespace isthmus::testing
{

inline TriangleMesh Sphere(const Point3& centre, double radius, int resolution = 20)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(centre[0], centre[1], centre[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return MeshOf(source->GetOutput());
}

inline TetrahedralParameters Limited()
{
  TetrahedralParameters parameters;
  parameters.TetGen.Limits = { 240.0, std::uint64_t{ 4 } << 30 };
  return parameters;
}

inline double Solids(const TetrahedralMesh& mesh)
{
  double sum = 0.0;
  for (const auto& [region, volume] : VolumesOf(mesh))
  {
    sum += region > 0 ? volume : 0.0;
  }
  return sum;
}

}

#endif
