#include "Maps/MRCHeader.h"

#include "Core/CheckedProduct.h"
#include "Core/Geometry.h"
#include "Core/NumberText.h"
#include "Files/ReaderError.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace isthmus
{
namespace
{

template <typename Values, typename Test>
bool All(const Values& values, Test&& test)
{
  return std::all_of(values.begin(), values.end(), test);
}

/// The words under one assumption on the byte order. Words count from 1, as in the format's tables.
class MRCHeaderWords
{
public:
  MRCHeaderWords(const MRCHeaderBytes& bytes, bool bigEndian);

  std::int32_t Int(std::size_t word) const;
  double Float(std::size_t word) const;
  std::array<int, 3> Ints(std::size_t word) const;
  std::array<double, 3> Floats(std::size_t word) const;
  /// `size` bytes from `offset`; blanks and zeros at the end left out, odd characters as '?'.
  std::string Text(std::size_t offset, std::size_t size) const;

  bool BigEndian() const { return this->Big; }
  bool HasMapWord() const { return this->Text(208, 3) == "MAP"; }
  /// Mode is known and the grid positive.
  bool Possible() const;
  /// Number of plausible values, 0 if not Possible().
  int Plausibility(std::uint64_t contentBytes) const;

private:
  std::uint32_t Bits(std::size_t word) const;

  const MRCHeaderBytes& Bytes;
  bool Big;
};

/// Bytes that NX x NY x NZ voxels of a known mode take; the largest number when 64 bits overflow.
std::uint64_t MRCDataBytes(const std::array<int, 3>& counts, int mode);

/// Byte order that the machine stamp states (true: big endian), if the stamp is a valid one.
std::optional<bool> ByteOrderFromMRCStamp(const MRCHeaderBytes& bytes);

/// The words in the more plausible byte order; the stamp decides if both are.
MRCHeaderWords ChooseMRCByteOrder(const MRCHeaderBytes& bytes, std::uint64_t contentBytes);

/// True for 1, 2, 3 in any order.
bool IsAxisPermutation(const std::array<int, 3>& order);

MRCHeaderWords::MRCHeaderWords(const MRCHeaderBytes& bytes, bool bigEndian)
  : Bytes(bytes)
  , Big(bigEndian)
{
}

std::uint32_t MRCHeaderWords::Bits(std::size_t word) const
{
  const unsigned char* b = this->Bytes.data() + 4 * (word - 1);
  std::uint32_t bits = 0;
  for (std::size_t i = 0; i < 4; ++i)
  {
    bits = (bits << 8) | b[this->Big ? i : 3 - i];
  }
  return bits;
}

std::int32_t MRCHeaderWords::Int(std::size_t word) const
{
  return static_cast<std::int32_t>(this->Bits(word));
}

double MRCHeaderWords::Float(std::size_t word) const
{
  const std::uint32_t bits = this->Bits(word);
  float value = 0;
  std::memcpy(&value, &bits, sizeof(value));
  return static_cast<double>(value);
}

std::array<int, 3> MRCHeaderWords::Ints(std::size_t word) const
{
  return { this->Int(word), this->Int(word + 1), this->Int(word + 2) };
}

std::array<double, 3> MRCHeaderWords::Floats(std::size_t word) const
{
  return { this->Float(word), this->Float(word + 1), this->Float(word + 2) };
}

std::string MRCHeaderWords::Text(std::size_t offset, std::size_t size) const
{
  std::string text(reinterpret_cast<const char*>(this->Bytes.data()) + offset, size);
  text.resize(std::min(text.size(), text.find('\0')));
  text.resize(text.find_last_not_of(' ') + 1); // npos + 1 is 0
  std::replace_if(
    text.begin(), text.end(), [](char c) { return c < ' ' || c > '~'; }, '?');
  return text;
}

bool MRCHeaderWords::Possible() const
{
  return IsKnownMRCMode(this->Int(4)) && All(this->Ints(1), [](int n) { return n > 0; });
}

int MRCHeaderWords::Plausibility(std::uint64_t contentBytes) const
{
  if (!this->Possible())
  {
    return 0;
  }
  const auto cellFits = [](double length)
  { return length == 0.0 || (std::abs(length) > 1e-6 && std::abs(length) < 1e6); };
  const std::array<int, 3> counts = this->Ints(1);
  return 1 + 2 * All(counts, [](int n) { return n < (1 << 17); }) +
    2 * IsAxisPermutation(this->Ints(17)) +
    2 * (MRCDataBytes(counts, this->Int(4)) <= contentBytes) +
    All(this->Ints(5), [](int start) { return std::abs(start / 2) < (1 << 20); }) +
    All(this->Ints(8), [](int m) { return m >= 0 && m < (1 << 20); }) +
    All(this->Floats(11), cellFits);
}

std::uint64_t MRCDataBytes(const std::array<int, 3>& counts, int mode)
{
  const MRCVoxelType voxel = VoxelTypeFromMRCMode(mode, false);
  std::uint64_t bytes = voxel.FileBytes(static_cast<std::uint64_t>(counts[0]));
  for (const int factor : { counts[1], counts[2] })
  {
    if (!MultiplyInRange(bytes, static_cast<std::uint64_t>(factor)))
    {
      return std::numeric_limits<std::uint64_t>::max();
    }
  }
  return bytes;
}

std::optional<bool> ByteOrderFromMRCStamp(const MRCHeaderBytes& bytes)
{
  const unsigned char first = bytes[212];
  const unsigned char second = bytes[213];
  if (first == 0x44 && (second == 0x44 || second == 0x41))
  {
    return false;
  }
  if (first == 0x11 && second == 0x11)
  {
    return true;
  }
  return {};
}

MRCHeaderWords ChooseMRCByteOrder(const MRCHeaderBytes& bytes, std::uint64_t contentBytes)
{
  // A first byte alone is a hint, too: 44 00, 44 20 20 20 and the like are in circulation.
  const bool stated = ByteOrderFromMRCStamp(bytes).value_or(bytes[212] == 0x11);
  const MRCHeaderWords words(bytes, stated);
  const MRCHeaderWords swapped(bytes, !stated);
  return swapped.Plausibility(contentBytes) > words.Plausibility(contentBytes) ? swapped : words;
}

bool IsAxisPermutation(const std::array<int, 3>& order)
{
  std::array<int, 3> sorted = order;
  std::sort(sorted.begin(), sorted.end());
  return sorted == std::array<int, 3>{ 1, 2, 3 };
}

std::string Text(double value)
{
  return FormatNumber(value);
}

std::string Text(int value)
{
  return std::to_string(value);
}

template <typename T>
std::string Text(const std::array<T, 3>& values)
{
  return Text(values[0]) + ", " + Text(values[1]) + ", " + Text(values[2]);
}

/// "NAMEx (word 8) is "
std::string Field(const std::string& name, char axis, std::size_t word)
{
  return name + axis + " (word " + std::to_string(word) + ") is ";
}

/// A cell with these angles (degrees) has a volume: each is below the sum of the other two, and so
/// on; what is left of that is the sign of the metric's determinant.
bool AnglesAreValid(const std::array<double, 3>& angles)
{
  double product = 2.0;
  double squares = 0.0;
  for (const double angle : angles)
  {
    if (!(angle > 0.0 && angle < 180.0))
    {
      return false;
    }
    const double cosine = std::cos(angle * Pi / 180.0);
    product *= cosine;
    squares += cosine * cosine;
  }
  return 1.0 - squares + product > 1e-6;
}

/// True within what single precision leaves of a rotation.
bool IsRotation(const Matrix3& matrix)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      const double dot = vtkMath::Dot(matrix[i].data(), matrix[j].data());
      if (!(std::abs(dot - (i == j ? 1.0 : 0.0)) < 1e-4))
      {
        return false;
      }
    }
  }
  return vtkMath::Determinant3x3(matrix[0].data(), matrix[1].data(), matrix[2].data()) > 0.0;
}

