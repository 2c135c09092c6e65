#include "vtkMRCMapReader.h"

#include "Core/LargePages.h"
#include "Core/NumberText.h"
#include "Core/PrintableText.h"
#include "Files/GridInformation.h"
#include "Files/ReaderError.h"
#include "Files/ReaderGuard.h"
#include "Maps/MRCMap.h"
#include "Maps/RecommendedLevel.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

vtkStandardNewMacro(vtkMRCMapReader);

namespace
{

using namespace isthmus;

template <typename Array, typename T, std::size_t Size>
void Add(vtkFieldData* fields, const char* name, const std::array<T, Size>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(Size));
  array->InsertNextTypedTuple(values.data());
  fields->AddArray(array);
}

void AddNumber(vtkFieldData* fields, const char* name, int value)
{
  Add<vtkIntArray>(fields, name, std::array<int, 1>{ value });
}

void AddNumber(vtkFieldData* fields, const char* name, double value)
{
  Add<vtkDoubleArray>(fields, name, std::array<double, 1>{ value });
}

void AddTexts(vtkFieldData* fields, const char* name, const std::vector<std::string>& texts)
{
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  for (const std::string& text : texts)
  {
    array->InsertNextValue(text);
  }
  fields->AddArray(array);
}

std::string NameOf(MRCStack::Kind kind)
{
  return kind == MRCStack::Kind::None ? "none"
                                      : (kind == MRCStack::Kind::Images ? "images" : "volumes");
}

std::string Degrees(const std::array<double, 3>& angles)
{
  return isthmus::TextOf(angles[0], ", ", angles[1], ", ", angles[2]);
}

/// What a user should know about how this map was read, apart from repairs.
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
  return notes;
}

/// Adds the header's facts, header.Repairs and the notes to `fields`.
void AddMRCFieldData(const MRCMap& map, int volumeIndex, vtkFieldData* fields)
{
  const MRCHeader& header = map.Header();
  const MRCStack& stack = map.Stack();
  Add<vtkDoubleArray>(fields, "CellLengths", header.CellLengths);
  Add<vtkDoubleArray>(fields, "CellAngles", header.CellAngles);
  Add<vtkIntArray>(fields, "FileDimensions", header.Counts);
  Add<vtkIntArray>(fields, "FileStart", header.Start);
  Add<vtkIntArray>(fields, "CellSampling", header.Sampling);
  Add<vtkIntArray>(fields, "AxisOrder", header.AxisOrder);
  Add<vtkDoubleArray>(fields, "FileOrigin", header.Origin);
  AddNumber(fields, "Mode", header.Voxel.Mode);
  AddNumber(fields, "SpaceGroup", header.SpaceGroup);
  AddNumber(fields, "RecordedMinimum", header.Minimum);
  AddNumber(fields, "RecordedMaximum", header.Maximum);
  AddNumber(fields, "RecordedMean", header.Mean);
  AddNumber(fields, "RecordedRms", header.Rms);
  AddNumber(fields, "IsStack", stack.What == MRCStack::Kind::None ? 0 : 1);
  AddTexts(fields, "StackType", { NameOf(stack.What) });
  AddNumber(fields, "NumberOfVolumes", stack.Items);
  AddNumber(fields, "VolumeIndex", volumeIndex);
  AddNumber(fields, "ExtendedHeaderBytes", static_cast<int>(header.ExtendedHeaderBytes));
  AddTexts(fields, "ExtendedHeaderType", { header.ExtendedHeaderType });
  AddNumber(fields, "FormatVersion", header.Version);
  AddTexts(fields, "ByteOrder", { header.BigEndian ? "big endian" : "little endian" });
  AddTexts(fields, "Compression", { map.Compression() });
  AddTexts(fields, "LengthUnit", { "angstrom" });
  AddTexts(fields, "Labels", header.Labels);
  AddTexts(fields, "Repairs", header.Repairs);
  AddTexts(fields, "Notes", MRCNotes(map));
}

int ScalarTypeOf(isthmus::MRCValue value)
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

/// An array whose memory is not touched before it is filled; malloc, so that a want of memory ends
/// in a sentence with the size asked for.
vtkSmartPointer<vtkDataArray> NewArray(const char* name, int type, int components, vtkIdType tuples)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  const auto bytes = static_cast<std::size_t>(tuples) * static_cast<std::size_t>(components) *
    static_cast<std::size_t>(array->GetDataTypeSize());
  void* const memory = std::malloc(bytes);
  if (!memory)
  {
    throw std::runtime_error("There is no memory for the array " + std::string(name) + " of " +
      std::to_string(bytes >> 20) +
      " MiB. Read a part of the map (CropExtent) or every n-th node "
      "(SampleRate).");
  }
  isthmus::AdviseLargePages(memory, bytes);
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetVoidArray(memory, tuples * components, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  return array;
}

