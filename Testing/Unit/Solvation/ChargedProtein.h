/**
 * @file ChargedProtein.h
 * @brief A PQR file of the shared data as the input of a solvation surface.
 */
#ifndef isthmus_ChargedProtein_h
#define isthmus_ChargedProtein_h

#include "SharedData.h"
#include "Solvation/SolvationFlow.h"
#include "vtkMacromoleculeReader.h"

#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

namespace isthmus::testing
{

/// Its charges and radii; every atom attracts with a well of 0.1 kcal/mol.
inline SolvationAtoms ProteinAtoms(const std::string& relative)
{
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName((SharedDataFolder() / relative).string().c_str());
  reader->Update();
  vtkPolyData* const points = reader->GetOutput();
  vtkDataArray* const charges = points->GetPointData()->GetArray("Charge");
  vtkDataArray* const radii = points->GetPointData()->GetArray("Radius");
  SolvationAtoms atoms;
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    Point3 at;
    points->GetPoint(i, at.data());
    const double radius = radii->GetComponent(i, 0);
    atoms.Charges.push_back({ at, charges->GetComponent(i, 0), radius });
    if (radius > 0.0)
    {
      atoms.Balls.push_back({ at, radius });
      atoms.Dispersion.push_back({ at, radius, 0.1 });
    }
  }
  return atoms;
}

}

#endif