/// Fills a header from words; invalid values are replaced and reported.
class Decoder
{
public:
  Decoder(const MRCHeaderBytes& bytes, const MRCHeaderWords& words)
    : Bytes(bytes)
    , Words(words)
  {
  }

  MRCHeader Decode()
  {
    this->Out.BigEndian = this->Words.BigEndian();
    this->Out.HasMapWord = this->Words.HasMapWord();
    this->Out.Counts = this->Words.Ints(1);
    this->Identity();
    this->VoxelType();
    this->Axes();
    this->Cell();
    this->Position();
    this->Skew();
    this->DecodeStatistics();
    this->TextLabels();
    return std::move(this->Out);
  }

private:
  void Repair(const std::string& sentence) { this->Out.Repairs.push_back(sentence); }

  void Identity()
  {
    const std::optional<bool> stated = ByteOrderFromMRCStamp(this->Bytes);
    const std::string found = this->Out.BigEndian ? "big endian" : "little endian";
    if (!stated || *stated != this->Out.BigEndian)
    {
      std::string stamp;
      for (std::size_t i = 212; i < 216; ++i)
      {
        stamp += i > 212 ? " " : "";
        stamp += "0123456789abcdef"[this->Bytes[i] >> 4];
        stamp += "0123456789abcdef"[this->Bytes[i] & 15];
      }
      this->Repair("The machine stamp (word 54) is " + stamp +
        (stated ? ", which the rest of the header contradicts" : ", which is not valid") +
        ": read as " + found + ", the byte order in which the header is plausible.");
    }
    if (!this->Out.HasMapWord)
    {
      this->Repair("The identifier \"MAP \" (word 53) is missing: read as a map anyway.");
    }
  }

