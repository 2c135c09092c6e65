#include "Maps/MRCMap.h"

#include "Core/CheckedProduct.h"
#include "Core/RangeChecks.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "Maps/MRCHeader.h"
#include "Maps/NoData.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <exception>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

namespace isthmus
{
namespace
{

/// The first bytes of the content; throws ReaderError when there are too few.
MRCHeaderBytes ReadHeaderBytes(ByteSource& source)
{
  MRCHeaderBytes bytes{};
  const std::size_t got = source.Read(0, bytes.data(), bytes.size());
  if (got < bytes.size())
  {
    throw ReaderError(ReaderFailure::Truncated,
      source.Path() + ": " + std::to_string(got) + " bytes" +
        (source.RandomAccess() ? "" : " after decompression") +
        " are too few for the header of a map, which has 1024. Fetch the file again.");
  }
  return bytes;
}

bool MachineIsBigEndian()
{
  const std::uint16_t one = 1;
  return *reinterpret_cast<const unsigned char*>(&one) == 0;
}

std::string Range(std::int64_t first, std::int64_t last)
{
  return std::to_string(first) + " to " + std::to_string(last);
}

/// Calls work with a number of the type of the voxels' values.
template <typename Work>
void WithType(const MRCVoxelType& type, Work&& work)
{
  switch (type.Value)
  {
    case MRCValue::SignedChar:
      return work(static_cast<signed char>(0));
    case MRCValue::UnsignedChar:
      return work(static_cast<unsigned char>(0));
    case MRCValue::Short:
      return work(short(0));
    case MRCValue::UnsignedShort:
      return work(static_cast<unsigned short>(0));
    case MRCValue::Float:
      return work(0.0f);
  }
}

/// ResampleValues for the type of a map's voxels.
void ResampleVoxels(const MRCVoxelType& type, const VoxelLattice& lattice, const void* nodes,
  const NodeBox& have, const VoxelLattice& grid, const NodeBox& region, void* out,
  unsigned char* inside, const ProgressCallback& progress)
{
  WithType(type,
    [&](auto value)
    {
      using T = decltype(value);
      ResampleValues(type.Components, lattice, static_cast<const T*>(nodes), have, grid, region,
        static_cast<T*>(out), inside, progress);
    });
}

}

MRCMap::MRCMap(const std::string& path)
  : Source(OpenByteSource(path))
{
  const MRCHeaderBytes bytes = ReadHeaderBytes(*this->Source);
  try
  {
    this->Head =
      ParseMRCHeader(bytes, path, this->Source->MaximumBytes(), this->Source->RandomAccess());
  }
  catch (const ReaderError&)
  {
    this->Source->CheckEnd(); // a damaged stream is the more likely explanation
    throw;
  }
  this->Sections = DescribeStack(this->Head, path);
}

void MRCMap::Reject(const std::string& sentence) const
{
  throw ReaderError(ReaderFailure::BadRequest, this->Source->Path() + ": " + sentence);
}

VoxelLattice MRCMap::SelectVolume(const MRCOptions& options)
{
  const int index = options.VolumeIndex;
  if (index < -1 || index >= this->Sections.Items)
  {
    this->Reject("there is no volume or image " + std::to_string(index) +
      ": VolumeIndex goes from 0 to " + std::to_string(this->Sections.Items - 1) +
      " in this file, or is -1.");
  }
  const bool allImages = index == -1 && this->Sections.What == MRCStack::Kind::Images;
  const int sections = allImages ? this->Head.Counts[2] : this->Sections.SectionsEach;
  const auto firstSection =
    static_cast<std::uint64_t>(std::max(index, 0)) * static_cast<std::uint64_t>(sections);

  MRCVoxelLayout& layout = this->Layout;
  layout.Type = this->Head.Voxel;
  layout.Swap = this->Head.BigEndian != MachineIsBigEndian();
  for (std::size_t f = 0; f < 3; ++f)
  {
    layout.Counts[f] = f == 2 ? sections : this->Head.Counts[f];
    layout.OutputAxis[f] = this->Head.AxisOrder[f] - 1;
  }
  const std::uint64_t sectionBytes =
    layout.Type.FileBytes(static_cast<std::uint64_t>(layout.Counts[0])) *
    static_cast<std::uint64_t>(layout.Counts[1]);
  layout.Offset = mrcHeaderBytes + static_cast<std::uint64_t>(this->Head.ExtendedHeaderBytes) +
    firstSection * sectionBytes;
  return MakeLattice(
    this->Head, sections, options.NonOrthogonalCell == NonOrthogonalCell::KeepCellAxes);
}

void MRCMap::SelectNodes(const MRCOptions& options, const VoxelLattice& whole)
{
  for (std::size_t a = 0; a < 3; ++a)
  {
    const std::int64_t end = whole.Dimensions[a] - 1;
    const std::int64_t first = options.CropExtent[2 * a];
    const std::int64_t asked = options.CropExtent[2 * a + 1];
    const std::int64_t last = asked == -1 ? end : asked;
    const std::string axis(1, "xyz"[a]);
    if (first < 0 || last < first || last > end)
    {
      this->Reject("CropExtent requests nodes " + Range(first, last) + " along " + axis +
        ", but the map has " + Range(0, end) + " there. Choose nodes among these.");
    }
    if (options.SampleRate[a] < 1)
    {
      this->Reject("SampleRate along " + axis + " is " + std::to_string(options.SampleRate[a]) +
        ", but must be 1 (every node) or more.");
    }
    this->Nodes.First[a] = first;
    this->Nodes.Stride[a] = std::min<std::int64_t>(
      options.SampleRate[a], this->Means ? last - first + 1 : whole.Dimensions[a]);
    const std::int64_t rest = this->Means ? this->Nodes.Stride[a] - 1 : 0;
    this->Nodes.Count[a] = (last - first - rest) / this->Nodes.Stride[a] + 1;
  }
}

void MRCMap::Select(const MRCOptions& options)
{
  RequireChoice("NonOrthogonalCell", options.NonOrthogonalCell, NonOrthogonalCell::KeepCellAxes);
  const VoxelLattice whole = this->SelectVolume(options);
  this->Means =
    this->Head.Voxel.Components == 1 && options.SampleRate != std::array<int, 3>{ 1, 1, 1 };
  this->Voxel = this->Means ? MRCVoxelType() : this->Head.Voxel; // floats
  this->SelectNodes(options, whole);
  this->Lattice = SelectLattice(whole, this->Nodes.First, this->Nodes.Count, this->Nodes.Stride);
  if (this->Means)
  {
    std::array<double, 3> middle{};
    for (std::size_t a = 0; a < 3; ++a)
    {
      middle[a] = static_cast<double>(this->Nodes.First[a]) +
        0.5 * static_cast<double>(this->Nodes.Stride[a] - 1);
    }
    this->Lattice.Origin = whole.At(middle);
  }
  this->Interpolated =
    options.NonOrthogonalCell == NonOrthogonalCell::Resample && !HasOrthogonalCell(this->Head);
  this->Target = this->Lattice;
  if (this->Interpolated)
  {
    try
    {
      this->Target = GridAround(this->Lattice);
    }
    catch (const ReaderError& error)
    {
      this->Reject(error.what());
    }
  }
}

NodeBox MRCMap::OutputBox() const
{
  const std::array<std::int64_t, 3>& size = this->Target.Dimensions;
  return { 0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1 };
}

std::uint64_t MRCMap::OutputBytes(const NodeBox& box) const
{
  std::uint64_t bytes = this->Voxel.Bytes;
  for (std::size_t a = 0; a < 3; ++a)
  {
    const auto nodes =
      static_cast<std::uint64_t>(std::max<std::int64_t>(0, box[2 * a + 1] - box[2 * a] + 1));
    if (!MultiplyInRange(bytes, nodes))
    {
      return std::numeric_limits<std::uint64_t>::max();
    }
  }
  return bytes;
}

void MRCMap::ReadNodes(const NodeBox& box, void* out, const ProgressCallback& progress)
{
  MRCSelection part = this->Nodes;
  for (std::size_t a = 0; a < 3; ++a)
  {
    part.First[a] += box[2 * a] * this->Nodes.Stride[a];
    part.Count[a] = box[2 * a + 1] - box[2 * a] + 1;
  }
  if (this->Means)
  {
    const std::optional<double> noData = this->FindNoData(part, Between(progress, 0.0, 0.2));
    ReadMRCMeans(*this->Source, this->Layout, part, noData, static_cast<float*>(out),
      Between(progress, 0.2, 1.0));
  }
  else
  {
    ReadMRCVoxels(*this->Source, this->Layout, part, out, progress);
  }
  this->Source->CheckEnd();
}

/// The value that stands for "no data" in a sample of the voxels of a part, which must not enter
/// means.
std::optional<double> MRCMap::FindNoData(const MRCSelection& part, const ProgressCallback& progress)
{
  constexpr std::int64_t most = 1 << 22;
  MRCSelection sample = part;
  const auto count = [&sample]() { return sample.Count[0] * sample.Count[1] * sample.Count[2]; };
  while (count() > most)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      sample.Stride[a] *= sample.Count[a] > 1 ? 2 : 1;
      sample.Count[a] = (sample.Count[a] + 1) / 2;
    }
  }
  std::optional<double> found;
  WithType(this->Head.Voxel,
    [&](auto value)
    {
      std::vector<decltype(value)> values(static_cast<std::size_t>(count()));
      ReadMRCVoxels(*this->Source, this->Layout, sample, values.data(), progress);
      found = FindNoDataValue(values.data(), count());
    });
  return found;
}

