/**
 * @class   vtkNonpolarSolvation
 * @brief   nonpolar solvation energy of a molecule within its surface, whole and by atom
 *
 * Input 0: the atoms, as for vtkMolecularFlowSurface. Input 1: an image whose array
 * `SignedDistance` (angstrom, negative inside) describes the surface: output 1 of that filter for
 * the same atoms.
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0, vtkPolyData, the atoms with their parts of the
 * energy, which add up to the whole; atoms without a ball have 0. 1, vtkTable, one row: the same of
 * the whole.
 *
 * G = SurfaceTension x Area + Pressure x Volume + dispersion (thesis 4.3 to 4.6 in the form of
 * Wagoner and Baker 2006). Lennard-Jones parameters of the atoms: the point array WellDepth
 * (kcal/mol), with the radii as half the distance of the minimum, or otherwise by element (AMBER
 * parm99). Those of the solvent are for the oxygen of TIP3P at 1 g/cm^3 by default.
 *
 * SurfaceTension 0.0700 kcal/mol/A^2 and Pressure 0.0464 kcal/mol/A^3 are fitted to eleven alkanes
 * with minimal molecular surfaces of AMBER radii (rms 0.21 kcal/mol). They are this accurate only
 * for alkanes and this surface; their accuracy for proteins is unknown.
 *
 * **Errors** (message, empty outputs): those of the atoms; an image at a different place than the
 * atoms (InputOverlap.h), or with more than half of the atoms outside (fewer are a warning; a
 * volume in nanometres lies within the molecule); no `SignedDistance`; cells that are not cubes;
 * parameters that are not finite, negative densities or depths. Cost: atoms x nodes inside within
 * 12 angstrom.
 */
#ifndef vtkNonpolarSolvation_h
#define vtkNonpolarSolvation_h

#include "Atoms/AtomProperties.h"
#include "Core/ArrayProperty.h"
#include "Core/OutputArrays.h"
#include "MolecularSurfaces/SolventProperties.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for the table of output arrays

class VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT vtkNonpolarSolvation : public vtkPolyDataAlgorithm
{
public:
  static vtkNonpolarSolvation* New();
  vtkTypeMacro(vtkNonpolarSolvation, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the radii, `Radius` by default.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  ///@{
  /// rho_0, molecules per cubic angstrom, at least 0. Default 0.033428 (water).
  ISTHMUS_PARAMETER(SolventDensity, double);
  ///@}

  ///@{
  /// Half the distance at which the energy of two solvent molecules is minimal, in angstrom, at
  /// least 0. Default 1.7683 (TIP3P's oxygen).
  ISTHMUS_PARAMETER(SolventRadius, double);
  ///@}

  ///@{
  /// Depth of that minimum (not four times it), kcal/mol, at least 0. Default 0.1521 (TIP3P's
  /// oxygen).
  ISTHMUS_PARAMETER(SolventWellDepth, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// IncludeWaters and UnitedAtoms determine which atoms are used, and their radii; see
  /// AtomProperties.h. They must be set as in the vtkMolecularFlowSurface that made the surface.
  /// Default off and on.
  ISTHMUS_ATOM_PROPERTIES();
  /// SurfaceTension, at least 0, and Pressure: SolventProperties.h. Defaults 0.0700 and 0.0464.
  ISTHMUS_SOLVENT_PROPERTIES(Parameters);

protected:
  vtkNonpolarSolvation();
  ~vtkNonpolarSolvation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkNonpolarSolvation(const vtkNonpolarSolvation&) = delete;
  void operator=(const vtkNonpolarSolvation&) = delete;

  isthmus::SolventParameters Parameters;
};

#endif
