#include "vtkMolecularFlowSurface.h"

#include "Atoms/MoleculeAtoms.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ImageExtent.h"
#include "Core/InnerAlgorithm.h"
#include "Core/NumberText.h"
#include "Core/PipelineInputs.h"
#include "MolecularSurfaces/DispersionAtoms.h"
#include "MolecularSurfaces/FlowSurfaceOutput.h"
#include "MolecularSurfaces/SolventExcludedSurface.h"
#include "MolecularSurfaces/SurfaceFlow.h"
#include "MolecularSurfaces/ThesisFlow.h"
#include "vtkDelaunayIsosurface.h"

#include <vtkAlgorithmOutput.h>
#include <vtkDataObject.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>
#include <vtkTable.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMolecularFlowSurface);

namespace
{

using isthmus::MoleculeAtoms;
using isthmus::SurfaceFlowParameters;
using isthmus::SurfaceFlowResult;
using Pipeline = vtkStreamingDemandDrivenPipeline;

/// 0 and `steps` more, equally far apart, to `whole` (square angstrom); none for values that
/// Check() refuses, or if `input` has time steps.
std::vector<double> FlowTimes(int steps, double whole, vtkInformation* input)
{
  std::vector<double> times;
  if (steps > 0 && steps <= 10000 && whole > 0.0 && std::isfinite(whole) &&
    !input->Has(Pipeline::TIME_STEPS()))
  {
    for (int step = 0; step <= steps; ++step)
    {
      times.push_back(whole * step / steps);
    }
  }
  return times;
}

/// Sets these time steps in an output's information; without any, removes earlier ones, unless
/// they are those of `input`.
void SetTimes(const std::vector<double>& times, vtkInformation* input, vtkInformation* output)
{
  if (!times.empty())
  {
    const double range[2] = { times.front(), times.back() };
    output->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(times.size()));
    output->Set(Pipeline::TIME_RANGE(), range, 2);
  }
  else if (!input->Has(Pipeline::TIME_STEPS()))
  {
    output->Remove(Pipeline::TIME_STEPS());
    output->Remove(Pipeline::TIME_RANGE());
  }
}

/// The one of `times` (not empty) nearest to the time requested of `output`, the last one where no
/// time is requested.
double RequestedTime(const std::vector<double>& times, vtkInformation* output)
{
  if (!output->Has(Pipeline::UPDATE_TIME_STEP()))
  {
    return times.back();
  }
  const double wanted = output->Get(Pipeline::UPDATE_TIME_STEP());
  return *std::min_element(times.begin(), times.end(),
    [wanted](double a, double b) { return std::abs(a - wanted) < std::abs(b - wanted); });
}

}

/// The data of one execution.
class vtkMolecularFlowSurface::vtkInternals
{
public:
  explicit vtkInternals(vtkMolecularFlowSurface* self)
    : Self(self)
  {
  }

  MoleculeAtoms Atoms(vtkDataObject* input) const;
  std::vector<double> Times(vtkInformation* input) const;
  SurfaceFlowResult Flow(const MoleculeAtoms& atoms, vtkDataObject* input, double time,
    const isthmus::ProgressCallback& progress) const;
  void Warn(const MoleculeAtoms& atoms, const SurfaceFlowResult& result) const;
  void Surface(vtkImageData* image, bool ofS, vtkPolyData* surface) const;

  /// The distance of the Level outside of the flow's surface, in angstrom.
  double Offset() const
  {
    const isthmus::MolecularFlowParameters& p = this->Self->Parameters;
    return isthmus::HalfWidthOfS * p.Spacing * (1.0 - 2.0 * p.Level);
  }

  vtkMolecularFlowSurface* Self;
};

MoleculeAtoms vtkMolecularFlowSurface::vtkInternals::Atoms(vtkDataObject* input) const
{
  return isthmus::ReadAtoms(input,
    isthmus::SelectWholeMolecule(
      isthmus::InputArrayName(this->Self, 0), this->Self->IncludeWaters, this->Self->UnitedAtoms));
}

/// The times of the flow that can be requested; none if the pipeline's time is not that of the
/// flow.
std::vector<double> vtkMolecularFlowSurface::vtkInternals::Times(vtkInformation* input) const
{
  const isthmus::MolecularFlowParameters& p = this->Self->Parameters;
  const SurfaceFlowParameters flow = p.Flow();
  const bool flows = !flow.Steady && p.Method != isthmus::FlowMethod::SolventExcluded;
  return FlowTimes(flows ? p.TimeSteps : 0, flow.EvolutionTime, input);
}