  void VoxelType()
  {
    // IMOD: bit 0 of its flags says that bytes are signed; its files without it hold 0..255.
    constexpr int imodStamp = 1146047817;
    const bool unsignedBytes = this->Words.Int(39) == imodStamp && (this->Words.Int(40) & 1) == 0;
    this->Out.Voxel = VoxelTypeFromMRCMode(this->Words.Int(4), unsignedBytes);
  }

  void Axes()
  {
    this->Out.AxisOrder = this->Words.Ints(17);
    if (!IsAxisPermutation(this->Out.AxisOrder))
    {
      this->Repair("The axis order MAPC, MAPR, MAPS (words 17-19) is " + Text(this->Out.AxisOrder) +
        ", not 1, 2, 3 in some order: taken as 1, 2, 3.");
      this->Out.AxisOrder = { 1, 2, 3 };
    }
  }

  void Cell()
  {
    const std::array<int, 3> sampling = this->Words.Ints(8);
    const std::array<double, 3> lengths = this->Words.Floats(11);
    for (std::size_t i = 0; i < 3; ++i)
    {
      const char axis = "xyz"[i];
      const int nodes = this->NodesAlong(i);
      const bool sampled = sampling[i] > 0;
      // Beyond these bounds spacings would over- or underflow, whatever the writer meant.
      const bool measured = lengths[i] > 1e-6 && lengths[i] < 1e12;
      this->Out.Sampling[i] = sampled ? sampling[i] : nodes;
      this->Out.CellLengths[i] = measured ? lengths[i] : this->Out.Sampling[i];
      if (!sampled)
      {
        this->Repair(Field("The sampling M", "XYZ"[i], 8 + i) + Text(sampling[i]) + ": taken as " +
          Text(nodes) + ", the number of nodes along " + axis + ", so that the cell is the map.");
      }
      if (!measured)
      {
        this->Repair(Field("The cell length along ", axis, 11 + i) + Text(lengths[i]) +
          ": spacing 1 angstrom along " + axis + ".");
      }
    }
    this->Out.CellAngles = this->Words.Floats(14);
    if (!AnglesAreValid(this->Out.CellAngles))
    {
      this->Repair("The cell angles (words 14-16) are " + Text(this->Out.CellAngles) +
        ", which no cell has: taken as 90, 90, 90 degrees.");
      this->Out.CellAngles = { 90.0, 90.0, 90.0 };
    }
  }

  /// Number of nodes along the cell's axis x, y or z.
  int NodesAlong(std::size_t axis) const
  {
    const auto& order = this->Out.AxisOrder;
    const auto at = std::find(order.begin(), order.end(), static_cast<int>(axis) + 1);
    return this->Out.Counts[static_cast<std::size_t>(at - order.begin())];
  }

