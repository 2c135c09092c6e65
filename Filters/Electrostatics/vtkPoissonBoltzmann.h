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
 * solved with the jump of eps at the surface itself, not smeared over cells: for spheres with exact
 * solutions, errors are a tenth of those of common solvers on the same grid and decrease with the
 * square of the spacing. With DielectricModel SmoothDielectric, it is solved by finite volumes with
 * one permittivity for each edge of the grid, that of its parts inside and outside in series.
 * Energies converge with the same order but are 10 to 300 times less accurate for spheres; the
 * potential at the surface converges with first order. This model is for comparison with models of
 * moving surfaces, which usually use it.
 *
 * **Output 0**: image with, on points, double: `Potential` (kT/e) and `ReactionPotential` (kT/e:
 * the potential minus that of the charges in a medium with SoluteDielectric everywhere), and Side
 * (unsigned char, 1 inside). The grid is that of input 1 if that is a volume, otherwise one with
 * Spacing and Padding around the surface (around the chains of the input, with 2 angstrom more, if
 * pdb2pqr adds the charges). Field data: `SolvationEnergy` (kcal/mol; from a medium with
 * SoluteDielectric everywhere into the solvent), `SolvationEnergyKT`, `SolvationEnergyKilojoule`,
 * `Iterations` (of BiCGSTAB on this grid, including those of all Newton steps and those for the
 * border values on this grid), `BorderIterations` (on a coarser grid, for the border values),
 * `NewtonSteps`, `ResidualHistory` (of the last solution), `LinearFits` and `GhostFits` (crossings
 * of the surface at which a simpler fit replaced the quadratic one, most of them in cavities and
 * clefts one or two nodes wide), `DebyeLength` (angstrom, 0 without salt), `NetCharge`, `Surface`.
 * ComputeMaps adds the coefficients of the equation as point arrays (float): Dielectric (of the
 * edges from the node along each axis, like dielx, diely and dielz of APBS; if the surface cuts an
 * edge, its parts are in series, rounded to 1/255), IonAccessibility (the fraction of the node's
 * cell that ions reach, weighted by z^2 c if radii differ) and ChargeDensity (e/angstrom^3,
 * trilinear; the solver itself uses point charges).
 *
 * **Output 1**: the surface with, on points, double: `Potential`, `NormalField` (outwards, just
 * outside, kT/(e angstrom)), `SurfaceChargeDensity` (induced, e/angstrom^2), `Normals`; fitted from
 * both sides.
 *
 * **Output 2**: the atoms with ReactionPotential (kT/e), AtomEnergy (kcal/mol: the contribution of
 * the atom to the solvation energy; the contributions add up to it unless Nonlinear is on), and
 * ReactionForce (kcal/(mol angstrom)): -q grad u, the force of the reaction field on each charge.
 * This is minus the derivative of the solvation energy with respect to the position of the charge
 * at a fixed surface. With ComputeBoundaryForces also `DielectricBoundaryForce` and
 * `IonicBoundaryForce` (BoundaryForces.h), and PolarForce, the sum of the three: minus the
 * derivative of the solvation energy with respect to the position of the atom if the surface moves
 * with it. Without input 1, the surface is that of the Gaussians; on another surface each point
 * moves with the atom whose ball is nearest. The Coulomb force between the charges is not included.
 *
 * A volume may end near the surface: the equation is solved with Padding angstrom of solvent around
 * the surface, and the result is cropped. Nodes nearer to a charge than a quarter of the spacing
 * have its potential at that distance.
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

#include "Core/Deprecation.h"
#include "vtkImageAlgorithm.h"
#include "vtkIsthmusFiltersElectrostaticsModule.h" // for the export macro
#include "vtkSmartPointer.h"

#include <memory> // for what is shared between the requests
#include <string> // for warnings

class vtkPointSet;
class vtkPolyData;

namespace isthmus
{
struct PoissonBoltzmannParameters;
struct SoluteVolume;
}

namespace isthmus
{
class ForceFieldAtomsCache;
class InputInAdvance;
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
  ISTHMUS_DEPRECATED("1.0.0", "use SetLevel")
  void SetIsoValue(double level) { this->SetLevel(level); }
  ISTHMUS_DEPRECATED("1.0.0", "use GetLevel")
  double GetIsoValue() { return this->GetLevel(); }
  ///@}

  ///@{
  /// Whether input 1's scalars are higher inside (on, the default) or lower (distances).
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Dielectric constant inside, no unit. Default 2.
  vtkSetMacro(SoluteDielectric, double);
  vtkGetMacro(SoluteDielectric, double);
  ///@}

  ///@{
  /// Dielectric constant outside, no unit. Default 80.
  vtkSetMacro(SolventDielectric, double);
  vtkGetMacro(SolventDielectric, double);
  ///@}

