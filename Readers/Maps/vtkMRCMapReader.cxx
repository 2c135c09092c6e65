#include "vtkMRCMapReader.h"

#include "Core/LargePages.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PrintableText.h"
#include "Files/GridInformation.h"
#include "Files/ReaderError.h"
#include "Files/ReaderGuard.h"
#include "Maps/MRCMap.h"
#include "Maps/NoData.h"
#include "Maps/RecommendedLevel.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>

#include <algorithm>
#include <array>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMRCMapReader);

const std::vector<isthmus::OutputArray>& vtkMRCMapReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Density", 0, "", ArrayChoice::None,
      "the values; 2 components of modes 3 and 4, 3 of mode 16" },
    { 0, ArrayPlace::Points, "InsideMap", 1, "", ArrayChoice::None,
      "1 where the map has values, else 0; of a cell that is not orthogonal, if it is resampled" },
    { 0, ArrayPlace::Points, "NoData", 1, "", ArrayChoice::None,
      "1 at values that stand for \"no data\", else 0; missing if there are none" },
    { 0, ArrayPlace::Field, "NoDataValue", 1, "", ArrayChoice::None,
      "the value that stands for \"no data\"; missing if there is none" },
    { 0, ArrayPlace::Field, "RecommendedLevel", 1, "of Density", ArrayChoice::None,
      "level of the surface, from emd-NNNN.xml beside the file; missing without it" },
    { 0, ArrayPlace::Field, "CellLengths", 3, "angstrom", ArrayChoice::None, "CELLA" },
    { 0, ArrayPlace::Field, "CellAngles", 3, "degrees", ArrayChoice::None, "CELLB" },
    { 0, ArrayPlace::Field, "FileDimensions", 3, "", ArrayChoice::None, "NX, NY, NZ" },
    { 0, ArrayPlace::Field, "FileStart", 3, "", ArrayChoice::None, "NXSTART, NYSTART, NZSTART" },
    { 0, ArrayPlace::Field, "CellSampling", 3, "", ArrayChoice::None, "MX, MY, MZ" },
    { 0, ArrayPlace::Field, "AxisOrder", 3, "", ArrayChoice::None, "MAPC, MAPR, MAPS" },
    { 0, ArrayPlace::Field, "FileOrigin", 3, "angstrom", ArrayChoice::None, "ORIGIN" },
    { 0, ArrayPlace::Field, "Mode", 1, "", ArrayChoice::None, "MODE" },
    { 0, ArrayPlace::Field, "SpaceGroup", 1, "", ArrayChoice::None, "ISPG" },
    { 0, ArrayPlace::Field, "RecordedMinimum", 1, "of Density", ArrayChoice::None,
      "DMIN in the header, which may be wrong" },
    { 0, ArrayPlace::Field, "RecordedMaximum", 1, "of Density", ArrayChoice::None,
      "DMAX in the header, which may be wrong" },
    { 0, ArrayPlace::Field, "RecordedMean", 1, "of Density", ArrayChoice::None,
      "DMEAN in the header, which may be wrong" },
    { 0, ArrayPlace::Field, "RecordedRms", 1, "of Density", ArrayChoice::None,
      "RMS in the header, which may be wrong" },
    { 0, ArrayPlace::Field, "IsStack", 1, "", ArrayChoice::None, "0 or 1" },
    { 0, ArrayPlace::Field, "StackType", 1, "", ArrayChoice::None, "none, images or volumes" },
    { 0, ArrayPlace::Field, "NumberOfVolumes", 1, "", ArrayChoice::None,
      "volumes or images of a stack" },
    { 0, ArrayPlace::Field, "VolumeIndex", 1, "", ArrayChoice::None,
      "of the volume that was read" },
    { 0, ArrayPlace::Field, "ExtendedHeaderBytes", 1, "bytes", ArrayChoice::None, "NSYMBT" },
    { 0, ArrayPlace::Field, "ExtendedHeaderType", 1, "", ArrayChoice::None, "EXTTYP" },
    { 0, ArrayPlace::Field, "FormatVersion", 1, "", ArrayChoice::None, "NVERSION" },
    { 0, ArrayPlace::Field, "ByteOrder", 1, "", ArrayChoice::None, "of the file" },
    { 0, ArrayPlace::Field, "Compression", 1, "", ArrayChoice::None, "of the file" },
    { 0, ArrayPlace::Field, "LengthUnit", 1, "", ArrayChoice::None, "angstrom" },
    { 0, ArrayPlace::Field, "Labels", 1, "", ArrayChoice::None, "texts of the header" },
    { 0, ArrayPlace::Field, "Repairs", 1, "", ArrayChoice::None,
      "values of the header that had to be replaced" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "what else is unusual about the file" },
  };
  return table;
}

