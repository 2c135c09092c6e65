#include "vtkIonTransport.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/NumberText.h"
#include "Core/PipelineInputs.h"
#include "Electrostatics/PoissonBoltzmannInput.h"
#include "Solvation/ChannelSolution.h"
#include "Solvation/IonTransportArrays.h"
#include "Solvation/IonTransportOutput.h"

#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkTable.h>

#include <algorithm>

vtkStandardNewMacro(vtkIonTransport);

namespace
{

using isthmus::FormatNumber;

std::string NarrowChannelWarning(const isthmus::ChannelPassage& passage)
{
  const isthmus::Point3& at = passage.Bottleneck;
  return "At (" + FormatNumber(at[0]) + ", " + FormatNumber(at[1]) + ", " + FormatNumber(at[2]) +
    ") the channel has a radius of " + FormatNumber(passage.Radius) +
    " angstrom, less than the Spacing, so the current depends on the position of the grid. Choose "
    "a smaller Spacing.";
}

std::string OpenRimWarning(double radius)
{
  return "Ions pass beside the molecule: water reaches the rim of the membrane's hole, of radius " +
    FormatNumber(radius) +
    " angstrom, from one side of the membrane to the other. Choose a LumenRadius at which the rim "
    "lies within the molecule.";
}

std::string ConvergenceWarning(const isthmus::PoissonNernstPlanck& solution)
{
  const isthmus::IonTransportReport& report = solution.GetReport();
  const std::string start = "At " + FormatNumber(solution.GetVoltage()) + " mV ";
  if (report.Changes.back() > solution.GetParameters().Tolerance)
  {
    return start + "the potential still changed by " + FormatNumber(report.Changes.back()) +
      " kT/e after " + std::to_string(report.Iterations) +
      " iterations. The state that changed least is returned, with Converged 0: choose more "
      "MaximumIterations or a larger Tolerance.";
  }
  return start + "a fraction " + FormatNumber(report.Imbalance) +
    " of a current is not conserved along the channel: the equations of the ions could not be "
    "solved. The current state is returned, with Converged 0: choose a smaller Spacing or Voltage, "
    "or look for charges that touch the water.";
}

/// About atoms that were dropped or lie outside the surface, a channel narrower than the spacing, a
/// hole wider than the molecule, and convergence.
std::vector<std::string> Warnings(
  const isthmus::MoleculeAtoms& atoms, isthmus::ChannelSolution& channel)
{
  std::vector<std::string> warnings = atoms.Warnings;
  const isthmus::PoissonNernstPlanck& solution = channel.Get();
  if (!channel.GetSurfaceWarning().empty())
  {
    warnings.push_back(channel.GetSurfaceWarning());
  }
  if (channel.GetPassage().Radius < solution.GetParameters().Spacing)
  {
    warnings.push_back(NarrowChannelWarning(channel.GetPassage()));
  }
  if (channel.IsRimOpen())
  {
    warnings.push_back(OpenRimWarning(solution.GetParameters().LumenRadius));
  }
  if (!solution.GetReport().Converged)
  {
    warnings.push_back(ConvergenceWarning(solution));
  }
  return warnings;
}

}

/// Functions of one execution.
class vtkIonTransport::vtkInternals
{
public:
  explicit vtkInternals(vtkIonTransport* self)
    : Self(self)
  {
  }

  isthmus::MoleculeAtoms Balls(vtkDataObject* input) const
  {
    isthmus::AtomOptions options = isthmus::SelectWholeMolecule(
      isthmus::InputArrayName(this->Self, 0), this->Self->IncludeWaters, this->Self->UnitedAtoms);
    options.Missing = isthmus::MissingRadius::Refuse; // it has a charge
    return isthmus::ReadAtoms(input, options);
  }

  isthmus::ChannelProblem Problem(
    vtkInformationVector** inputs, const isthmus::MoleculeAtoms& atoms) const;
  void Solve(vtkInformationVector** inputs, const isthmus::MoleculeAtoms& atoms,
    vtkInformationVector* outputs) const;

  vtkIonTransport* Self;
};

isthmus::ChannelProblem vtkIonTransport::vtkInternals::Problem(
  vtkInformationVector** inputs, const isthmus::MoleculeAtoms& atoms) const
{
  vtkDataObject* const input = vtkDataObject::GetData(inputs[0]);
  isthmus::ChannelProblem problem;
  problem.Balls = atoms.Balls;
  problem.Charges = isthmus::MakeChargedAtoms(input, atoms, isthmus::InputArrayName(this->Self, 1));
  problem.Surface = vtkPolyData::GetData(inputs[1], 0);
  problem.Transport = this->Self->Parameters;
  isthmus::NameSpecies(this->Self->SpeciesNames, problem.Transport.Species);
  this->Self->CompleteProblem(input, atoms, problem);
  return problem;
}

