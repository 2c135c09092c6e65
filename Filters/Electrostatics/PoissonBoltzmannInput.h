/**
 * @file PoissonBoltzmannInput.h
 * @brief Checks the inputs of vtkPoissonBoltzmann and transfers them to its grid.
 */
#ifndef isthmus_PoissonBoltzmannInput_h
#define isthmus_PoissonBoltzmannInput_h

#include "Atoms/MoleculeAtoms.h"
#include "Electrostatics/LevelFunction.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h"

#include <string>
#include <vector>

class vtkAlgorithm;
class vtkDataArray;
class vtkDataObject;
class vtkImageData;
class vtkPointSet;

namespace isthmus
{

struct SoluteVolume;

/// The charges of the point array `name` at the positions of `atoms.Kept`, with radius 0. Throws as
/// AtomCharges does.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<ChargedAtom> MakeChargedAtoms(
  vtkDataObject* input, const MoleculeAtoms& atoms, const std::string& name);

/// The atoms of the solute.
struct SoluteAtoms
{
  std::vector<ChargedAtom> Atoms; ///< all points, in world coordinates
  double NetCharge = 0.0;         ///< e
  std::string Warning;            ///< empty: none
};

/// Reads the atoms by the filter's input arrays 0 (charges) and 1 (radii, which are 0 if there are
/// none and none are needed). Throws std::invalid_argument as ReadAtoms and AtomCharges do, and if
/// an atom has no radius or all charges are 0.
SoluteAtoms ReadSolute(vtkAlgorithm* filter, vtkPointSet* points, bool radiiNeeded);

/// The active scalars of input 1, or its only array.
vtkDataArray* SurfaceScalars(vtkImageData* image);

/// Transforms the atoms to the frame of the grid. Throws if a charge is not inside the surface.
void PlaceOnGrid(const SoluteVolume& volume, std::vector<ChargedAtom>& atoms);

/// Sets `potential` (may be null) as the border values, or as the initial guess, in the parameters.
void SetPotentialInput(
  vtkImageData* potential, vtkImageData* grid, PoissonBoltzmannParameters& parameters);

}

#endif
