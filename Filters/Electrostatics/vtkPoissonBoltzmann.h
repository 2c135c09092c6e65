/**
 * @class   vtkPoissonBoltzmann
 * @brief   electrostatic potential of a molecule in salt water, second order at its surface
 *
 * **Input 0**: the atoms, any vtkPointSet with the point arrays `Charge` (e) and `Radius`
 * (angstrom; others by SetInputArrayToProcess 0 and 1), for example from vtkMacromoleculeReader for
 * a PQR file. Atoms with names but without charges (a PDB or mmCIF file) get hydrogens, charges and
 * radii of a force field (ForceField) from the program pdb2pqr, if it is installed; water and
 * residues that the force field does not contain are dropped, the latter with a warning. Output 2
 * has them.
 *
 * **Input 1**, optional: the solute's surface. A volume (vtkImageData): the isosurface at Level of
 * its scalars, which are higher inside unless InsideIsHigher is off. Or a closed surface
 * (vtkPolyData). Without this input, the surface is the level 1 of a sum of Gaussians with decay
 * 2.3 (see vtkMolecularDensity), near the solvent-excluded surface.
 *
 * **Input 2**, optional: a potential (image, kT/e). With BoundaryCondition FromInput it provides
 * the border values (focusing; it has to cover the grid), otherwise it is the initial guess of the
 * iteration.
 *
 * **Equation**: -div(eps grad phi) + ions = charges, with eps SoluteDielectric inside and
 * SolventDielectric outside, ions by Boltzmann's law, linearised unless Nonlinear is on. It is
 * solved with the jump of eps at the surface itself, second order in energy and potential. With
 * DielectricModel SmoothDielectric, it is solved by finite volumes with one permittivity for each
 * edge of the grid, that of its parts inside and outside in series: second order in the energy, but
 * less accurate, and first order in the potential at the surface. This model is for comparison with
 * models of moving surfaces, which usually use it.
 *
 * **Output 0**: image with the potential. The grid is that of input 1 if that is a volume,
 * otherwise one with Spacing and Padding around the surface (around the chains of the input, with 2
 * angstrom more, if pdb2pqr adds the charges).
 *
 * **Output 1**: the surface with the potential and its field, fitted from both sides.
 *
 * **Output 2**: the atoms with energies and forces. ReactionForce is minus the derivative of the
 * solvation energy with respect to the position of the charge at a fixed surface, PolarForce that
 * with respect to the position of the atom if the surface moves with it (BoundaryForces.h).
 *
 * OutputArrayTable() lists the arrays of all; the coefficients of the equation on output 0 and the
 * boundary forces on output 2 are optional. Without input 1, the surface moves as that of the
 * Gaussians; with it, each point moves with the atom whose ball is nearest. The Coulomb force
 * between the charges is not included.
 *
 * A volume may end near the surface: the equation is solved with Padding angstrom of solvent around
 * the surface, and the result is cropped. Nodes nearer to a charge than a quarter of the spacing
 * have its potential at that distance.
 *
 * **Accuracy.** SolvationEnergyError is an estimate from two solutions on coarser grids. A warning
 * is issued if it is above 5 % of the energy.
 *
 * **Places.** It is an error if even one charge is outside the surface. Otherwise inputs 1 and 2
 * are compared with the atoms as in all filters (InputOverlap.h). No overlap is an error; a warning
 * is issued if less than half of the smaller one is in the box of the larger, or if their sizes
 * differ by a factor of 10.
 *
 * **Errors** (one message, empty outputs): no charges, or all 0; charges outside the surface;
 * negative radii; numbers that are not finite; a surface that is open, empty, crosses another part
 * of itself (ShellCrossings.h) or leaves the volume; properties out of range; a box of more than
 * 20000 nodes along an axis; an input 2 that does not cover the border or is not finite; no
 * convergence. A warning is issued for a net charge that is not integral, and for a box that is
 * small compared with the Debye length. No atoms: empty outputs and no error.
 *
 * **Cost.** Time is linear in nodes (6 to 12 iterations for any size) and in charges x crossings; a
 * tree is used for more than 5000 charges. Memory: 80 to 104 bytes for each node. In parallel,
 * bitwise the same on any number of threads. On several MPI ranks each solves for its own atoms:
 * gather them first (in ParaView: Aggregate Dataset).
 */
#ifndef vtkPoissonBoltzmann_h
#define vtkPoissonBoltzmann_h

#include "Core/ArrayProperty.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Core/Progress.h"
#include "Electrostatics/PoissonBoltzmannParameters.h"
#include "vtkImageAlgorithm.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <memory> // for what is shared between the requests
#include <string> // for warnings

class vtkPointSet;
class vtkPolyData;

namespace isthmus
{
class ForceFieldAtomsCache;
class GridPotential;
class InputInAdvance;
struct SoluteVolume;
}

