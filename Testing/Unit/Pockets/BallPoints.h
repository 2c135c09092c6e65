/**
 * @file BallPoints.h
 * @brief Balls as points, the input of filters of molecules.
 */
#ifndef isthmus_BallPoints_h
#define isthmus_BallPoints_h

#include "Atoms/Ball.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace isthmus::testing
{

/// A point for each ball with its `Radius`, both of `type`.
inline vtkSmartPointer<vtkPolyData> MakeAtoms(const std::vector<Ball>& balls, int type = VTK_DOUBLE)
{
  auto atoms = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataType(type);
  const auto radii = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  radii->SetName("Radius");
  for (const Ball& ball : balls)
  {
    points->InsertNextPoint(ball.Center.data());
    radii->InsertNextTuple(&ball.Radius);
  }
  atoms->SetPoints(points);
  atoms->GetPointData()->AddArray(radii);
  return atoms;
}

}

#endif
