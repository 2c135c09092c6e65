/**
 * @file SphereMesh.h
 * @brief VTK's sphere as a mesh.
 */
#ifndef isthmus_SphereMesh_h
#define isthmus_SphereMesh_h

#include "Core/PolyDataTriangles.h"

#include <vtkNew.h>
#include <vtkSphereSource.h>

namespace isthmus::testing
{

inline TriangleMesh Sphere(const Point3& center, double radius, int resolution = 20)
{
  vtkNew<vtkSphereSource> source;
  source->SetCenter(center[0], center[1], center[2]);
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  return ToTriangleMesh(source->GetOutput());
}

}

#endif
