/**
 * @file PoissonBoltzmannOutput.h
 * @brief Converts a solution to VTK data: image, field data, surface and atoms.
 */
#ifndef isthmus_PoissonBoltzmannOutput_h
#define isthmus_PoissonBoltzmannOutput_h

#include "Core/Progress.h"
#include "Electrostatics/GridPotential.h"

#include <string>

class vtkImageData;
class vtkPointSet;
class vtkPolyData;

namespace isthmus
{

struct SoluteVolume;

/// Adds Potential (active), ReactionPotential and Side, cropped to the image.
void FillImage(
  const GridPotential& solution, vtkImageData* image, const ProgressCallback& progress = {});

/// Adds Dielectric, IonAccessibility and ChargeDensity; see vtkPoissonBoltzmann.h.
void FillMaps(
  const GridPotential& solution, const std::vector<ChargedAtom>& onGrid, vtkImageData* image);

void FillFieldData(const GridPotential& solution, const PoissonBoltzmannParameters& parameters,
  double netCharge, const std::string& surface, vtkImageData* image);

/// `polygons` with the values at its points, or, where it is null, the volume's level.
void FillSurface(const GridPotential& solution, const SoluteVolume& volume, double kelvin,
  vtkPolyData* polygons, vtkPolyData* output, const ProgressCallback& progress = {});

void FillAtoms(
  const GridPotential& solution, const SoluteVolume& volume, double kelvin, vtkPointSet* atoms);

/// Adds DielectricBoundaryForce, IonicBoundaryForce and PolarForce to the output of FillAtoms, from
/// the atoms on the grid of the volume.
void FillBoundaryForces(const GridPotential& solution, const SoluteVolume& volume,
  const std::vector<ChargedAtom>& onGrid, vtkPointSet* atoms);

}

#endif
