/**
 * @file ChargedPoints.h
 * @brief Atoms with radii, charges and well depths as the filters of Solvation take them.
 */
#ifndef isthmus_ChargedPoints_h
#define isthmus_ChargedPoints_h

#include "BallPoints.h"

#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace isthmus::testing
{

/// Points with `Radius`, `Charge` (e) and `WellDepth` (kcal/mol).
inline vtkSmartPointer<vtkPolyData> ChargedPoints(
  const std::vector<Ball>& balls, const std::vector<double>& charges, double depth)
{
  auto atoms = MakeAtoms(balls);
  vtkNew<vtkDoubleArray> charge, wellDepth;
  charge->SetName("Charge");
  wellDepth->SetName("WellDepth");
  for (const double value : charges)
  {
    charge->InsertNextValue(value);
    wellDepth->InsertNextValue(depth);
  }
  atoms->GetPointData()->AddArray(charge);
  atoms->GetPointData()->AddArray(wellDepth);
  return atoms;
}

}

#endif
