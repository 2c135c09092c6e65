/**
 * @class   vtkSolvationSurface
 * @brief   equilibrium surface of a molecule in the field of its charges, and its solvation
 * energies
 *
 * Input: atoms with the point arrays `Charge` (e) and `Radius` (angstrom), or those chosen with
 * SetInputArrayToProcess(0, ...) for radii and (1, ...) for charges; a PQR file has both. Well
 * depths are as for vtkNonpolarSolvation; water, alternate locations and missing hydrogens are
 * treated as in vtkMolecularFlowSurface.
 *
 * Surface tension, pressure, dispersion and the electric field move the surface; the field is that
 * of the charges inside it (Poisson-Boltzmann equation). Both are solved alternately until the
 * energy converges. This is the coupled Laplace-Beltrami and Poisson-Boltzmann model of the thesis
 * in sharp form. Formulas and sources: SolvationFlow.h, CoupledFlow.h.
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0, vtkPolyData, the surface, closed; 1,
 * vtkImageData, distance and potential; 2, vtkTable, a row for each update.
 *
 * If the energy has not converged, the field array `Converged` is 0 and the surface of the last
 * update is returned, with a warning.
 *
 * **ProbeRadius** keeps the surface of a protein from collapsing. The field pulls many times more
 * strongly than the tension resists, so without a probe the surface ends on the atoms, in clefts
 * that water cannot enter; a warning says so.
 *
 * **Errors** (message, empty outputs): those of the atoms, no charges, a charge outside all atoms,
 * parameters out of range, a grid that does not fit into memory. Cost: 3 to 10 solutions of the
 * Poisson-Boltzmann equation. All atoms are needed on one rank.
 */
#ifndef vtkSolvationSurface_h
#define vtkSolvationSurface_h

#include "Atoms/AtomProperties.h"
#include "Core/ArrayProperty.h"
#include "Core/OutputArrays.h"
#include "MolecularSurfaces/SolventProperties.h"
#include "Solvation/SolvationParameters.h"
#include "vtkIsthmusFiltersSolvationModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the input that RequestInformation() needs
#include <vector> // for the table of output arrays

class vtkImageData;
class vtkTable;

namespace isthmus
{
class InputInAdvance;
}

class VTKISTHMUSFILTERSSOLVATION_EXPORT vtkSolvationSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkSolvationSurface* New();
  vtkTypeMacro(vtkSolvationSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the radii, `Radius` by default, input array 1 that of the
  /// charges, `Charge`.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  ///@{
  /// The factor by which the radii are multiplied at the start of the flow, at least 1. Default
  /// 1.3.
  ISTHMUS_PARAMETER_OF(Parameters.Flow, Enlargement, double);
  ///@}

  ///@{
  /// Radius of the probe, in angstrom; there is no solvent where the probe does not fit. 0: no
  /// probe. Default 1.4.
  ISTHMUS_PARAMETER_OF(Parameters.Flow, ProbeRadius, double);
  ///@}

  ///@{
  /// Spacing of the grid, in angstrom. Default 0.5.
  ISTHMUS_PARAMETER_OF(Parameters.Flow, Spacing, double);
  ///@}

  ///@{
  /// Thickness of the solvent around the surface in which the potential is computed, in angstrom.
  /// Default 10.
  ISTHMUS_PARAMETER_OF(Parameters.Potential, Padding, double);
  ///@}

  ///@{
  /// Dielectric constants. Defaults 2 and 80.
  ISTHMUS_PARAMETER_OF(Parameters.Potential, SoluteDielectric, double);
  ISTHMUS_PARAMETER_OF(Parameters.Potential, SolventDielectric, double);
  ///@}

  enum DielectricModels
  {
    SharpInterface = 0,
    SmoothDielectric = 1
  };

  ///@{
  /// Treatment of the surface in the field during the iteration: as a jump, or by one permittivity
  /// for each edge of the grid. The last update always uses the jump; with SmoothDielectric, this
  /// is an additional row. Default SharpInterface.
  ISTHMUS_PARAMETER_OF(Parameters.Potential, DielectricModel, int);
  ///@}

  ///@{
  /// Ionic strength of a 1:1 salt, in mol/l. Default 0.
  ISTHMUS_PARAMETER_OF(Parameters.Potential, IonicStrength, double);
  ///@}

  ///@{
  /// Temperature in kelvin. Default 298.15.
  ISTHMUS_PARAMETER_OF(Parameters.Potential, Temperature, double);
  ///@}

  ///@{
  /// Number of steps of the flow between two solutions, at least 1; with AdaptiveUpdate fewer if
  /// the volume converges before. Defaults 50 and on.
  ISTHMUS_PARAMETER_OF(Parameters.Policy, UpdatePeriod, int);
  ISTHMUS_PARAMETER_SWITCH_OF(Parameters.Policy, AdaptiveUpdate);
  ///@}

  ///@{
  /// alpha and alpha': the fractions of each period's motion, and of each new field's force, that
  /// are applied; above 0, at most 1. The defaults are 1; smaller values take more updates and are
  /// not needed.
  ISTHMUS_PARAMETER_OF(Parameters.Policy, SurfaceRelaxation, double);
  ISTHMUS_PARAMETER_OF(Parameters.Policy, FieldRelaxation, double);
  ///@}

  ///@{
  /// The surface has converged when the relative change of the energy is below this value twice in
  /// a row; the iteration always ends after MaximumUpdates. Defaults 1e-3 and 20.
  ISTHMUS_PARAMETER(EnergyTolerance, double);
  ISTHMUS_PARAMETER_OF(Parameters.Policy, MaximumUpdates, int);
  ///@}

  /// Output 1 and 2.
  vtkImageData* GetImage();
  vtkTable* GetUpdates();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// IncludeWaters and UnitedAtoms determine which atoms are used, and their radii; see
  /// AtomProperties.h. Default off and on.
  ISTHMUS_ATOM_PROPERTIES();
  /// SurfaceTension, above 0, and Pressure: SolventProperties.h. Defaults 0.0700 and 0.0464.
  ISTHMUS_SOLVENT_PROPERTIES(Parameters.Solvent);

protected:
  vtkSolvationSurface();
  ~vtkSolvationSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkSolvationSurface(const vtkSolvationSurface&) = delete;
  void operator=(const vtkSolvationSurface&) = delete;

  class vtkInternals; ///< functions of one execution

  isthmus::SolvationParameters Parameters;
  std::unique_ptr<isthmus::InputInAdvance> Advance;
};

#endif
