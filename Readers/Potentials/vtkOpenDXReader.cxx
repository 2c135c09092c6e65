#include "vtkOpenDXReader.h"

#include "Core/Geometry.h"
#include "Core/LargePages.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/ParallelFor.h"
#include "Files/GridInformation.h"
#include "Files/ReaderError.h"
#include "Files/ReaderGuard.h"
#include "Potentials/OpenDXReader.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

vtkStandardNewMacro(vtkOpenDXReader);

const std::vector<isthmus::OutputArray>& vtkOpenDXReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Potential", 0, "", ArrayChoice::None,
      "the values, in the unit of the file (of APBS kT/e); ArrayName is another name for it" },
    { 0, ArrayPlace::Points, "InsideMap", 1, "", ArrayChoice::None,
      "1 inside the grid of the file, else 0; of skewed grids" },
    { 0, ArrayPlace::Field, "Comments", 1, "", ArrayChoice::None, "of the file, if it has any" },
    { 0, ArrayPlace::Field, "FieldName", 1, "", ArrayChoice::None, "of the file, if it has one" },
    { 0, ArrayPlace::Field, "Notes", 1, "", ArrayChoice::None,
      "texts of the warnings, if there are any" },
  };
  return table;
}

namespace
{

using isthmus::NodeBox;
using isthmus::OpenDXReader;
using isthmus::VoxelLattice;

bool IsOrthogonal(const VoxelLattice& lattice)
{
  const std::array<double, 3> length = lattice.Spacing();
  const double tolerance = std::sin(0.01 * isthmus::Pi / 180.0);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::size_t b = (a + 1) % 3;
    double product = 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      product += lattice.Steps[i][a] / length[a] * (lattice.Steps[i][b] / length[b]);
    }
    if (!(std::abs(product) <= tolerance))
    {
      return false;
    }
  }
  return true;
}

/// The grid of the output: the file's own, or an orthogonal one around it.
VoxelLattice ChooseTargetLattice(const OpenDXReader& file, const char* path)
{
  if (IsOrthogonal(file.Lattice()))
  {
    return file.Lattice();
  }
  try
  {
    return isthmus::GridAround(file.Lattice());
  }
  catch (const isthmus::ReaderError&)
  {
    throw isthmus::ReaderError(isthmus::ReaderFailure::Damaged,
      std::string(path) +
        ": the deltas are so oblique that an orthogonal grid around them would need more than 64 "
        "nodes for each of the file's. Check the delta rows.");
  }
}

NodeBox AllNodes(const VoxelLattice& lattice)
{
  const auto& n = lattice.Dimensions;
  return { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
}

/// The direction matrix holds the unit steps as its columns.
isthmus::GridInformation MakeGridInformation(const VoxelLattice& grid)
{
  isthmus::GridInformation information;
  information.Dimensions = grid.Dimensions;
  information.Spacing = grid.Spacing();
  information.Origin = grid.Origin;
  for (std::size_t a = 0; a < 3; ++a)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      information.Direction[3 * i + a] = grid.Steps[i][a] / information.Spacing[a];
    }
  }
  return information;
}

void AddTexts(vtkFieldData* fields, const char* name, const std::vector<std::string>& texts)
{
  std::vector<std::string> some;
  std::copy_if(texts.begin(), texts.end(), std::back_inserter(some),
    [](const std::string& text) { return !text.empty(); });
  if (!some.empty())
  {
    isthmus::AddColumn<vtkStringArray>(fields, name, some);
  }
}

template <typename T>
std::int64_t CountNotFinite(const T* values, std::int64_t count)
{
  return isthmus::ParallelReduce(count, 65536, std::int64_t{ 0 },
    [values](std::int64_t& partial, std::int64_t first, std::int64_t last)
    {
      partial +=
        std::count_if(values + first, values + last, [](T value) { return !std::isfinite(value); });
    });
}

/// Interpolates to the nodes `box` of `target`; what lies outside becomes NaN. Returns InsideMap.
template <typename T>
vtkSmartPointer<vtkUnsignedCharArray> ResampleArray(OpenDXReader& file, const VoxelLattice& target,
  const NodeBox& box, T* out, const isthmus::ProgressCallback& progress)
{
  const std::int64_t components = file.Array().Components;
  const NodeBox needed = isthmus::NodesNeeded(file.Lattice(), target, box);
  std::int64_t size = components;
  vtkIdType nodes = 1;
  for (std::size_t a = 0; a < 3; ++a)
  {
    size *= std::max<std::int64_t>(0, needed[2 * a + 1] - needed[2 * a] + 1);
    nodes *= box[2 * a + 1] - box[2 * a] + 1;
  }
  std::vector<T> values(static_cast<std::size_t>(size));
  file.Read(needed, values.data(), isthmus::Between(progress, 0.0, 0.7));
  auto inside =
    isthmus::NamedArray<vtkUnsignedCharArray>("InsideMap", static_cast<std::size_t>(nodes));
  isthmus::ResampleValues(file.Array().Components, file.Lattice(), values.data(), needed, target,
    box, out, inside->GetPointer(0), isthmus::Between(progress, 0.7, 1.0));
  for (vtkIdType i = 0; i < nodes; ++i)
  {
    if (!inside->GetValue(i))
    {
      std::fill_n(out + i * components, components, std::numeric_limits<T>::quiet_NaN());
    }
  }
  return inside;
}

}

