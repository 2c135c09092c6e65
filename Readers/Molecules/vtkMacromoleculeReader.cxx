#include "vtkMacromoleculeReader.h"
#include "Core/Cached.h"

#include "Core/NumberText.h"
#include "Core/PrintableText.h"
#include "Files/ReaderGuard.h"
#include "Molecules/MacromoleculeReader.h"
#include "Molecules/MoleculeOutput.h"
#include "Molecules/MoleculeParsers.h"

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
#include <tuple>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkMacromoleculeReader);

const std::vector<isthmus::OutputArray>& vtkMacromoleculeReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { -1, ArrayPlace::Points, "Radius", 1, "angstrom", ArrayChoice::None,
      "van der Waals radius, the file's (PQR) or that of RadiusTable; NaN: none" },
    { -1, ArrayPlace::Points, "Charge", 1, "e", ArrayChoice::None,
      "the file's (PQR, PDBQT, MOL2), or its formal charge (PDB, mmCIF) where not 0; NaN: none" },
    { -1, ArrayPlace::Points, "Element", 1, "", ArrayChoice::None,
      "atomic number; 0: unknown or none (beads, ghost and dummy atoms)" },
    { -1, ArrayPlace::Points, "AtomName", 1, "", ArrayChoice::None,
      "the authors' name (auth_ of mmCIF)" },
    { -1, ArrayPlace::Points, "ResidueName", 1, "", ArrayChoice::None,
      "the authors' name; empty: none" },
    { -1, ArrayPlace::Points, "Chain", 1, "", ArrayChoice::None, "the authors' name; empty: none" },
    { -1, ArrayPlace::Points, "ResidueId", 1, "", ArrayChoice::None,
      "the authors' residue number" },
    { -1, ArrayPlace::Points, "BFactor", 1, "angstrom^2", ArrayChoice::None, "NaN: none" },
    { -1, ArrayPlace::Points, "Occupancy", 1, "", ArrayChoice::None, "NaN: none" },
    { -1, ArrayPlace::Points, "IsHetero", 1, "", ArrayChoice::None, "1: a HETATM record" },
    { -1, ArrayPlace::Points, "InsertionCode", 1, "", ArrayChoice::None,
      "of the residue; where the file has any" },
    { -1, ArrayPlace::Points, "AltLoc", 1, "", ArrayChoice::None,
      "alternate location; with AltLoc *, where the file has any" },
    { -1, ArrayPlace::Points, "pLDDT", 1, "", ArrayChoice::None,
      "confidence of predicted residues, 0 to 100; by ModelCIF, or the B factors of PDB files "
      "whose "
      "title names AlphaFold, ESMFold, ColabFold or OpenFold" },
    { -1, ArrayPlace::Points, "SecondaryStructure", 1, "", ArrayChoice::None,
      "by HELIX and SHEET, or struct_conf and struct_sheet_range: 0 coil, 1 alpha helix, 2 "
      "strand, 3 3-10 helix, 4 pi helix; where the file has it, not of an assembly" },
    { 0, ArrayPlace::Cells, "BondSource", 1, "", ArrayChoice::None,
      "0 vertex, 1 bond named by the file (CONECT, SSBOND, LINK, struct_conn), 2 bond by "
      "distance" },
    { 1, ArrayPlace::Points, "Atomic Numbers", 1, "", ArrayChoice::None,
      "the same as Element, for VTK's molecule mappers" },
    { 1, ArrayPlace::Cells, "Bond Orders", 1, "", ArrayChoice::None, "1: orders are not known" },
    { -1, ArrayPlace::Field, "NumberOfModels", 1, "", ArrayChoice::None, "of the file" },
    { -1, ArrayPlace::Field, "ElementSymbols", 1, "", ArrayChoice::None,
      "of Element: text 6 is C" },
    { -1, ArrayPlace::Field, "CellVectors", 3, "angstrom", ArrayChoice::None,
      "the vectors a, b and c of the periodic cell; where the file has one" },
    { -1, ArrayPlace::Field, "SpaceGroup", 1, "", ArrayChoice::None,
      "Hermann-Mauguin symbol; where the file has a cell and names it" },
    { -1, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "what was dropped or changed, one message each" },
    { -1, ArrayPlace::Field, "Warnings", 1, "", ArrayChoice::None,
      "what is missing or doubtful, one message each" },
  };
  return table;
}

using Pipeline = vtkStreamingDemandDrivenPipeline;