SurfaceFlowResult vtkMolecularFlowSurface::vtkInternals::Flow(const MoleculeAtoms& atoms,
  vtkDataObject* input, double time, const isthmus::ProgressCallback& progress) const
{
  const isthmus::MolecularFlowParameters& p = this->Self->Parameters;
  SurfaceFlowParameters parameters = p.Flow();
  parameters.EvolutionTime = time;
  if (p.Method == isthmus::FlowMethod::ThesisFlow)
  {
    return isthmus::ThesisFlow(atoms.Balls, parameters, progress);
  }
  if (p.Method == isthmus::FlowMethod::SolventExcluded)
  {
    return isthmus::SolventExcludedSurface(atoms.Balls, parameters, progress);
  }
  isthmus::PullField pull;
  if (p.Solvent)
  {
    pull = isthmus::SolventPull(isthmus::MakeDispersionAtoms(input, atoms), p);
  }
  return isthmus::SurfaceFlow(atoms.Balls, parameters, pull, progress);
}

void vtkMolecularFlowSurface::vtkInternals::Warn(
  const MoleculeAtoms& atoms, const SurfaceFlowResult& result) const
{
  for (const std::string& warning : atoms.Warnings)
  {
    vtkWarningWithObjectMacro(this->Self, << warning);
  }
  if (!result.Converged)
  {
    vtkWarningWithObjectMacro(this->Self,
      << isthmus::JoinText("The surface still moves after ", result.History.back().Time,
           " square angstrom of flow: parts of it are larger than the steady flow is designed "
           "for. The last state is shown."));
  }
}

void vtkMolecularFlowSurface::vtkInternals::Surface(
  vtkImageData* image, bool ofS, vtkPolyData* surface) const
{
  const isthmus::MolecularFlowParameters& p = this->Self->Parameters;
  isthmus::ContourImage(image, ofS, p.Level, this->Offset(), surface);
  if (surface->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("The surface vanishes at a Level of " +
      isthmus::FormatNumber(p.Level) +
      ": nothing lies that deep inside. Choose a lower one, or a smaller Spacing.");
  }
  if (!p.DelaunayQuality)
  {
    return;
  }
  vtkNew<vtkDelaunayIsosurface> delaunay;
  delaunay->SetInputData(image);
  delaunay->SetInputArrayToProcess(
    0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, ofS ? "S" : "SignedDistance");
  delaunay->SetLevel(ofS ? p.Level : this->Offset());
  delaunay->SetInsideIsHigher(ofS);
  try
  {
    isthmus::UpdateInner(delaunay, isthmus::Between(isthmus::MakeProgress(this->Self), 0.9, 1.0),
      [this](const std::string& warning) { vtkWarningWithObjectMacro(this->Self, << warning); });
  }
  catch (const isthmus::Cancelled&)
  {
    throw;
  }
  catch (const std::runtime_error& error)
  {
    throw std::runtime_error("Delaunay refinement of the surface failed: " +
      std::string(error.what()) + " Or switch DelaunayQuality off.");
  }
  if (delaunay->GetOutput()->GetNumberOfPoints() == 0)
  {
    throw std::runtime_error("Delaunay refinement of the surface found nothing: switch "
                             "DelaunayQuality off, or choose another Spacing.");
  }
  surface->ShallowCopy(delaunay->GetOutput());
}

const std::vector<isthmus::OutputArray>& vtkMolecularFlowSurface::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None, "unit, outwards" },
    { 1, ArrayPlace::Points, "SignedDistance", 1, "angstrom", ArrayChoice::None,
      "negative inside; exact to second order within 4.5 spacings of the surface, cut there" },
    { 1, ArrayPlace::Points, "S", 1, "", ArrayChoice::None,
      "from 0 to 1, 1/2 on the surface, over 2.4 spacings" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "about atoms that were dropped and radii that were assigned" },
    { 1, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "about atoms that were dropped and radii that were assigned" },
    { 2, ArrayPlace::Rows, "Time", 1, "angstrom^2", ArrayChoice::None, "of the flow" },
    { 2, ArrayPlace::Rows, "Spacing", 1, "angstrom", ArrayChoice::None,
      "of the grid on which it ran" },
    { 2, ArrayPlace::Rows, "Area", 1, "angstrom^2", ArrayChoice::None, "of the surface" },
    { 2, ArrayPlace::Rows, "Volume", 1, "angstrom^3", ArrayChoice::None, "enclosed" },
    { 2, ArrayPlace::Rows, "Energy", 1, "kcal/mol", ArrayChoice::None,
      "SurfaceTension x Area, with Solvent also + Pressure x Volume" },
  };
  return table;
}

vtkMolecularFlowSurface::vtkMolecularFlowSurface()
  : Advance(std::make_unique<isthmus::InputInAdvance>(this))
{
  this->SetNumberOfOutputPorts(3);
  this->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Radius");
}

vtkMolecularFlowSurface::~vtkMolecularFlowSurface() = default;

vtkImageData* vtkMolecularFlowSurface::GetImage()
{
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(1));
}

vtkTable* vtkMolecularFlowSurface::GetHistory()
{
  return vtkTable::SafeDownCast(this->GetOutputDataObject(2));
}

int vtkMolecularFlowSurface::FillInputPortInformation(int, vtkInformation* info)
{
  info->Remove(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE());
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMolecule");
  return 1;
}