namespace
{

using namespace isthmus;

std::string FormatName(MRCStack::Kind kind)
{
  return kind == MRCStack::Kind::None ? "none"
                                      : (kind == MRCStack::Kind::Images ? "images" : "volumes");
}

std::string Degrees(const std::array<double, 3>& angles)
{
  return isthmus::JoinText(angles[0], ", ", angles[1], ", ", angles[2]);
}

/// Notes on how this map was read, apart from repairs.
std::vector<std::string> MRCNotes(const MRCMap& map)
{
  std::vector<std::string> notes;
  const MRCHeader& header = map.Header();
  if (header.Voxel.Mode == 3 || header.Voxel.Mode == 4)
  {
    notes.push_back("Mode " + std::to_string(header.Voxel.Mode) +
      " is a Fourier transform: components are its real and imaginary part as stored (often half "
      "of the transform; the other half is not filled in from Hermitian symmetry).");
  }
  if (!HasOrthogonalCell(header))
  {
    notes.push_back("The cell angles are " + Degrees(header.CellAngles) + " degrees: " +
      (map.Resampled()
          ? "resampled to an orthogonal grid by trilinear interpolation; nodes outside the map "
            "are 0, as is the array InsideMap there."
          : "shown with right angles as chosen (KeepCellAxes), so shapes and positions are "
            "distorted."));
  }
  constexpr double finest = 0.1; // angstrom, below the spacing of any measured map
  std::array<double, 3> spacing;
  for (std::size_t a = 0; a < 3; ++a)
  {
    spacing[a] = header.CellLengths[a] / header.Sampling[a];
  }
  const double least = *std::min_element(spacing.begin(), spacing.end());
  if (least < finest)
  {
    notes.push_back("The spacing is " + isthmus::FormatNumber(least, 3) +
      " angstrom, less than measured maps have: the cell (words 11-13) may be that of one voxel, "
      "or "
      "in nanometres. If so, correct the header, or scale the map (Transform).");
  }
  return notes;
}

/// Adds the header's facts, header.Repairs and the notes to `fields`.
void AddMRCFieldData(const MRCMap& map, int volumeIndex, vtkFieldData* fields)
{
  const MRCHeader& header = map.Header();
  const MRCStack& stack = map.Stack();
  AddTuple<vtkDoubleArray>(fields, "CellLengths", header.CellLengths);
  AddTuple<vtkDoubleArray>(fields, "CellAngles", header.CellAngles);
  AddTuple<vtkIntArray>(fields, "FileDimensions", header.Counts);
  AddTuple<vtkIntArray>(fields, "FileStart", header.Start);
  AddTuple<vtkIntArray>(fields, "CellSampling", header.Sampling);
  AddTuple<vtkIntArray>(fields, "AxisOrder", header.AxisOrder);
  AddTuple<vtkDoubleArray>(fields, "FileOrigin", header.Origin);
  AddColumn<vtkIntArray>(fields, "Mode", { header.Voxel.Mode });
  AddColumn<vtkIntArray>(fields, "SpaceGroup", { header.SpaceGroup });
  AddColumn<vtkDoubleArray>(fields, "RecordedMinimum", { header.Minimum });
  AddColumn<vtkDoubleArray>(fields, "RecordedMaximum", { header.Maximum });
  AddColumn<vtkDoubleArray>(fields, "RecordedMean", { header.Mean });
  AddColumn<vtkDoubleArray>(fields, "RecordedRms", { header.Rms });
  AddColumn<vtkIntArray>(fields, "IsStack", { stack.What == MRCStack::Kind::None ? 0 : 1 });
  AddColumn<vtkStringArray>(fields, "StackType", { FormatName(stack.What) });
  AddColumn<vtkIntArray>(fields, "NumberOfVolumes", { stack.Items });
  AddColumn<vtkIntArray>(fields, "VolumeIndex", { volumeIndex });
  AddColumn<vtkIntArray>(
    fields, "ExtendedHeaderBytes", { static_cast<int>(header.ExtendedHeaderBytes) });
  AddColumn<vtkStringArray>(fields, "ExtendedHeaderType", { header.ExtendedHeaderType });
  AddColumn<vtkIntArray>(fields, "FormatVersion", { header.Version });
  AddColumn<vtkStringArray>(
    fields, "ByteOrder", { header.BigEndian ? "big endian" : "little endian" });
  AddColumn<vtkStringArray>(fields, "Compression", { map.Compression() });
  AddColumn<vtkStringArray>(fields, "LengthUnit", { "angstrom" });
  AddColumn<vtkStringArray>(fields, "Labels", header.Labels);
  AddColumn<vtkStringArray>(fields, "Repairs", header.Repairs);
  AddColumn<vtkStringArray>(fields, "Notes", MRCNotes(map));
}

int GetScalarType(isthmus::MRCValue value)
{
  switch (value)
  {
    case isthmus::MRCValue::SignedChar:
      return VTK_SIGNED_CHAR;
    case isthmus::MRCValue::UnsignedChar:
      return VTK_UNSIGNED_CHAR;
    case isthmus::MRCValue::Short:
      return VTK_SHORT;
    case isthmus::MRCValue::UnsignedShort:
      return VTK_UNSIGNED_SHORT;
    case isthmus::MRCValue::Float:
      break;
  }
  return VTK_FLOAT;
}

/// An array of voxels. Without memory, the error message states the size that was requested.
vtkSmartPointer<vtkDataArray> VoxelArray(
  const char* name, int type, int components, vtkIdType nodes)
try
{
  auto array = ArrayOfType(type, name, nodes, components);
  AdviseLargePages(array.Get());
  return array;
}
catch (const std::bad_alloc&)
{
  const vtkIdType bytes = nodes * components * vtkDataArray::GetDataTypeSize(type);
  throw std::runtime_error("There is no memory for the array " + std::string(name) + " of " +
    std::to_string(bytes >> 20) +
    " MiB. Read a part of the map (CropExtent) or every n-th node (SampleRate).");
}

void AddNote(vtkFieldData* fields, const std::string& note)
{
  vtkStringArray::SafeDownCast(fields->GetAbstractArray("Notes"))->InsertNextValue(note);
}

/// Replaces a value that stands for "no data", if there is one, and adds the mask `NoData`.
void MarkNoData(vtkDataArray* density, vtkImageData* output)
{
  const auto as = [&](auto type)
  {
    using T = decltype(type);
    T* values = static_cast<T*>(density->GetVoidPointer(0));
    const vtkIdType nodes = density->GetNumberOfTuples();
    const std::optional<T> noData = isthmus::FindNoDataValue(values, nodes);
    if (!noData)
    {
      return;
    }
    const auto mask = VoxelArray("NoData", VTK_UNSIGNED_CHAR, 1, nodes);
    const isthmus::NoDataReplacement done = isthmus::ReplaceNoData(
      values, nodes, *noData, static_cast<unsigned char*>(mask->GetVoidPointer(0)));
    output->GetPointData()->AddArray(mask);
    AddColumn<vtkDoubleArray>(
      output->GetFieldData(), "NoDataValue", { static_cast<double>(*noData) });
    AddNote(output->GetFieldData(),
      isthmus::JoinText(done.Voxels, " of ", nodes, " voxels have the value ",
        isthmus::FormatNumber(static_cast<double>(*noData), 6),
        ", far from all others, which stands for \"no data\": they "
        "are marked in the array NoData, and their value is ",
        done.By, " here."));
  };
  switch (density->GetDataType())
  {
    case VTK_SIGNED_CHAR:
      return as(static_cast<signed char>(0));
    case VTK_UNSIGNED_CHAR:
      return as(static_cast<unsigned char>(0));
    case VTK_SHORT:
      return as(short(0));
    case VTK_UNSIGNED_SHORT:
      return as(static_cast<unsigned short>(0));
    default:
      return as(0.0f);
  }
}

/// The direction matrix and origin that place `grid` in the world.
isthmus::GridInformation MakeGridInformation(const isthmus::VoxelLattice& grid)
{
  isthmus::GridInformation information;
  information.Dimensions = grid.Dimensions;
  information.Spacing = grid.Spacing();
  information.Origin = grid.World(grid.Origin);
  for (std::size_t a = 0; a < 3; ++a)
  {
    std::copy(grid.Rotation[a].begin(), grid.Rotation[a].end(), &information.Direction[3 * a]);
  }
  return information;
}

/// Opens the file and selects the part requested by the options.
MRCMap Open(const char* path, const isthmus::MRCOptions& options)
{
  MRCMap map(path);
  map.Select(options);
  return map;
}

std::string JoinMessages(const std::vector<std::string>& sentences)
{
  std::string text;
  for (const std::string& sentence : sentences)
  {
    text += "\n- " + sentence;
  }
  return text;
}

}

