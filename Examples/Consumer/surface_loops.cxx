// surface_loops SURFACE.vtp: handles, tunnels and bottlenecks of a closed surface, and their radii.

#include <vtkAbstractArray.h>
#include <vtkCellData.h>
#include <vtkChokingLoops.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkVariant.h>
#include <vtkXMLPolyDataReader.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    std::cerr << "usage: surface_loops SURFACE.vtp\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkChokingLoops> loops;
  loops->SetInputConnection(reader->GetOutputPort());
  loops->SetMinimumPersistence(5); // percent
  loops->Update();

  vtkCellData* cells = loops->GetOutput()->GetCellData();
  vtkDataArray* radius = cells->GetArray("Radius");
  vtkAbstractArray* kind = cells->GetAbstractArray("KindName");
  if (!radius || !kind) // after an error, which the filter has reported, outputs are empty
  {
    return EXIT_FAILURE;
  }
  for (vtkIdType i = 0; i < radius->GetNumberOfTuples(); ++i)
  {
    std::cout << kind->GetVariantValue(i).ToString() << ", radius " << radius->GetTuple1(i) << '\n';
  }
  return EXIT_SUCCESS;
}
