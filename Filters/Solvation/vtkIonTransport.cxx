#include "vtkIonTransport.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/PipelineInputs.h"
#include "Core/RangeChecks.h"
#include "Electrostatics/PoissonBoltzmannInput.h"
#include "MolecularSurfaces/DispersionAtoms.h"
#include "Solvation/ChannelSolution.h"
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

using isthmus::ChannelPassage;
using isthmus::FormatNumber;
using isthmus::MovingChannel;
using isthmus::TransportPoint;

std::string NarrowChannel(const ChannelPassage& passage)
{
  const isthmus::Point3& at = passage.Bottleneck;
  return "At (" + FormatNumber(at[0]) + ", " + FormatNumber(at[1]) + ", " + FormatNumber(at[2]) +
    ") the channel has a radius of " + FormatNumber(passage.Radius) +
    " angstrom, less than a Spacing: the current depends on the position of the nodes there. "
    "Choose a "
    "smaller "
    "Spacing.";
}

std::string IterationNotConverged(const TransportPoint& point, double tolerance)
{
  const isthmus::IonTransportReport& report = point.Report;
  const std::string start = "At " + FormatNumber(point.Voltage) + " mV ";
  if (report.Changes.back() > tolerance)
  {
    return start + "the potential still changed by " + FormatNumber(report.Changes.back()) +
      " kT/e after " + std::to_string(report.Iterations) +
      " iterations. The state that changed least is kept, with Converged 0: choose more "
      "MaximumIterations or a larger Tolerance.";
  }
  return start + "a part of " + FormatNumber(report.Imbalance) +
    " of a current is lost on its way: the equations of the ions could not be solved. The current "
    "state is kept, with Converged 0: choose a smaller Spacing or Voltage, or look for charges "
    "that touch the water.";
}

std::string SurfaceNotConverged(const MovingChannel& moving)
{
  return "The surface has not converged after " + std::to_string(moving.GetUpdates().size()) +
    " updates: currents or water still changed by a part of " + FormatNumber(moving.LastChange()) +
    ". Update " + std::to_string(moving.GetShown() + 1) +
    ", which changed least, is kept, with Rests 0: choose more MaximumUpdates, a larger "
    "UpdateTolerance, or a smaller FieldRelaxation.";
}

/// Atoms that were left out or lie outside the surface, a channel narrower than a spacing, the
/// first point that has not converged or has lost ions on their way, a surface that has not
/// converged.
std::vector<std::string> Warnings(const isthmus::MoleculeAtoms& atoms,
  isthmus::ChannelSolution& channel, const std::vector<TransportPoint>& points)
{
  std::vector<std::string> sentences = atoms.Warnings;
  const isthmus::IonTransportParameters& parameters = channel.Get().GetParameters();
  if (!channel.GetSurfaceWarning().empty())
  {
    sentences.push_back(channel.GetSurfaceWarning());
  }
  if (channel.GetPassage().Radius < parameters.Spacing)
  {
    sentences.push_back(NarrowChannel(channel.GetPassage()));
  }
  const auto left = std::find_if(points.begin(), points.end(),
    [](const TransportPoint& point) { return !point.Report.Converged; });
  if (left != points.end())
  {
    sentences.push_back(IterationNotConverged(*left, parameters.Tolerance));
  }
  if (channel.GetMoving() && !channel.GetMoving()->HasConverged())
  {
    sentences.push_back(SurfaceNotConverged(*channel.GetMoving()));
  }
  return sentences;
}

}

/// What one execution works with.
class vtkIonTransport::vtkInternals
{
public:
  explicit vtkInternals(vtkIonTransport* self)
    : Self(self)
  {
  }

  isthmus::MoleculeAtoms Balls(vtkDataObject* input) const
  {
    isthmus::AtomOptions options = isthmus::WholeMolecule(
      isthmus::InputArrayName(this->Self, 0), this->Self->IncludeWaters, this->Self->UnitedAtoms);
    options.Missing = isthmus::MissingRadius::Refuse; // it has a charge
    return isthmus::ReadAtoms(input, options);
  }

  isthmus::IonTransportParameters Named() const;
  isthmus::ChannelProblem Problem(
    vtkInformationVector** inputs, const isthmus::MoleculeAtoms& atoms) const;
  std::vector<TransportPoint> Points() const;
  void Solve(vtkInformationVector** inputs, const isthmus::MoleculeAtoms& atoms,
    vtkInformationVector* outputs) const;

  vtkIonTransport* Self;
};

/// With the names of the species.
isthmus::IonTransportParameters vtkIonTransport::vtkInternals::Named() const
{
  isthmus::IonTransportParameters p = this->Self->Parameters;
  isthmus::NameSpecies(this->Self->SpeciesNames, p.Species);
  return p;
}

