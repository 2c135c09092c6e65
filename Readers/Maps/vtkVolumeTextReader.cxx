#include "vtkVolumeTextReader.h"

#include "Core/NamedColumns.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderGuard.h"
#include "Files/TextLines.h"
#include "Files/TextWords.h"

#include <vtkDoubleArray.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <algorithm>
#include <array>
#include <limits>

vtkStandardNewMacro(vtkVolumeTextReader);

const std::vector<isthmus::OutputArray>& vtkVolumeTextReader::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Density", 1, "", ArrayChoice::None, "the values" },
  };
  return table;
}

namespace
{

/// The nodes along x, y, z. A value takes two bytes at least, so that damaged counts cause an error
/// message instead of a huge allocation.
std::array<int, 3> ReadCounts(isthmus::TextWords& words, std::uint64_t mostBytes)
{
  std::array<int, 3> counts{};
  std::uint64_t values = 1;
  for (int& count : counts)
  {
    const std::int64_t number = words.Whole("the number of nodes along an axis");
    if (number < 1 || number > std::numeric_limits<int>::max() ||
      static_cast<std::uint64_t>(number) > mostBytes / values)
    {
      words.Reject("the number of nodes along an axis is given as " + std::to_string(number) +
        ", for which the file is too short. It should begin with the number of nodes along each "
        "axis; it is truncated, damaged, or a .dat file of another program.");
    }
    count = static_cast<int>(number);
    values *= static_cast<std::uint64_t>(number);
  }
  if (!isthmus::Trim(words.RestOfLine()).empty())
  {
    words.Reject("the line above holds more than the three numbers of nodes. This is another "
                 "program's .dat.");
  }
  return counts;
}

std::uint64_t MaximumValues(const isthmus::ByteSource& source)
{
  return source.MaximumBytes() / 2 + 1;
}

}

vtkVolumeTextReader::vtkVolumeTextReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkVolumeTextReader::~vtkVolumeTextReader()
{
  this->SetFileName(nullptr);
}

int vtkVolumeTextReader::CanReadFile(const char* fileName)
{
  return isthmus::CanRead(fileName,
    [](const char* path)
    {
      try
      {
        const auto source = isthmus::OpenTextSource(path);
        isthmus::TextWords words(*source);
        ReadCounts(words, MaximumValues(*source));
        return true;
      }
      catch (const isthmus::ReaderError&)
      {
        return false;
      }
    });
}

int vtkVolumeTextReader::RequestInformation(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  return isthmus::ReadGuarded(
    this, this->FileName, vtkDataObject::GetData(output),
    [this](unsigned long code) { this->SetErrorCode(code); },
    [&]
    {
      const auto source = isthmus::OpenTextSource(this->FileName);
      isthmus::TextWords words(*source);
      const std::array<int, 3> n = ReadCounts(words, MaximumValues(*source));
      const int whole[6] = { 0, n[0] - 1, 0, n[1] - 1, 0, n[2] - 1 };
      output->GetInformationObject(0)->Set(
        vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), whole, 6);
    });
}

int vtkVolumeTextReader::RequestData(
  vtkInformation*, vtkInformationVector**, vtkInformationVector* output)
{
  auto* const image = vtkImageData::GetData(output);
  return isthmus::ReadGuarded(
    this, this->FileName, image, [this](unsigned long code) { this->SetErrorCode(code); },
    [&]
    {
      const auto source = isthmus::OpenTextSource(this->FileName);
      isthmus::TextWords words(*source);
      const std::array<int, 3> n = ReadCounts(words, MaximumValues(*source));
      const auto values = isthmus::NamedArray<vtkDoubleArray>(
        "Density", static_cast<std::size_t>(std::int64_t{ n[0] } * n[1] * n[2]));
      const vtkIdType layer = vtkIdType{ n[0] } * n[1];
      const isthmus::ProgressCallback progress = isthmus::MakeProgress(this);
      for (int k = 0; k < n[2]; ++k)
      {
        isthmus::Report(progress, static_cast<double>(k) / n[2]);
        words.Numbers(values->GetPointer(k * layer), layer);
      }
      if (!words.Word().empty())
      {
        words.Reject("there are more values than the " + std::to_string(n[2] * layer) +
          " that the first line states. The file is damaged: write it again.");
      }
      image->SetDimensions(n.data());
      image->GetPointData()->SetScalars(values);
    });
}

void vtkVolumeTextReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
}