  void Position()
  {
    this->Out.Start = this->Words.Ints(5);
    const auto far = [](int start) { return start > 10000000 || start < -10000000; };
    if (std::any_of(this->Out.Start.begin(), this->Out.Start.end(), far))
    {
      this->Repair("The start NXSTART, NYSTART, NZSTART (words 5-7) is " + Text(this->Out.Start) +
        ", beyond 10,000,000: taken as 0, 0, 0.");
      this->Out.Start = { 0, 0, 0 };
    }
    this->Out.Origin = this->Words.Floats(50);
    for (double& position : this->Out.Origin)
    {
      // Headers before MRC2000 keep wavelengths here as short integers: tiny as floats.
      position = std::abs(position) < 1e-30 ? 0.0 : position;
    }
    const auto lost = [](double position) { return !(std::abs(position) < 1e9); };
    if (std::any_of(this->Out.Origin.begin(), this->Out.Origin.end(), lost))
    {
      this->Repair("The ORIGIN (words 50-52) is " + Text(this->Out.Origin) +
        ", not a position within 1e9 angstrom: taken as not set.");
      this->Out.Origin = { 0.0, 0.0, 0.0 };
    }
  }

  void Skew()
  {
    if (this->Words.Int(25) != 1) // other programs keep other things in this word
    {
      return;
    }
    for (std::size_t i = 0; i < 9; ++i)
    {
      this->Out.SkewMatrix[i / 3][i % 3] = this->Words.Float(26 + i);
    }
    this->Out.SkewTranslation = this->Words.Floats(35);
    const auto near = [](double shift) { return std::abs(shift) < 1e9; };
    this->Out.Skewed = IsRotation(this->Out.SkewMatrix) &&
      std::all_of(this->Out.SkewTranslation.begin(), this->Out.SkewTranslation.end(), near);
    if (!this->Out.Skewed)
    {
      this->Repair("The skew transformation (words 26-37) is not a rotation and translation, and "
                   "was not applied, so the map may be displaced from its model.");
    }
  }

  void DecodeStatistics()
  {
    this->Out.Minimum = this->Words.Float(20);
    this->Out.Maximum = this->Words.Float(21);
    this->Out.Mean = this->Words.Float(22);
    this->Out.Rms = this->Words.Float(55);
    const int group = this->Words.Int(23);
    this->Out.SpaceGroup = group;
    if (group < 0 || (group > 230 && group < 401) || group > 630)
    {
      this->Repair("The space group ISPG (word 23) is " + Text(group) +
        ", none of 0-230 and 401-630: taken as 1, a single volume.");
      this->Out.SpaceGroup = 1;
    }
    this->Out.ExtendedHeaderBytes = this->Words.Int(24);
    if (this->Out.ExtendedHeaderBytes < 0)
    {
      this->Repair("The size NSYMBT of the extended header (word 24) is " +
        Text(this->Words.Int(24)) + ": taken as 0.");
      this->Out.ExtendedHeaderBytes = 0;
    }
    this->Out.ExtendedHeaderType = this->Words.Text(104, 4);
    if (this->Out.ExtendedHeaderType.find('?') != std::string::npos)
    {
      this->Out.ExtendedHeaderType.clear(); // CCP4 keeps the skew matrix in these words
    }
    this->Out.Version = this->Words.Int(28);
  }

