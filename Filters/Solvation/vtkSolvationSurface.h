/**
 * @class   vtkSolvationSurface
 * @brief   equilibrium surface of a molecule in the field of its charges, with what solvation
 * costs
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
 * Outputs:
 *  - 0: vtkPolyData, the surface: closed, with `Normals`, `Potential` (kT/e), `NormalField`,
 *    `SurfaceChargeDensity`;
 *  - 1: vtkImageData with `SignedDistance`, `S`, `Potential`, `ReactionPotential` (kT/e) and
 *    `Side`;
 *  - 2: vtkTable, a row for each update: `Update`, `Time` (square angstrom), `Area`, `Volume`,
 *    `SurfaceEnergy`, `VolumeEnergy`, `DispersionEnergy`, `NonpolarEnergy`, `PolarEnergy`,
 *    `TotalEnergy` (kcal/mol), `OnObstacle` (the part of the surface that its obstacle holds).
 *
 * The field array `Rests` of outputs 0 and 1 is 1 if the energy has converged. Otherwise the
 * surface of the last update is returned, with a warning.
 *
 * **ProbeRadius keeps the surface of a protein from collapsing. The field pulls many times more
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
#include "MolecularSurfaces/SolventProperties.h"
#include "vtkIsthmusFiltersSolvationModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for what it asks of its input

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

  ///@{
  /// The point arrays of charges and radii. Defaults `Charge` and `Radius`.
  void SetChargeArrayName(const char* name);
  void SetRadiusArrayName(const char* name);
  ///@}

  ///@{
  /// The factor by which the radii are multiplied at the start of the flow, at least 1. Default
  /// 1.3.
  vtkSetMacro(Enlargement, double);
  vtkGetMacro(Enlargement, double);
  ///@}

  ///@{
  /// Radius of the probe, in angstrom; there is no solvent where the probe does not fit. 0: no
  /// probe. Default 1.4.
  vtkSetMacro(ProbeRadius, double);
  vtkGetMacro(ProbeRadius, double);
  ///@}

  ///@{
  /// Spacing of the grid, in angstrom. Default 0.5.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Thickness of the solvent around the surface in which the potential is computed, in angstrom.
  /// Default 10.
  vtkSetMacro(Padding, double);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /// Dielectric constants. Defaults 2 and 80.
  vtkSetMacro(SoluteDielectric, double);
  vtkGetMacro(SoluteDielectric, double);
  vtkSetMacro(SolventDielectric, double);
  vtkGetMacro(SolventDielectric, double);
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
  vtkSetClampMacro(DielectricModel, int, SharpInterface, SmoothDielectric);
  vtkGetMacro(DielectricModel, int);
  ///@}

  ///@{
  /// Ionic strength of a 1:1 salt, in mol/l. Default 0.
  vtkSetMacro(IonicStrength, double);
  vtkGetMacro(IonicStrength, double);
  ///@}

  ///@{
  /// Temperature in kelvin. Default 298.15.
  vtkSetMacro(Temperature, double);
  vtkGetMacro(Temperature, double);
  ///@}

  ///@{
  /// Number of steps of the flow between two solutions, at least 1; with AdaptiveUpdate fewer if
  /// the volume converges before. Defaults 50 and on.
  vtkSetMacro(UpdatePeriod, int);
  vtkGetMacro(UpdatePeriod, int);
  vtkSetMacro(AdaptiveUpdate, bool);
  vtkGetMacro(AdaptiveUpdate, bool);
  vtkBooleanMacro(AdaptiveUpdate, bool);
  ///@}

  ///@{
  /// alpha and alpha': the fractions of each period's motion, and of each new field's force, that
  /// are applied; above 0, at most 1. The defaults are 1; smaller values take more updates and are
  /// not needed.
  vtkSetMacro(SurfaceRelaxation, double);
  vtkGetMacro(SurfaceRelaxation, double);
  vtkSetMacro(FieldRelaxation, double);
  vtkGetMacro(FieldRelaxation, double);
  ///@}

  ///@{
  /// The surface has converged when the relative change of the energy is below this value twice in
  /// a row; the iteration always ends after MaximumUpdates. Defaults 1e-3 and 20.
  vtkSetMacro(EnergyTolerance, double);
  vtkGetMacro(EnergyTolerance, double);
  vtkSetMacro(MaximumUpdates, int);
  vtkGetMacro(MaximumUpdates, int);
  ///@}

  /// Output 1 and 2.
  vtkImageData* GetImage();
  vtkTable* GetUpdates();

  /// KeepWaters and UnitedAtoms determine which atoms are used, and their radii; see
  /// AtomProperties.h. Default off and on.
  ISTHMUS_ATOM_PROPERTIES();
  /// SurfaceTension, above 0, and Pressure: SolventProperties.h. Defaults 0.0700 and 0.0464.
  ISTHMUS_SOLVENT_PROPERTIES();

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

  struct Internals;
  friend struct Internals;

  double Enlargement = 1.3;
  double ProbeRadius = 1.4;
  double Spacing = 0.5;
  double Padding = 10.0;
  double SoluteDielectric = 2.0;
  double SolventDielectric = 80.0;
  int DielectricModel = SharpInterface;
  double IonicStrength = 0.0;
  double Temperature = 298.15;
  int UpdatePeriod = 50;
  bool AdaptiveUpdate = true;
  double SurfaceRelaxation = 1.0;
  double FieldRelaxation = 1.0;
  double EnergyTolerance = 1e-3;
  int MaximumUpdates = 20;
  std::unique_ptr<isthmus::InputInAdvance> Advance;
};

#endif