class VTKISTHMUSFILTERSELECTROSTATICS_EXPORT vtkPoissonBoltzmann : public vtkImageAlgorithm
{
public:
  static vtkPoissonBoltzmann* New();
  vtkTypeMacro(vtkPoissonBoltzmann, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Level of input 1's scalars that is the surface. Default 0.5.
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /// Whether input 1's scalars are higher inside (on, the default) or lower (distances).
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Dielectric constant inside, no unit. Default 2.
  ISTHMUS_PARAMETER(SoluteDielectric, double);
  ///@}

  ///@{
  /// Dielectric constant outside, no unit. Default 80.
  ISTHMUS_PARAMETER(SolventDielectric, double);
  ///@}

  ///@{
  /// Ionic strength of a 1:1 salt, mol/l. Default 0: no ions, unless some were added by AddIon.
  /// 0.15 is physiological.
  ISTHMUS_PARAMETER(IonicStrength, double);
  ///@}

  ///@{
  /// Adds ions of any kind, used instead of the 1:1 salt: valence with sign, and concentration in
  /// mol/l. Charges must cancel.
  void AddIon(double valence, double concentration);
  /// Adds an ion with its own radius in angstrom, its closest distance to the surface; for other
  /// ions this is IonRadius.
  void AddIon(double valence, double concentration, double radius);
  void ClearIons();
  int GetNumberOfIons();
  ///@}

  ///@{
  /// Closest distance of the ions to the surface, in angstrom. Default 2.
  ISTHMUS_PARAMETER(IonRadius, double);
  ///@}

  ///@{
  /// Temperature in kelvin. Default 298.15.
  ISTHMUS_PARAMETER(Temperature, double);
  ///@}

  ///@{
  /// Spacing of the grid if input 1 is not a volume, in angstrom. Default 0.5.
  ISTHMUS_PARAMETER(Spacing, double);
  ///@}

  ///@{
  /// Minimum thickness of the solvent around the surface, in angstrom. Default 10.
  ISTHMUS_PARAMETER(Padding, double);
  ///@}

  ///@{
  /// Solve the full Poisson-Boltzmann equation instead of the linearised one. Default off.
  ISTHMUS_PARAMETER_SWITCH(Nonlinear);
  ///@}

  enum BoundaryConditions
  {
    Zero = 0,
    SingleDebyeHueckel = 1,
    MultipleDebyeHueckel = 2,
    SelfConsistent = 3,
    FromInput = 4
  };

  ///@{
  /// Values on the border of the box: 0; the Debye-Hueckel potential of the net charge or of all
  /// charges; the latter corrected by a coarser solution (SelfConsistent, the default); or the
  /// values of input 2.
  ISTHMUS_PARAMETER(BoundaryCondition, int);
  ///@}

  enum DielectricModels
  {
    SharpInterface = 0,
    SmoothDielectric = 1
  };

  ///@{
  /// Treatment of the dielectric constant at the surface: as a jump, or as one permittivity for
  /// each edge of the grid. Default SharpInterface.
  ISTHMUS_PARAMETER(DielectricModel, int);
  ///@}

  ///@{
  /// Residual at which the iteration ends, as a fraction of the first one. Default 1e-6.
  ISTHMUS_PARAMETER(Tolerance, double);
  ///@}

  ///@{
  /// Iterations after which a linear system counts as not converging. Default 100.
  ISTHMUS_PARAMETER(MaximumIterations, int);
  ///@}

  enum ForceFields
  {
    AMBER = 0,
    PARSE = 1
  };

  ///@{
  /// Force field by which pdb2pqr assigns charges and radii to atoms without charges. Default
  /// AMBER.
  vtkSetMacro(ForceField, int);
  vtkGetMacro(ForceField, int);
  ///@}

  /// Input array 0 is the point array of the radii, `Radius` by default, input array 1 that of the
  /// charges, `Charge`.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  /// The solute's surface: input 1.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(1, surface); }
  /// Input 2: a potential for the border values or as the initial guess.
  void SetPotentialConnection(vtkAlgorithmOutput* image) { this->SetInputConnection(2, image); }

  /// Output 1.
  vtkPolyData* GetSurface();
  /// Output 2.
  vtkPointSet* GetAtoms();

  /// The arrays that the filter adds to its outputs, and which of them are optional.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// Which optional arrays to make.
  ISTHMUS_OUTPUT_ARRAY_SELECTION();

protected:
  vtkPoissonBoltzmann();
  ~vtkPoissonBoltzmann() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkPoissonBoltzmann(const vtkPoissonBoltzmann&) = delete;
  void operator=(const vtkPoissonBoltzmann&) = delete;

  void Warn(const std::string& sentence); ///< nothing if empty
  /// The grid without input 1, the same for information and data.
  vtkSmartPointer<vtkImageData> GridAround(vtkPointSet* atoms);
  vtkPointSet* AtomsWithCharges(vtkInformationVector** inputVector);
  /// Estimates the error of the energy, and warns if it is large.
  void StateError(const isthmus::SoluteVolume& volume, isthmus::GridPotential& solution,
    const isthmus::ProgressCallback& progress);
  int MakeOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void Solve(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  double Level = 0.5;
  bool InsideIsHigher = true;
  isthmus::PoissonBoltzmannParameters Parameters;
  int ForceField = AMBER;

  std::unique_ptr<isthmus::InputInAdvance> Advance;
  std::unique_ptr<isthmus::ForceFieldAtomsCache> Cache;
};

#endif
