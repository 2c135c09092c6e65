// map_curvature MAP LEVEL SURFACE.vtp: an isosurface of a density map with its curvatures.

#include <vtkDataArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkHessianCurvature.h>
#include <vtkMRCMapReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 4)
  {
    std::cerr << "usage: map_curvature MAP LEVEL SURFACE.vtp\n";
    return EXIT_FAILURE;
  }

  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(argv[1]);

  vtkNew<vtkFlyingEdges3D> isosurface;
  isosurface->SetInputConnection(reader->GetOutputPort());
  isosurface->SetValue(0, std::atof(argv[2]));

  vtkNew<vtkHessianCurvature> curvature;
  curvature->SetInputConnection(0, reader->GetOutputPort());
  curvature->SetInputConnection(1, isosurface->GetOutputPort());

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetDataModeToBinary();
  writer->SetInputConnection(curvature->GetOutputPort());
  writer->SetFileName(argv[3]);
  if (!writer->Write())
  {
    return EXIT_FAILURE;
  }

  vtkPolyData* surface = vtkPolyData::SafeDownCast(curvature->GetOutputDataObject(0));
  vtkDataArray* mean = surface->GetPointData()->GetArray("MeanCurvature");
  if (!mean || surface->GetNumberOfPolys() == 0)
  {
    std::cerr << "There is no surface at level " << argv[2] << ".\n";
    return EXIT_FAILURE;
  }
  double range[2];
  mean->GetRange(range);
  std::cout << surface->GetNumberOfPolys() << " triangles, mean curvature " << range[0] << " to "
            << range[1] << " per angstrom\n";
  return EXIT_SUCCESS;
}