vtkMRCMapReader::vtkMRCMapReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkMRCMapReader::~vtkMRCMapReader()
{
  this->SetFileName(nullptr);
}

void vtkMRCMapReader::SetCropExtent(int x0, int x1, int y0, int y1, int z0, int z1)
{
  const std::array<int, 6> extent{ x0, x1, y0, y1, z0, z1 };
  if (this->Parameters.CropExtent != extent)
  {
    this->Parameters.CropExtent = extent;
    this->Modified();
  }
}

void vtkMRCMapReader::SetCropExtent(const int extent[6])
{
  this->SetCropExtent(extent[0], extent[1], extent[2], extent[3], extent[4], extent[5]);
}

int vtkMRCMapReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName,
    [](const std::string& path)
    { return isthmus::LooksLikeMRCFile(path) || isthmus::IsNamedAsMRCFile(path); });
}

template <typename Body>
int vtkMRCMapReader::Try(vtkInformation* info, Body&& body)
{
  return isthmus::ReadGuarded(
    this, this->FileName, vtkDataObject::GetData(info),
    [this](unsigned long code) { this->SetErrorCode(code); }, body);
}

void vtkMRCMapReader::ReportNotes(const MRCMap& map)
{
  std::vector<std::string> sentences = map.Header().Repairs;
  if (this->Strict && !sentences.empty())
  {
    throw ReaderError(ReaderFailure::Damaged,
      std::string(this->FileName) + ": the header needs repair, which Strict forbids." +
        JoinMessages(sentences));
  }
  const std::vector<std::string> notes = MRCNotes(map);
  sentences.insert(sentences.end(), notes.begin(), notes.end());
  const std::string warning = std::string(this->FileName) + ":" + JoinMessages(sentences);
  if (!sentences.empty() && warning != this->LastWarning)
  {
    vtkWarningMacro(<< isthmus::Printable(warning));
  }
  this->LastWarning = warning;
}

int vtkMRCMapReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  isthmus::Describe({}, info); // used if the file cannot be read
  return this->Try(info,
    [&]()
    {
      const MRCMap map = Open(this->FileName, this->Parameters);
      this->ReportNotes(map);
      isthmus::Describe(MakeGridInformation(map.Grid()), info);
      const isthmus::MRCVoxelType& voxel = map.OutputVoxel();
      vtkDataObject::SetPointDataActiveScalarInfo(
        info, GetScalarType(voxel.Value), voxel.Components);
      info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    });
}

int vtkMRCMapReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(info);
  return this->Try(info,
    [&]()
    {
      MRCMap map = Open(this->FileName, this->Parameters);
      isthmus::RequireUnchanged(MakeGridInformation(map.Grid()), info, this->FileName);
      AddMRCFieldData(map, this->Parameters.VolumeIndex, output->GetFieldData());
      if (const auto level = isthmus::RecommendedLevel(this->FileName))
      {
        vtkFieldData* fields = output->GetFieldData();
        AddColumn<vtkDoubleArray>(fields, "RecommendedLevel", { *level });
        AddNote(fields,
          isthmus::JoinText("Level ", *level,
            " is recommended for this map by its depositors, in the header file of its entry."));
      }
      isthmus::StartImage(info, output);
      if (output->GetNumberOfPoints() > 0)
      {
        this->ReadArrays(map, output->GetExtent(), output);
      }
    });
}

void vtkMRCMapReader::ReadArrays(MRCMap& map, const int extent[6], vtkImageData* output)
{
  isthmus::NodeBox box{};
  std::copy_n(extent, 6, box.begin());
  const isthmus::NodeBox whole = map.OutputBox();
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (box[2 * a] < 0 || box[2 * a + 1] > whole[2 * a + 1])
    {
      throw ReaderError(ReaderFailure::BadRequest,
        std::string(this->FileName) +
          ": the requested extent exceeds the map. If the "
          "file has changed, read it again.");
    }
  }
  const isthmus::ProgressCallback progress = isthmus::MakeProgress(this);
  const bool counted =
    map.CheckBeforeAllocating(map.OutputBytes(box), isthmus::Between(progress, 0.0, 0.5));
  const isthmus::MRCVoxelType& voxel = map.OutputVoxel();
  const vtkIdType nodes = output->GetNumberOfPoints();
  const auto density = VoxelArray("Density", GetScalarType(voxel.Value), voxel.Components, nodes);
  vtkSmartPointer<vtkDataArray> inside;
  if (map.Resampled())
  {
    inside = VoxelArray("InsideMap", VTK_UNSIGNED_CHAR, 1, nodes);
  }
  map.Read(box, density->GetVoidPointer(0),
    inside ? static_cast<unsigned char*>(inside->GetVoidPointer(0)) : nullptr,
    isthmus::Between(progress, counted ? 0.5 : 0.0, 1.0));
  output->GetPointData()->SetScalars(density);
  if (voxel.Components == 1)
  {
    MarkNoData(density, output);
  }
  if (inside)
  {
    output->GetPointData()->AddArray(inside);
  }
}

void vtkMRCMapReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "VolumeIndex: " << this->GetVolumeIndex() << "\n";
  os << indent << "CropExtent:";
  for (const int node : this->Parameters.CropExtent)
  {
    os << " " << node;
  }
  os << "\n"
     << indent << "SampleRate: " << this->GetSampleRate()[0] << " " << this->GetSampleRate()[1]
     << " " << this->GetSampleRate()[2] << "\n";
  os << indent << "NonOrthogonalCell: " << this->GetNonOrthogonalCell() << "\n";
  os << indent << "Strict: " << (this->Strict ? "On" : "Off") << "\n";
}