void MRCMap::Read(
  const NodeBox& box, void* out, unsigned char* inside, const ProgressCallback& progress)
{
  if (!this->Interpolated)
  {
    this->ReadNodes(box, out, progress);
    return;
  }
  const NodeBox needed = NodesNeeded(this->Lattice, this->Target, box);
  const auto bytes = static_cast<std::size_t>(this->OutputBytes(needed));
  const std::unique_ptr<unsigned char[]> values(new unsigned char[bytes]);
  if (bytes > 0)
  {
    this->ReadNodes(needed, values.get(), Between(progress, 0.0, 0.5));
  }
  ResampleVoxels(this->Voxel, this->Lattice, values.get(), needed, this->Target, box, out, inside,
    Between(progress, 0.5, 1.0));
}

bool MRCMap::CheckBeforeAllocating(std::uint64_t bytes, const ProgressCallback& progress)
{
  constexpr std::uint64_t harmless = std::uint64_t{ 1 } << 25;
  constexpr std::uint64_t usual = 32; // times; densities rarely compress better, masks do
  if (this->Source->RandomAccess() || bytes <= std::max(harmless, usual * this->Source->FileSize()))
  {
    return false;
  }
  const std::uint64_t expected = this->Head.FileBytes();
  const std::uint64_t found = this->Source->CountUpTo(expected, progress);
  if (found < expected)
  {
    throw ReaderError(ReaderFailure::Truncated,
      this->Source->Path() + ": the file is truncated or its header is wrong: " +
        std::to_string(expected) + " bytes expected after decompression, found " +
        std::to_string(found) + ". Fetch the file again.");
  }
  return true;
}

bool IsNamedAsMRCFile(const std::string& path)
{
  std::filesystem::path name(path);
  if (name.extension() == ".gz" || name.extension() == ".bz2")
  {
    name.replace_extension();
  }
  std::string ending = name.extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array<const char*, 4> own{ ".mrc", ".mrcs", ".mrcz", ".ccp4" };
  std::error_code failed;
  if (!std::filesystem::is_regular_file(path, failed))
  {
    return false;
  }
  if (ending != ".map")
  {
    return std::find(own.begin(), own.end(), ending) != own.end();
  }
  std::string begin(32, '\0');
  std::ifstream(path, std::ios::binary)
    .read(begin.data(), static_cast<std::streamsize>(begin.size()));
  return begin.rfind("RUU CROSS SYSTEM MAP", 0) != 0 && begin.rfind("OziExplorer", 0) != 0;
}

bool LooksLikeMRCFile(const std::string& path)
{
  try
  {
    const std::unique_ptr<ByteSource> source = OpenByteSource(path);
    return LooksLikeMRCHeader(ReadHeaderBytes(*source), source->MaximumBytes());
  }
  catch (const std::exception&)
  {
    return false;
  }
}

}