  void TextLabels()
  {
    int count = this->Words.Int(56);
    if (count < 0 || count > 10)
    {
      this->Repair("The number of labels NLABL (word 56) is " + Text(count) +
        ", not 0 to 10: all labels that are not blank are kept.");
      count = 10;
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    {
      const std::string label = this->Words.Text(224 + 80 * i, 80);
      if (!label.empty())
      {
        this->Out.Labels.push_back(label);
      }
    }
  }

  const MRCHeaderBytes& Bytes;
  const MRCHeaderWords& Words;
  MRCHeader Out;
};

/// The header of `bytes`, whose words are `words`; replaced values are listed in its Repairs. Sizes
/// are not compared with those of the file.
/// @pre words.Possible()
MRCHeader DecodeMRCHeader(const MRCHeaderBytes& bytes, const MRCHeaderWords& words)
{
  return Decoder(bytes, words).Decode();
}

/// MRCZ (doi 10.1016/j.jsb.2017.11.012) adds 1000 times the number of the compression to the mode.
bool IsMRCZMode(int mode)
{
  return mode >= 1000 && mode < 10000 && IsKnownMRCMode(mode % 1000);
}

[[noreturn]] void RejectImpossible(const MRCHeaderWords& words, const std::string& path)
{
  if (!words.HasMapWord())
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path + ": this is not an MRC, CCP4 or EMDB map: grid " + Text(words.Ints(1)) + " and mode " +
        std::to_string(words.Int(4)) +
        " (words 1-4) are not plausible in either byte order, and the word "
        "\"MAP \" is missing. Choose another file.");
  }
  const int mode = words.Int(4);
  const bool badMode = !IsKnownMRCMode(mode);
  if (IsMRCZMode(mode))
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path + ": this is an MRCZ file: its voxels are compressed (mode " + std::to_string(mode) +
        " is 1000 times the number of the compression, plus mode " + std::to_string(mode % 1000) +
        "), which is not read. Write it without compression, in Python: "
        "mrcz.writeMRC(mrcz.readMRC(" +
        "name)[0], \"map.mrc\", compressor=None), with the package mrcz.");
  }
  throw ReaderError(ReaderFailure::ForeignFormat,
    path + ": the header is damaged: " +
      (badMode ? "mode (word 4) is " + std::to_string(mode) +
            ", known are 0, 1, 2, 3, 4, 6, 12, 16 and 101"
               : "the grid NX, NY, NZ (words 1-3) is " + Text(words.Ints(1)) +
            ", which must be positive") +
      ". Fetch or write the file again.");
}

void CheckSize(MRCHeader& header, const std::string& path, std::uint64_t contentBytes, bool exact)
{
  const std::uint64_t data = header.DataBytes();
  // The sizes fit without the extended header: it was announced, but never written.
  if (header.FileBytes() > contentBytes && exact && data <= contentBytes &&
    mrcHeaderBytes + data == contentBytes)
  {
    header.Repairs.push_back("The extended header of " +
      std::to_string(header.ExtendedHeaderBytes) +
      " bytes that NSYMBT (word 24) states is not there: the data begin at byte 1024.");
    header.ExtendedHeaderBytes = 0;
  }
  const std::uint64_t expected = header.FileBytes();
  if (expected > contentBytes)
  {
    throw ReaderError(ReaderFailure::Truncated,
      path + ": the file is truncated or its header is wrong: " + std::to_string(expected) +
        " bytes expected (header 1024, extended header " +
        std::to_string(header.ExtendedHeaderBytes) + ", " + std::to_string(header.Counts[0]) +
        " x " + std::to_string(header.Counts[1]) + " x " + std::to_string(header.Counts[2]) +
        " voxels of mode " + std::to_string(header.Voxel.Mode) + "), " +
        (exact ? "found " : "found at most ") + std::to_string(contentBytes) +
        ". Fetch the file again.");
  }
  if (exact && expected < contentBytes)
  {
    header.Repairs.push_back(std::to_string(contentBytes - expected) +
      " bytes follow the last voxel that the header describes: ignored.");
  }
}

}

std::uint64_t MRCHeader::DataBytes() const
{
  return MRCDataBytes(this->Counts, this->Voxel.Mode);
}

std::uint64_t MRCHeader::FileBytes() const
{
  const std::uint64_t head = mrcHeaderBytes + static_cast<std::uint64_t>(this->ExtendedHeaderBytes);
  const std::uint64_t data = this->DataBytes();
  return data > std::numeric_limits<std::uint64_t>::max() - head ? data : head + data;
}

MRCHeader ParseMRCHeader(
  const MRCHeaderBytes& bytes, const std::string& path, std::uint64_t contentBytes, bool exact)
{
  const MRCHeaderWords words = ChooseMRCByteOrder(bytes, contentBytes);
  if (!words.Possible())
  {
    RejectImpossible(words, path);
  }
  MRCHeader header = DecodeMRCHeader(bytes, words);
  CheckSize(header, path, contentBytes, exact);
  return header;
}

bool LooksLikeMRCHeader(const MRCHeaderBytes& bytes, std::uint64_t contentBytes)
{
  const MRCHeaderWords words = ChooseMRCByteOrder(bytes, contentBytes);
  constexpr int everything = 10;
  const bool isMap =
    words.Possible() && (words.HasMapWord() || words.Plausibility(contentBytes) == everything);
  // A map with an unsupported compression is opened, so that the user sees why it is refused.
  return isMap || (words.HasMapWord() && IsMRCZMode(words.Int(4)));
}

}
