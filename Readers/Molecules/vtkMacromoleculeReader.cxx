#include "vtkMacromoleculeReader.h"

#include "Core/NumberText.h"
#include "Core/PrintableText.h"
#include "Files/ReaderGuard.h"
#include "Molecules/MacromoleculeReader.h"
#include "Molecules/MoleculeOutput.h"

#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMolecule.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMacromoleculeReader);

using Pipeline = vtkStreamingDemandDrivenPipeline;

/// The number of models, and the first one where counting has parsed it and no output has it yet.
struct vtkMacromoleculeReader::CountedModels
{
  std::string File;
  long Changed = 0; ///< time of the file's last change
  unsigned long Bytes = 0;
  int Format = ByName;
  std::int64_t Number = 1;
  isthmus::Macromolecule Parsed;

  bool IsOf(const std::string& file, int format) const
  {
    return file == this->File && format == this->Format &&
      vtksys::SystemTools::ModifiedTime(file) == this->Changed &&
      vtksys::SystemTools::FileLength(file) == this->Bytes;
  }
};

vtkMacromoleculeReader::vtkMacromoleculeReader()
  : Counted(std::make_unique<CountedModels>())
{
  this->SetNumberOfInputPorts(0);
  this->SetNumberOfOutputPorts(2);
}

vtkMacromoleculeReader::~vtkMacromoleculeReader()
{
  this->SetFileName(nullptr);
}

int vtkMacromoleculeReader::FillOutputPortInformation(int port, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), port == 0 ? "vtkPolyData" : "vtkMolecule");
  return 1;
}

vtkMolecule* vtkMacromoleculeReader::GetMolecule()
{
  return vtkMolecule::SafeDownCast(this->GetOutputDataObject(1));
}

int vtkMacromoleculeReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeMolecule);
}

int vtkMacromoleculeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const bool inTime = this->ModelsAsTimeSteps && this->ModelIndex == 0;
  if (inTime)
  {
    this->CountModels();
  }
  const std::int64_t models = inTime ? this->Counted->Number : 1;
  std::vector<double> times(static_cast<std::size_t>(models));
  std::iota(times.begin(), times.end(), 0.0);
  for (int port = 0; port < 2; ++port)
  {
    vtkInformation* info = outputVector->GetInformationObject(port);
    info->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
    if (models > 1)
    {
      const double range[2] = { times.front(), times.back() };
      info->Set(Pipeline::TIME_STEPS(), times.data(), static_cast<int>(models));
      info->Set(Pipeline::TIME_RANGE(), range, 2);
    }
    else
    {
      info->Remove(Pipeline::TIME_STEPS());
      info->Remove(Pipeline::TIME_RANGE());
    }
  }
  return 1;
}

/// 1 also for what can't be read: RequestData says why.
void vtkMacromoleculeReader::CountModels()
{
  CountedModels& counted = *this->Counted;
  if (!this->FileName || counted.IsOf(this->FileName, this->Format))
  {
    counted.Number = this->FileName ? counted.Number : 1;
    return;
  }
  counted = { this->FileName, vtksys::SystemTools::ModifiedTime(this->FileName),
    vtksys::SystemTools::FileLength(this->FileName), this->Format, 1, {} };
  try
  {
    counted.Number = isthmus::CountModels(
      counted.File, static_cast<isthmus::MoleculeFormat>(this->Format), &counted.Parsed);
  }
  catch (const std::exception&)
  {
  }
}

/// The model of the time that is asked for, where models are time steps; else ModelIndex.
std::int64_t vtkMacromoleculeReader::ModelOf(vtkInformation* request)
{
  if (!request->Has(Pipeline::UPDATE_TIME_STEP()) || !request->Has(Pipeline::TIME_STEPS()))
  {
    return this->ModelIndex;
  }
  const double last = static_cast<double>(request->Length(Pipeline::TIME_STEPS()) - 1);
  const double time = request->Get(Pipeline::UPDATE_TIME_STEP());
  return std::isnan(time) ? 0 : std::llround(std::clamp(time, 0.0, last));
}

int vtkMacromoleculeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  auto* atoms = vtkPolyData::GetData(outputVector, 0);
  auto* molecule = vtkMolecule::SafeDownCast(vtkDataObject::GetData(outputVector, 1));
  vtkInformation* request = outputVector->GetInformationObject(0);
  if (request->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    this->Counted->Parsed = {};
    return 1; // the first rank has the molecule
  }
  const int result = isthmus::GuardedRead(
    this, this->FileName, atoms, [this](unsigned long code) { this->SetErrorCode(code); },
    [&] { this->Read(this->ModelOf(request), atoms, molecule); });
  if (request->Has(Pipeline::UPDATE_TIME_STEP()) && request->Has(Pipeline::TIME_STEPS()))
  {
    for (vtkDataObject* output : std::initializer_list<vtkDataObject*>{ atoms, molecule })
    {
      output->GetInformation()->Set(
        vtkDataObject::DATA_TIME_STEP(), request->Get(Pipeline::UPDATE_TIME_STEP()));
    }
  }
  if (atoms->GetNumberOfPoints() == 0)
  {
    molecule->Initialize();
  }
  return result;
}

void vtkMacromoleculeReader::Read(std::int64_t model, vtkPolyData* atoms, vtkMolecule* molecule)
{
  isthmus::MoleculeOptions options;
  options.Format = static_cast<isthmus::MoleculeFormat>(this->Format);
  options.Model = model;
  options.Assembly = this->Assembly;
  options.Chains = this->Chains;
  options.AltLoc = this->AltLoc;
  options.Hetero = this->ReadHetero;
  options.Water = this->ReadWater;
  options.Radii = static_cast<isthmus::RadiusTable>(this->RadiusTable);
  options.BondsByDistance = this->BondsByDistance;
  const auto progress = isthmus::ProgressOf(this);
  const auto reading = isthmus::Between(progress, 0.0, 0.8);
  isthmus::Macromolecule parsed = std::exchange(this->Counted->Parsed, {});
  const bool isParsed = !parsed.Atoms.empty() && model == 0 && options.Assembly.empty() &&
    this->Counted->IsOf(this->FileName, this->Format);
  const auto read = isParsed
    ? isthmus::CompleteMacromolecule(std::move(parsed), this->FileName, options, reading)
    : isthmus::ReadMacromolecule(this->FileName, options, reading);
  isthmus::FillOutputs(read, this->AltLoc == "*", atoms, molecule);
  isthmus::Report(progress, 1.0);
  std::string all; // one message, however many faults there are
  for (const std::string& warning : read.Warnings)
  {
    all += (all.empty() ? "" : " ") + warning;
  }
  if (!all.empty())
  {
    vtkWarningMacro(<< isthmus::TextOf(this->FileName, ": ", isthmus::Printable(all)));
  }
}

void vtkMacromoleculeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "ModelIndex: " << this->ModelIndex << "\n";
  os << indent << "ModelsAsTimeSteps: " << this->ModelsAsTimeSteps << "\n";
  os << indent << "Assembly: " << this->Assembly << "\n";
  os << indent << "Chains: " << this->Chains << "\n";
  os << indent << "AltLoc: " << this->AltLoc << "\n";
  os << indent << "ReadHetero: " << this->ReadHetero << "\n";
  os << indent << "ReadWater: " << this->ReadWater << "\n";
  os << indent << "RadiusTable: " << this->RadiusTable << "\n";
  os << indent << "BondsByDistance: " << this->BondsByDistance << "\n";
}