void vtkIonTransport::vtkInternals::Solve(vtkInformationVector** inputs,
  const isthmus::MoleculeAtoms& atoms, vtkInformationVector* outputs) const
{
  const auto progress = isthmus::MakeProgress(this->Self);
  const isthmus::ChannelProblem problem = this->Problem(inputs, atoms);
  isthmus::ChannelSolution channel(problem, isthmus::Between(progress, 0.0, 0.7));
  const isthmus::PoissonNernstPlanck& solution = channel.Get();
  const isthmus::CurrentProfile currents = isthmus::ComputeCurrents(solution);
  const double error =
    isthmus::EstimateCurrentError(problem, channel, isthmus::Between(progress, 0.7, 0.9));
  vtkNew<vtkImageData> image;
  isthmus::FillTransportImage(solution, image, isthmus::Between(progress, 0.9, 1.0));
  isthmus::FillTransportNumbers(solution, currents, error, channel.GetPassage(), image);
  std::vector<std::string> warnings = Warnings(atoms, channel);
  warnings.push_back(this->Self->FillMotion(channel, image, outputs));
  std::vector<std::string> notes = atoms.Notes;
  notes.push_back("Current " + isthmus::FormatWithError(currents.Mean(), error, "pA") + ".");
  isthmus::AddNotes(notes, image);
  isthmus::FillSections(currents, problem.Transport.Species, vtkTable::GetData(outputs, 1));
  vtkImageData::GetData(outputs, 0)->ShallowCopy(image);
  for (const std::string& warning : warnings)
  {
    if (!warning.empty())
    {
      vtkWarningWithObjectMacro(this->Self, << warning);
    }
  }
}

const std::vector<isthmus::OutputArray>& vtkIonTransport::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    ISTHMUS_ION_TRANSPORT_ARRAY_ROWS,
  };
  return table;
}

vtkIonTransport::vtkIonTransport()
  : Advance(std::make_unique<isthmus::InputInAdvance>(this))
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(2);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
  this->SetInputArrayToProcess(1, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Charge");
}

vtkIonTransport::~vtkIonTransport() = default;

void vtkIonTransport::AddSpecies(
  double valence, double below, double above, double diffusion, double channelFraction)
{
  this->Parameters.Species.push_back({ "", valence, below, above, diffusion, channelFraction });
  this->Modified();
}

void vtkIonTransport::ClearSpecies()
{
  if (!this->Parameters.Species.empty())
  {
    this->Parameters.Species.clear();
    this->Modified();
  }
}

int vtkIonTransport::GetNumberOfSpecies()
{
  return static_cast<int>(this->Parameters.Species.size());
}

vtkTable* vtkIonTransport::GetSections()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(1));
}

void vtkIonTransport::CompleteProblem(
  vtkDataObject*, const isthmus::MoleculeAtoms&, isthmus::ChannelProblem&)
{
}

std::string vtkIonTransport::FillMotion(
  const isthmus::ChannelSolution&, vtkImageData*, vtkInformationVector*)
{
  return {};
}

int vtkIonTransport::FillInputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), port == 0 ? "vtkPointSet" : "vtkPolyData");
  if (port == 1)
  {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  return 1;
}

int vtkIonTransport::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkImageData" : "vtkTable");
  return 1;
}

int vtkIonTransport::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The extent of the image is required now, and depends on the atoms: update the input.
  this->Advance->Update();
  if (this->GetNumberOfInputConnections(1) > 0)
  {
    this->Advance->Update(1);
  }
  vtkInformation* outInfo = outputVector->GetInformationObject(0);
  isthmus::SetImageInformation(outInfo,
    [&](vtkImageData* image)
    {
      this->Advance->RequireOneRank(0, "atoms");
      const vtkInternals internals(this);
      const isthmus::MoleculeAtoms atoms = internals.Balls(vtkDataObject::GetData(inputVector[0]));
      if (!atoms.Balls.empty())
      {
        isthmus::SetImageGeometry(
          isthmus::ImageBox(isthmus::DomainAround(atoms.Balls, this->Parameters)), image);
      }
    });
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_DOUBLE, 1);
  return 1;
}

int vtkIonTransport::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // the requested extent of the image does not apply to the atoms
}

int vtkIonTransport::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      const vtkInternals internals(this);
      this->Advance->RequireOneRank(0, "atoms");
      this->Advance->RequireOneRank(1, "points of the surface");
      const isthmus::MoleculeAtoms atoms = internals.Balls(vtkDataObject::GetData(inputVector[0]));
      if (!atoms.Balls.empty())
      {
        internals.Solve(inputVector, atoms, outputVector);
      }
    });
}

void vtkIonTransport::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const auto list = [&](const char* name, const double* values, int count)
  {
    os << indent << name << ":";
    std::for_each(values, values + count, [&os](double value) { os << " " << value; });
    os << "\n";
  };
  os << indent << "Species: " << this->Parameters.Species.size() << "\n";
  os << indent << "SpeciesNames: " << this->SpeciesNames << "\n";
  os << indent << "Voltage: " << this->GetVoltage() << "\n";
  list("MembraneCenter", this->GetMembraneCenter(), 3);
  list("MembraneNormal", this->GetMembraneNormal(), 3);
  os << indent << "MembraneThickness: " << this->GetMembraneThickness() << "\n";
  os << indent << "LumenRadius: " << this->GetLumenRadius() << "\n";
  os << indent << "ProbeRadius: " << this->GetProbeRadius() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Padding: " << this->GetPadding() << "\n";
  os << indent << "SoluteDielectric: " << this->GetSoluteDielectric() << "\n";
  os << indent << "SolventDielectric: " << this->GetSolventDielectric() << "\n";
  os << indent << "Temperature: " << this->GetTemperature() << "\n";
  os << indent << "Tolerance: " << this->GetTolerance() << "\n";
  os << indent << "MaximumIterations: " << this->GetMaximumIterations() << "\n";
  this->PrintAtomProperties(os, indent);
}