  ///@{
  /// Ionic strength of a 1:1 salt, mol/l. Default 0: no ions, unless some were added by AddIon.
  /// 0.15 is physiological.
  vtkSetMacro(IonicStrength, double);
  vtkGetMacro(IonicStrength, double);
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
  vtkSetMacro(IonRadius, double);
  vtkGetMacro(IonRadius, double);
  ///@}

  ///@{
  /// Temperature in kelvin. Default 298.15.
  vtkSetMacro(Temperature, double);
  vtkGetMacro(Temperature, double);
  ///@}

  ///@{
  /// Spacing of the grid if input 1 is not a volume, in angstrom. Default 0.5.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Minimum thickness of the solvent around the surface, in angstrom. Default 10.
  vtkSetMacro(Padding, double);
  vtkGetMacro(Padding, double);
  ///@}

  ///@{
  /// Solve the full Poisson-Boltzmann equation instead of the linearised one. Default off.
  vtkSetMacro(Nonlinear, bool);
  vtkGetMacro(Nonlinear, bool);
  vtkBooleanMacro(Nonlinear, bool);
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
  vtkSetClampMacro(BoundaryCondition, int, Zero, FromInput);
  vtkGetMacro(BoundaryCondition, int);
  ///@}

  enum DielectricModels
  {
    SharpInterface = 0,
    SmoothDielectric = 1
  };

  ///@{
  /// Treatment of the dielectric constant at the surface: as a jump, or as one permittivity for
  /// each edge of the grid. Default SharpInterface.
  vtkSetClampMacro(DielectricModel, int, SharpInterface, SmoothDielectric);
  vtkGetMacro(DielectricModel, int);
  ///@}

  ///@{
  /// Residual at which the iteration ends, as a fraction of the first one. Default 1e-6.
  vtkSetMacro(Tolerance, double);
  vtkGetMacro(Tolerance, double);
  ///@}

  ///@{
  /// Iterations after which a linear system counts as not converging. Default 100.
  vtkSetMacro(MaximumIterations, int);
  vtkGetMacro(MaximumIterations, int);
  ///@}

  ///@{
  /// Adds the forces on the atoms through the surface that moves with them to output 2. Default
  /// off.
  vtkSetMacro(ComputeBoundaryForces, bool);
  vtkGetMacro(ComputeBoundaryForces, bool);
  vtkBooleanMacro(ComputeBoundaryForces, bool);
  ///@}

  ///@{
  /// Adds the maps of dielectric, ions and charges to output 0. Default off.
  vtkSetMacro(ComputeMaps, bool);
  vtkGetMacro(ComputeMaps, bool);
  vtkBooleanMacro(ComputeMaps, bool);
  ///@}

  enum ForceFields
  {
    AMBER = 0,
    PARSE = 1
  };

  ///@{
  /// Force field by which pdb2pqr assigns charges and radii to atoms without charges. Default
  /// AMBER.
  vtkSetClampMacro(ForceField, int, AMBER, PARSE);
  vtkGetMacro(ForceField, int);
  ///@}

  ///@{
  /// Names of the point arrays of input 0. Default `Charge` and `Radius`.
  void SetChargeArrayName(const char* name);
  void SetRadiusArrayName(const char* name);
  ///@}

  /// The solute's surface: input 1.
  void SetSurfaceConnection(vtkAlgorithmOutput* surface) { this->SetInputConnection(1, surface); }
  /// Input 2: a potential for the border values or as the initial guess.
  void SetPotentialConnection(vtkAlgorithmOutput* image) { this->SetInputConnection(2, image); }

  /// Output 1.
  vtkPolyData* GetSurface();
  /// Output 2.
  vtkPointSet* GetAtoms();

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

  isthmus::PoissonBoltzmannParameters Parameters() const;
  void Warn(const std::string& sentence); ///< empty: not
  /// The grid without input 1, the same for information and data.
  vtkSmartPointer<vtkImageData> GridAround(vtkPointSet* atoms);
  vtkPointSet* AtomsWithCharges(vtkInformationVector** inputVector);
  int MakeOutputs(vtkInformationVector** inputVector, vtkInformationVector* outputVector);
  void Solve(vtkInformationVector** inputVector, vtkInformationVector* outputVector);

  double Level = 0.5;
  bool InsideIsHigher = true;
  double SoluteDielectric = 2.0;
  double SolventDielectric = 80.0;
  double IonicStrength = 0.0;
  double IonRadius = 2.0;
  double Temperature = 298.15;
  double Spacing = 0.5;
  double Padding = 10.0;
  bool Nonlinear = false;
  int BoundaryCondition = SelfConsistent;
  int DielectricModel = SharpInterface;
  int ForceField = AMBER;
  double Tolerance = 1e-6;
  int MaximumIterations = 100;
  bool ComputeBoundaryForces = false;
  bool ComputeMaps = false;

  struct Salt;
  std::unique_ptr<Salt> Ions;
  std::unique_ptr<isthmus::InputInAdvance> Advance;
  std::unique_ptr<isthmus::ForceFieldAtomsCache> Charged;
};

#endif