int vtkMolecularFlowSurface::FillOutputPortInformation(int port, vtkInformation* info)
{
  const char* types[] = { "vtkPolyData", "vtkImageData", "vtkTable" };
  info->Set(vtkDataObject::DATA_TYPE_NAME(), types[port]);
  return 1;
}

int vtkMolecularFlowSurface::RequestInformation(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  // The extent of the image must be reported now, and depends on the atoms, so they are updated.
  this->Advance->Update();
  vtkInformation* outInfo = outputVector->GetInformationObject(1);
  isthmus::SetImageInformation(outInfo,
    [&](vtkImageData* image)
    {
      this->Advance->RequireOneRank(0, "atoms");
      const MoleculeAtoms atoms = vtkInternals(this).Atoms(vtkDataObject::GetData(inputVector[0]));
      if (!atoms.Balls.empty())
      {
        isthmus::SetImageGeometry(
          isthmus::FlowResultGrid(atoms.Balls, this->Parameters.Flow()), image);
      }
    });
  vtkDataObject::SetPointDataActiveScalarInfo(outInfo, VTK_FLOAT, 1);
  vtkInformation* input = inputVector[0]->GetInformationObject(0);
  for (int port = 0; port < 3; ++port)
  {
    SetTimes(vtkInternals(this).Times(input), input, outputVector->GetInformationObject(port));
  }
  return 1;
}

int vtkMolecularFlowSurface::RequestUpdateExtent(
  vtkInformation*, vtkInformationVector**, vtkInformationVector*)
{
  return 1; // the extent requested of the image does not apply to the atoms
}

int vtkMolecularFlowSurface::RequestData(
  vtkInformation* request, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* surface = vtkPolyData::GetData(outputVector, 0);
  vtkImageData* image = vtkImageData::GetData(outputVector, 1);
  vtkTable* history = vtkTable::GetData(outputVector, 2);
  isthmus::ClearOutputs(outputVector);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      const vtkInternals internals(this);
      isthmus::Check(this->Parameters);
      vtkDataObject* input = vtkDataObject::GetData(inputVector[0]);
      this->Advance->RequireOneRank(0, "atoms");
      const MoleculeAtoms atoms = internals.Atoms(input);
      const auto progress = isthmus::MakeProgress(this);
      const std::vector<double> times = internals.Times(inputVector[0]->GetInformationObject(0));
      const int port = std::max(0, request->Get(Pipeline::FROM_OUTPUT_PORT()));
      const double time = times.empty()
        ? this->Parameters.Flow().EvolutionTime
        : RequestedTime(times, outputVector->GetInformationObject(port));
      const SurfaceFlowResult result =
        internals.Flow(atoms, input, time, isthmus::Between(progress, 0.0, 0.85));
      if (atoms.Balls.empty())
      {
        return;
      }
      vtkNew<vtkImageData> made;
      isthmus::FillImage(result, internals.Offset(), made);
      isthmus::Report(progress, 0.9);
      internals.Surface(made, !result.S.empty(), surface);
      isthmus::Report(progress, 1.0);
      internals.Warn(atoms, result);
      image->ShallowCopy(made);
      isthmus::FillHistory(result, this->Parameters.SurfaceTension,
        this->Parameters.Solvent ? this->Parameters.Pressure : 0.0, history);
      for (vtkDataObject* output : { static_cast<vtkDataObject*>(surface),
             static_cast<vtkDataObject*>(image), static_cast<vtkDataObject*>(history) })
      {
        if (!atoms.Notes.empty()) // ParaView interprets an empty array as the end of field data
        {
          isthmus::AddNotes(atoms.Notes, output);
        }
        if (!times.empty())
        {
          output->GetInformation()->Set(vtkDataObject::DATA_TIME_STEP(), time);
        }
      }
    });
}

void vtkMolecularFlowSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Preset: " << this->GetPreset() << "\n";
  os << indent << "Method: " << this->GetMethod() << "\n";
  os << indent << "Enlargement: " << this->GetEnlargement() << "\n";
  os << indent << "EvolutionTime: " << this->GetEvolutionTime() << "\n";
  os << indent << "Steady: " << this->GetSteady() << "\n";
  os << indent << "ProbeRadius: " << this->GetProbeRadius() << "\n";
  os << indent << "Spacing: " << this->GetSpacing() << "\n";
  os << indent << "Padding: " << this->GetPadding() << "\n";
  os << indent << "Level: " << this->GetLevel() << "\n";
  os << indent << "CoarseToFine: " << this->GetCoarseToFine() << "\n";
  os << indent << "Solvent: " << this->GetSolvent() << "\n";
  this->PrintSolventProperties(os, indent);
  os << indent << "DelaunayQuality: " << this->GetDelaunayQuality() << "\n";
  this->PrintAtomProperties(os, indent);
  os << indent << "TimeSteps: " << this->GetTimeSteps() << "\n";
}