vtkOpenDXReader::vtkOpenDXReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkOpenDXReader::~vtkOpenDXReader()
{
  this->SetFileName(nullptr);
}

int vtkOpenDXReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName, isthmus::LooksLikeOpenDXFile);
}

template <typename Body>
int vtkOpenDXReader::Try(vtkInformation* info, Body&& body)
{
  return isthmus::ReadGuarded(
    this, this->FileName, vtkDataObject::GetData(info),
    [this](unsigned long code) { this->SetErrorCode(code); }, body);
}

int vtkOpenDXReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  isthmus::Describe({}, info); // used if the file cannot be read
  return this->Try(info,
    [&]()
    {
      const OpenDXReader file(this->FileName, this->FieldIndex);
      const VoxelLattice grid = ChooseTargetLattice(file, this->FileName);
      isthmus::Describe(MakeGridInformation(grid), info);
      vtkDataObject::SetPointDataActiveScalarInfo(
        info, file.Array().Single ? VTK_FLOAT : VTK_DOUBLE, file.Array().Components);
      info->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    });
}

int vtkOpenDXReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* outputVector)
{
  vtkInformation* const info = outputVector->GetInformationObject(0);
  vtkImageData* const output = vtkImageData::GetData(info);
  return this->Try(info,
    [&]()
    {
      OpenDXReader file(
        this->FileName, this->FieldIndex, isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.2));
      isthmus::RequireUnchanged(
        MakeGridInformation(ChooseTargetLattice(file, this->FileName)), info, this->FileName);
      isthmus::StartImage(info, output);
      if (output->GetNumberOfPoints() > 0)
      {
        file.Array().Single ? this->ReadValues<vtkFloatArray>(file, output)
                            : this->ReadValues<vtkDoubleArray>(file, output);
      }
    });
}

template <typename Array>
void vtkOpenDXReader::ReadValues(OpenDXReader& file, vtkImageData* output)
{
  const isthmus::ProgressCallback progress =
    isthmus::Between(isthmus::MakeProgress(this), 0.2, 1.0);
  const VoxelLattice target = ChooseTargetLattice(file, this->FileName);
  NodeBox box{};
  std::copy_n(output->GetExtent(), 6, box.begin());
  const NodeBox all = AllNodes(target);
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (box[2 * a] < 0 || box[2 * a + 1] > all[2 * a + 1])
    {
      throw isthmus::ReaderError(isthmus::ReaderFailure::BadRequest,
        std::string(this->FileName) +
          ": the requested extent exceeds the grid. If the file has changed, read it "
          "again.");
    }
  }
  const auto values = isthmus::NamedArray<Array>(this->ArrayName,
    static_cast<std::size_t>(output->GetNumberOfPoints()), file.Array().Components);
  isthmus::AdviseLargePages(values.Get());
  std::string note;
  if (IsOrthogonal(file.Lattice()))
  {
    file.Read(box, values->GetPointer(0), progress);
    const auto notFinite = CountNotFinite(values->GetPointer(0), values->GetNumberOfValues());
    note = notFinite == 0 ? "" : std::to_string(notFinite) + " values are not finite numbers.";
  }
  else
  {
    output->GetPointData()->AddArray(
      ResampleArray(file, target, box, values->GetPointer(0), progress));
    note = "the deltas are skewed: the values are interpolated (trilinearly) to an orthogonal grid "
           "around the file's; outside, they are NaN and InsideMap is 0.";
  }
  file.ReadRest();
  output->GetPointData()->SetScalars(values);
  AddTexts(output->GetFieldData(), "Comments", file.Comments());
  AddTexts(output->GetFieldData(), "FieldName", { file.FieldName() });
  AddTexts(output->GetFieldData(), "Notes", { note });
  if (!note.empty())
  {
    vtkWarningMacro(<< isthmus::JoinText(this->FileName, ": ", note));
  }
}

void vtkOpenDXReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "FieldIndex: " << this->FieldIndex << "\n";
  os << indent << "ArrayName: " << this->ArrayName << "\n";
}
