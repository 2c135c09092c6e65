#include "vtkMacromoleculeReader.h"

#include "MacromoleculeReader.h"
#include "MoleculeOutput.h"
#include "ReaderGuard.h"

#include <vtkErrorCode.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMolecule.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

vtkStandardNewMacro(vtkMacromoleculeReader);

vtkMacromoleculeReader::vtkMacromoleculeReader()
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
  return fileName && isthmus::LooksLikeMolecule(fileName) ? 1 : 0;
}

int vtkMacromoleculeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  for (int port = 0; port < 2; ++port)
  {
    outputVector->GetInformationObject(port)->Set(CAN_HANDLE_PIECE_REQUEST(), 1);
  }
  return 1;
}

int vtkMacromoleculeReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  auto* atoms = vtkPolyData::GetData(outputVector, 0);
  auto* molecule = vtkMolecule::SafeDownCast(vtkDataObject::GetData(outputVector, 1));
  vtkInformation* request = outputVector->GetInformationObject(0);
  if (request->Get(vtkStreamingDemandDrivenPipeline::UPDATE_PIECE_NUMBER()) > 0)
  {
    return 1; // the first rank has the molecule
  }
  const int result = isthmus::GuardedRead(
    this, this->FileName, atoms, [this](unsigned long code) { this->SetErrorCode(code); },
    [&] { this->Read(atoms, molecule); });
  if (atoms->GetNumberOfPoints() == 0)
  {
    molecule->Initialize();
  }
  if (!result && this->GetErrorCode() == vtkErrorCode::NoError)
  {
    this->SetErrorCode(vtkErrorCode::FileFormatError);
  }
  return result;
}

void vtkMacromoleculeReader::Read(vtkPolyData* atoms, vtkMolecule* molecule)
{
  isthmus::MoleculeOptions options;
  options.Format = static_cast<isthmus::MoleculeFormat>(this->Format);
  options.Model = this->ModelIndex;
  options.Chains = this->Chains;
  options.AltLoc = this->AltLoc;
  options.Hetero = this->ReadHetero;
  options.Water = this->ReadWater;
  options.Radii = static_cast<isthmus::RadiusTable>(this->RadiusTable);
  options.BondsByDistance = this->BondsByDistance;
  const auto progress = isthmus::ProgressOf(this);
  const auto read =
    isthmus::ReadMacromolecule(this->FileName, options, isthmus::Between(progress, 0.0, 0.8));
  isthmus::FillAtoms(read, this->AltLoc == "*", atoms);
  isthmus::Report(progress, 0.9);
  isthmus::FillMolecule(read, atoms, molecule);
  isthmus::Report(progress, 1.0);
  for (const std::string& warning : read.Warnings)
  {
    vtkWarningMacro(<< this->FileName << ": " << isthmus::Printable(warning));
  }
}

void vtkMacromoleculeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Format: " << this->Format << "\n";
  os << indent << "ModelIndex: " << this->ModelIndex << "\n";
  os << indent << "Chains: " << this->Chains << "\n";
  os << indent << "AltLoc: " << this->AltLoc << "\n";
  os << indent << "ReadHetero: " << this->ReadHetero << "\n";
  os << indent << "ReadWater: " << this->ReadWater << "\n";
  os << indent << "RadiusTable: " << this->RadiusTable << "\n";
  os << indent << "BondsByDistance: " << this->BondsByDistance << "\n";
}