std::vector<TransportPoint> vtkIonTransport::vtkInternals::Points() const
{
  const vtkIonTransport* self = this->Self;
  isthmus::RequireRange("SweepOf", self->SweepOf, NoSweep, Concentrations);
  switch (self->SweepOf)
  {
    case Voltages:
      return isthmus::SweptVoltages(
        self->SweepVoltages[0], self->SweepVoltages[1], self->SweepPoints);
    case Concentrations:
      return isthmus::SweptFactors(
        self->SweepFactors[0], self->SweepFactors[1], self->SweepPoints, self->Parameters.Voltage);
    default:
      return {};
  }
}

isthmus::ChannelProblem vtkIonTransport::vtkInternals::Problem(
  vtkInformationVector** inputs, const isthmus::MoleculeAtoms& atoms) const
{
  vtkDataObject* const input = vtkDataObject::GetData(inputs[0]);
  isthmus::ChannelProblem problem;
  problem.Balls = atoms.Balls;
  problem.Charges = isthmus::ChargedAtomsOf(input, atoms, isthmus::InputArrayName(this->Self, 1));
  problem.Surface = vtkPolyData::GetData(inputs[1], 0);
  problem.Transport = this->Named();
  problem.Moves = this->Self->MovingSurface;
  if (problem.Moves)
  {
    problem.Attracting = isthmus::DispersionAtomsOf(input, atoms);
    problem.Motion = this->Self->Motion;
  }
  return problem;
}

void vtkIonTransport::vtkInternals::Solve(vtkInformationVector** inputs,
  const isthmus::MoleculeAtoms& atoms, vtkInformationVector* outputs) const
{
  const auto progress = isthmus::ProgressOf(this->Self);
  std::vector<TransportPoint> points = this->Points();
  const isthmus::ChannelProblem problem = this->Problem(inputs, atoms);
  const std::vector<isthmus::TransportSpecies>& species = problem.Transport.Species;
  const double part = 0.9 / static_cast<double>(points.size() + 1);
  isthmus::ChannelSolution channel(problem, isthmus::Between(progress, 0.0, part));
  isthmus::PoissonNernstPlanck& solution = channel.Get();
  TransportPoint shown = isthmus::PointOf(solution);
  vtkNew<vtkImageData> image;
  isthmus::FillTransportImage(solution, image, isthmus::Between(progress, part, part + 0.05));
  isthmus::FillTransportNumbers(shown, species, channel.GetPassage(), image);
  isthmus::FillMotion(channel.GetMoving(), species, image, vtkTable::GetData(outputs, 3));
  if (!atoms.Notes.empty()) // ParaView interprets an empty array as the end of field data
  {
    isthmus::AddNotes(atoms.Notes, image);
  }
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const double from = 0.05 + part * static_cast<double>(i + 1);
    isthmus::SolveAt(points[i], solution, isthmus::Between(progress, from, from + part));
  }
  isthmus::FillSections(shown.Profile, species, vtkTable::GetData(outputs, 1));
  isthmus::FillSweep(points.empty() ? std::vector<TransportPoint>{ shown } : points, species,
    vtkTable::GetData(outputs, 2));
  vtkImageData::GetData(outputs, 0)->ShallowCopy(image);
  points.insert(points.begin(), shown);
  for (const std::string& sentence : Warnings(atoms, channel, points))
  {
    vtkWarningWithObjectMacro(this->Self, << sentence);
  }
}

vtkIonTransport::vtkIonTransport()
  : Advance(std::make_unique<isthmus::InputInAdvance>(this))
{
  this->SetNumberOfInputPorts(2);
  this->SetNumberOfOutputPorts(4);
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

vtkTable* vtkIonTransport::GetSweep()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

vtkTable* vtkIonTransport::GetUpdates()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(3));
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
  // The extent of the image must be reported now, and depends on the atoms, so they are updated.
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
  return 1; // the extent requested of the image does not apply to the atoms
}

int vtkIonTransport::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  isthmus::ClearOutputs(outputVector);
  return isthmus::Guarded(this, outputVector,
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
  os << indent << "SweepOf: " << this->SweepOf << "\n";
  os << indent << "SweepPoints: " << this->SweepPoints << "\n";
  list("SweepVoltages", this->SweepVoltages, 2);
  list("SweepFactors", this->SweepFactors, 2);
  os << indent << "MovingSurface: " << this->MovingSurface << "\n";
  this->PrintSolventProperties(os, indent);
  os << indent << "UpdatePeriod: " << this->GetUpdatePeriod() << "\n";
  os << indent << "SurfaceRelaxation: " << this->GetSurfaceRelaxation() << "\n";
  os << indent << "FieldRelaxation: " << this->GetFieldRelaxation() << "\n";
  os << indent << "UpdateTolerance: " << this->GetUpdateTolerance() << "\n";
  os << indent << "MaximumUpdates: " << this->GetMaximumUpdates() << "\n";
  this->PrintAtomProperties(os, indent);
}