class vtkMacromoleculeReader::vtkInternals
{
public:
  /// Path, time of the last change, bytes, format, whether models are combined.
  using Key = std::tuple<std::string, long, unsigned long, isthmus::MoleculeFormat,
    isthmus::ModelCombination>;
  struct Counted
  {
    std::int64_t Number = 1;
    isthmus::Macromolecule Parsed; ///< the first model, if counting has parsed it, until it is read
  };
  isthmus::Cached<Key, Counted> Models;

  static Key MakeKey(const std::string& file, const isthmus::MoleculeOptions& options)
  {
    return { file, vtksys::SystemTools::ModifiedTime(file), vtksys::SystemTools::FileLength(file),
      options.Format, options.CombineModels };
  }
};

vtkMacromoleculeReader::vtkMacromoleculeReader()
  : Internals(std::make_unique<vtkInternals>())
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

const char* vtkMacromoleculeReader::GetFileExtensions()
{
  return isthmus::MoleculeEndings().c_str();
}

int vtkMacromoleculeReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  const bool inTime = this->ModelsAsTimeSteps && this->Parameters.ModelIndex == 0;
  const std::int64_t models = inTime ? this->CountModels() : 1;
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

/// 1 also for files that cannot be read: RequestData reports the reason.
std::int64_t vtkMacromoleculeReader::CountModels()
{
  if (!this->FileName)
  {
    return 1;
  }
  const auto count = [this]
  {
    vtkInternals::Counted counted;
    try
    {
      counted.Number = isthmus::CountModels(
        this->FileName, this->Parameters.Format, &counted.Parsed, this->Parameters.CombineModels);
    }
    catch (const std::exception&)
    {
    }
    return counted;
  };
  return this->Internals->Models.Get(vtkInternals::MakeKey(this->FileName, this->Parameters), count)
    .Number;
}

/// The model of the requested time if models are time steps, otherwise ModelIndex.
std::int64_t vtkMacromoleculeReader::GetModel(vtkInformation* request)
{
  if (!request->Has(Pipeline::UPDATE_TIME_STEP()) || !request->Has(Pipeline::TIME_STEPS()))
  {
    return this->Parameters.ModelIndex;
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
    if (vtkInternals::Counted* counted = this->Internals->Models.Last())
    {
      counted->Parsed = {};
    }
    return 1; // the first rank has the molecule
  }
  const int result = isthmus::ReadGuarded(
    this, this->FileName, atoms, [this](unsigned long code) { this->SetErrorCode(code); },
    [&] { this->Read(this->GetModel(request), atoms, molecule); });
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
  isthmus::MoleculeOptions options = this->Parameters;
  options.ModelIndex = model;
  const auto progress = isthmus::MakeProgress(this);
  const auto reading = isthmus::Between(progress, 0.0, 0.8);
  vtkInternals::Counted* const counted =
    this->Internals->Models.Find(vtkInternals::MakeKey(this->FileName, this->Parameters));
  if (!counted)
  {
    this->Internals->Models.Clear(); // of another file
  }
  isthmus::Macromolecule parsed =
    counted ? std::exchange(counted->Parsed, {}) : isthmus::Macromolecule();
  const bool isParsed = !parsed.Atoms.empty() && model == 0 && options.Assembly.empty();
  const auto read = isParsed
    ? isthmus::CompleteMacromolecule(std::move(parsed), this->FileName, options, reading)
    : isthmus::ReadMacromolecule(this->FileName, options, reading);
  isthmus::FillOutputs(read, options.AltLoc == "*", atoms, molecule);
  isthmus::Report(progress, 1.0);
  std::string all; // one message, however many faults there are
  for (const std::string& warning : read.Warnings)
  {
    all += (all.empty() ? "" : " ") + warning;
  }
  if (!all.empty())
  {
    vtkWarningMacro(<< isthmus::JoinText(this->FileName, ": ", isthmus::Printable(all)));
  }
}

void vtkMacromoleculeReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Format: " << this->GetFormat() << "\n";
  os << indent << "LengthUnit: " << this->GetLengthUnit() << "\n";
  os << indent << "CombineModels: " << this->GetCombineModels() << "\n";
  os << indent << "ModelIndex: " << this->GetModelIndex() << "\n";
  os << indent << "ModelsAsTimeSteps: " << this->ModelsAsTimeSteps << "\n";
  os << indent << "Assembly: " << this->GetAssembly() << "\n";
  os << indent << "Chains: " << this->GetChains() << "\n";
  os << indent << "AltLoc: " << this->GetAltLoc() << "\n";
  os << indent << "ReadHetero: " << this->GetReadHetero() << "\n";
  os << indent << "ReadWater: " << this->GetReadWater() << "\n";
  os << indent << "RadiusTable: " << this->GetRadiusTable() << "\n";
  os << indent << "BondsByDistance: " << this->GetBondsByDistance() << "\n";
}
