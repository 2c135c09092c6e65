// denoised_curvature MAP: a map, denoised, with the curvature of its level sets at the nodes. The
// other classes are only instantiated, so that their libraries are linked.

#include <vtkDenoiseMap.h>
#include <vtkHessianCurvature.h>
#include <vtkImageData.h>
#include <vtkMRCMapReader.h>
#include <vtkMacromoleculeReader.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoissonBoltzmann.h>

#include <cstdlib>
#include <iostream>

int main(int argc, char* argv[])
{
  if (argc != 2)
  {
    return EXIT_FAILURE;
  }
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkDenoiseMap> denoised;
  denoised->SetInputConnection(reader->GetOutputPort());
  vtkNew<vtkHessianCurvature> curvature;
  curvature->SetInputConnection(denoised->GetOutputPort());
  curvature->Update();
  vtkNew<vtkMacromoleculeReader> molecules;
  vtkNew<vtkPoissonBoltzmann> potential;
  const bool found =
    curvature->GetOutputDataObject(0)->GetAttributes(0)->GetArray("MeanCurvature") != nullptr;
  std::cout << molecules->GetClassName() << ' ' << potential->GetClassName() << '\n';
  return found ? EXIT_SUCCESS : EXIT_FAILURE;
}