/// The direction matrix and origin that place `grid` in the world.
isthmus::GridInformation InformationOf(const isthmus::VoxelLattice& grid)
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

/// Opens the reader's file and selects what its properties ask for.
MRCMap Open(vtkMRCMapReader* reader)
{
  MRCMap map(reader->GetFileName());
  isthmus::MRCOptions options;
  options.VolumeIndex = reader->GetVolumeIndex();
  std::copy_n(reader->GetCropExtent(), 6, options.CropExtent.begin());
  std::copy_n(reader->GetSampleRate(), 3, options.SampleRate.begin());
  options.KeepCellAxes = reader->GetNonOrthogonalCell() == vtkMRCMapReader::KeepCellAxes;
  map.Select(options);
  return map;
}

std::string Sentences(const std::vector<std::string>& sentences)
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

int vtkMRCMapReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeMRCFile);
}

template <typename Body>
int vtkMRCMapReader::Try(vtkInformation* info, Body&& body)
{
  return isthmus::GuardedRead(
    this, this->FileName, vtkDataObject::GetData(info),
    [this](unsigned long code) { this->SetErrorCode(code); }, body);
}

void vtkMRCMapReader::Tell(const MRCMap& map)
{
  std::vector<std::string> sentences = map.Header().Repairs;
  if (this->Strict && !sentences.empty())
  {
    throw ReaderError(ReaderFailure::Damaged,
      std::string(this->FileName) + ": the header needs repair, which Strict forbids." +
        Sentences(sentences));
  }
  const std::vector<std::string> notes = MRCNotes(map);
  sentences.insert(sentences.end(), notes.begin(), notes.end());
  const std::string warning = std::string(this->FileName) + ":" + Sentences(sentences);
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
  isthmus::Describe({}, info); // what stays when the file can't be read
  return this->Try(info,
    [&]()
    {
      const MRCMap map = Open(this);
      this->Tell(map);
      isthmus::Describe(InformationOf(map.Grid()), info);
      const isthmus::MRCVoxelType& voxel = map.Header().Voxel;
      vtkDataObject::SetPointDataActiveScalarInfo(
        info, ScalarTypeOf(voxel.Value), voxel.Components);
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
      MRCMap map = Open(this);
      isthmus::RequireUnchanged(InformationOf(map.Grid()), info, this->FileName);
      AddMRCFieldData(map, this->VolumeIndex, output->GetFieldData());
      if (const auto level = isthmus::RecommendedLevel(this->FileName))
      {
        vtkNew<vtkDoubleArray> recommended;
        recommended->SetName("RecommendedLevel");
        recommended->InsertNextValue(*level);
        output->GetFieldData()->AddArray(recommended);
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
  const isthmus::ProgressCallback progress = isthmus::ProgressOf(this);
  const bool counted =
    map.CheckBeforeAllocating(map.OutputBytes(box), isthmus::Between(progress, 0.0, 0.5));
  const isthmus::MRCVoxelType& voxel = map.Header().Voxel;
  const vtkIdType nodes = output->GetNumberOfPoints();
  const auto density = NewArray("Density", ScalarTypeOf(voxel.Value), voxel.Components, nodes);
  vtkSmartPointer<vtkDataArray> inside;
  if (map.Resampled())
  {
    inside = NewArray("InsideMap", VTK_UNSIGNED_CHAR, 1, nodes);
  }
  map.Read(box, density->GetVoidPointer(0),
    inside ? static_cast<unsigned char*>(inside->GetVoidPointer(0)) : nullptr,
    isthmus::Between(progress, counted ? 0.5 : 0.0, 1.0));
  output->GetPointData()->SetScalars(density);
  if (inside)
  {
    output->GetPointData()->AddArray(inside);
  }
}

void vtkMRCMapReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "VolumeIndex: " << this->VolumeIndex << "\n";
  os << indent << "CropExtent:";
  for (const int node : this->CropExtent)
  {
    os << " " << node;
  }
  os << "\n"
     << indent << "SampleRate: " << this->SampleRate[0] << " " << this->SampleRate[1] << " "
     << this->SampleRate[2] << "\n";
  os << indent
     << "NonOrthogonalCell: " << (this->NonOrthogonalCell == Resample ? "Resample" : "KeepCellAxes")
     << "\n";
  os << indent << "Strict: " << (this->Strict ? "On" : "Off") << "\n";
}
