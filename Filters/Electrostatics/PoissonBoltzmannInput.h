/**
 * @file PoissonBoltzmannInput.h
 * @brief What vtkPoissonBoltzmann is given, checked and put on its grid.
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

/// The charges of the point array `name` at the places of `atoms.Kept`, with radius 0. Throws as
/// AtomCharges does.
VTKISTHMUSFILTERSELECTROSTATICS_EXPORT std::vector<ChargedAtom> ChargedAtomsOf(
  vtkDataObject* input, const MoleculeAtoms& atoms, const std::string& name);

/// The atoms of the solute.
struct SoluteAtoms
{
  std::vector<ChargedAtom> Atoms; ///< all points, in world coordinates
  double NetCharge = 0.0;         ///< e
  std::string Warning;            ///< empty: none
};

/// By the filter's input arrays 0 (charges) and 1 (radii; 0 where there are none and none are
/// needed). Throws std::invalid_argument as ReadAtoms and AtomCharges do, for an atom without a
/// radius, and where all charges are 0.
SoluteAtoms ReadSolute(vtkAlgorithm* filter, vtkPointSet* points, bool radiiNeeded);

/// The active scalars of input 1, or its only array.
vtkDataArray* SurfaceScalars(vtkImageData* image);

/// Moves the atoms into the frame of the grid. Throws where a charge is not inside the surface.
void PlaceOnGrid(const SoluteVolume& volume, std::vector<ChargedAtom>& atoms);

/// Makes `potential` (may be null) the border's values, or the start, of the parameters.
void SetPotentialInput(
  vtkImageData* potential, vtkImageData* grid, PoissonBoltzmannParameters& parameters);

}

#endif
