/**
 * @class   vtkIonTransport
 * @brief   ions that drift and diffuse through a channel: potential, concentrations, currents
 *
 * Input 0: atoms with the point arrays `Charge` (e) and `Radius` (angstrom), or those chosen with
 * SetInputArrayToProcess(0, ...) for radii and (1, ...) for charges; a PQR file has both. Water,
 * alternate locations and missing hydrogens are treated as in vtkMolecularFlowSurface. Input 1
 * (optional): the molecule's surface as closed polygons, for instance that of a converged
 * vtkSolvationSurface; otherwise the solvent-excluded surface for ProbeRadius is computed.
 *
 * The steady Poisson-Nernst-Planck equations between two baths that a flat membrane separates; it
 * is closed except for a round hole (LumenRadius) for the channel, around the axis through
 * MembraneCenter along MembraneNormal. The domain is a cylinder around that axis that contains the
 * atoms with a margin of Padding; its grid is turned so that one axis is that normal. Formulas and
 * sources: PoissonNernstPlanck.h, TransportGrid.h.
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0, vtkImageData; unless MembraneNormal is a
 * coordinate axis, its values are interpolated trilinearly from the grid. 1, vtkTable of
 * cross-sections.
 *
 * Accuracy: rotating molecule and membrane together, or the molecule about the axis, changes the
 * current by up to 0.75 % at the default Spacing and 0.15 % at half of it.
 *
 * If the iteration does not converge within MaximumIterations, a warning reports its last change,
 * and the state that changed least is returned, with `Converged` 0; likewise if ions are not
 * conserved to 1e-4 because a linear system could not be solved.
 *
 * **Errors** (message, empty outputs): those of the atoms, parameters out of range, baths that
 * carry a charge, a channel that is not open from bath to bath (with the place where it closes and
 * its radius there), a surface that is not closed, has parts that cross (ShellCrossings.h), lies
 * elsewhere than the atoms (InputOverlap.h) or leaves more than half of the charged atoms outside
 * (fewer are a warning), a grid that does not fit into memory. Cost: about 40 to 75 microseconds
 * for each node. All atoms are needed on one rank.
 *
 * @sa vtkIonTransportMovingSurface
 */
#ifndef vtkIonTransport_h
#define vtkIonTransport_h

#include "Atoms/AtomProperties.h"
#include "Core/ArrayProperty.h"
#include "Core/OutputArrays.h"
#include "Solvation/IonTransportParameters.h"
#include "vtkImageAlgorithm.h"
#include "vtkIsthmusFiltersSolvationModule.h" // for the export macro

#include <memory> // for the input that RequestInformation() needs
#include <string> // for names
#include <vector> // for the table of output arrays

class vtkTable;

namespace isthmus
{
class ChannelSolution;
class InputInAdvance;
struct ChannelProblem;
struct MoleculeAtoms;
}

class VTKISTHMUSFILTERSSOLVATION_EXPORT vtkIonTransport : public vtkImageAlgorithm
{
public:
  static vtkIonTransport* New();
  vtkTypeMacro(vtkIonTransport, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the radii, `Radius` by default, input array 1 that of the
  /// charges, `Charge`.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  ///@{
  /// The ions: valence, concentrations (mol/l) in the bath below (that the normal points away from)
  /// and above, diffusion coefficient (1e-9 m^2/s), and the fraction of it that applies within the
  /// slab of the membrane. Default: potassium and chloride, 0.1 mol/l on both sides, diffusion
  /// coefficients 1.96 and 2.03, and a fraction of 1 in the channel.
  void AddSpecies(
    double valence, double below, double above, double diffusion, double channelFraction = 1.0);
  void ClearSpecies();
  int GetNumberOfSpecies();
  ///@}

  ///@{
  /// Names of the species in arrays and columns, separated by blanks or commas; those without a
  /// name are `Ion1`, `Ion2`, ... Default "K Cl".
  vtkSetMacro(SpeciesNames, std::string);
  vtkGetMacro(SpeciesNames, std::string);
  ///@}

  ///@{
  /// Potential of the bath below minus that of the bath above, in mV. A positive voltage drives
  /// cations along the normal. Default 100.
  ISTHMUS_PARAMETER(Voltage, double);
  ///@}

  ///@{
  /// A point in the middle of the membrane and on the channel's axis, the axis' direction (of any
  /// length), the thickness of the membrane, and the radius of the hole in it around the axis; in
  /// angstrom. A warning is given if water reaches the hole's rim from one side of the membrane to
  /// the other, although there are atoms in the hole. Defaults (0, 0, 0), (0, 0, 1), 24, 5.
  ISTHMUS_PARAMETER_VECTOR3(MembraneCenter, double);
  ISTHMUS_PARAMETER_VECTOR3(MembraneNormal, double);
  ISTHMUS_PARAMETER(MembraneThickness, double);
  ISTHMUS_PARAMETER(LumenRadius, double);
  ///@}

  ///@{
  /// Radius of the probe for the solvent-excluded surface, in angstrom; 0 for the atoms themselves.
  /// Default 1, because the radius 1.4 of water closes the pore of gramicidin.
  ISTHMUS_PARAMETER(ProbeRadius, double);
  ///@}

  ///@{
  /// Spacing of the grid, in angstrom. Default 0.5.
  ISTHMUS_PARAMETER(Spacing, double);
  ///@}

  ///@{
  /// Extent of the baths beyond atoms and membrane, along the axis and away from it, in angstrom;
  /// at least two spacings. Default 8.
  ISTHMUS_PARAMETER(Padding, double);
  ///@}

  ///@{
  /// Dielectric constants, the first of atoms and membrane. Defaults 2 and 80.
  ISTHMUS_PARAMETER(SoluteDielectric, double);
  ISTHMUS_PARAMETER(SolventDielectric, double);
  ///@}

  ///@{
  /// Temperature in kelvin. Default 298.15.
  ISTHMUS_PARAMETER(Temperature, double);
  ///@}

  ///@{
  /// The iteration has converged when the potential changes by less than this value (kT/e)
  /// everywhere in the water; it always ends after MaximumIterations. Defaults 1e-4 and 100.
  ISTHMUS_PARAMETER(Tolerance, double);
  ISTHMUS_PARAMETER(MaximumIterations, int);
  ///@}

  /// Output 1.
  vtkTable* GetSections();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// IncludeWaters and UnitedAtoms determine which atoms are used, and their radii; see
  /// AtomProperties.h. Default off and on.
  ISTHMUS_ATOM_PROPERTIES();

protected:
  vtkIonTransport();
  ~vtkIonTransport() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /// For subclasses whose surface moves: adds to the problem of one execution.
  virtual void CompleteProblem(
    vtkDataObject* input, const isthmus::MoleculeAtoms& atoms, isthmus::ChannelProblem& problem);
  /// For subclasses: adds to output 0, and fills further outputs. Returns a warning, or "".
  virtual std::string FillMotion(const isthmus::ChannelSolution& channel, vtkImageData* image,
    vtkInformationVector* outputVector);

private:
  vtkIonTransport(const vtkIonTransport&) = delete;
  void operator=(const vtkIonTransport&) = delete;

  class vtkInternals; ///< functions of one execution

  std::string SpeciesNames = "K Cl";
  isthmus::IonTransportParameters Parameters;
  std::unique_ptr<isthmus::InputInAdvance> Advance;
};

#endif
