#include "Maps/MRCHeaderDecoder.h"

#include "Core/Geometry.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace isthmus
{
namespace
{

std::string Text(double value)
{
  char text[32];
  std::snprintf(text, sizeof(text), "%.6g", value);
  return text;
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
bool AnglesSpanAVolume(const std::array<double, 3>& angles)
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

/// Fills a header from words, replacing what can't be used and saying so.
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
    this->Facts();
    this->TextLabels();
    return std::move(this->Out);
  }

private:
  void Repair(const std::string& sentence) { this->Out.Repairs.push_back(sentence); }

  void Identity()
  {
    const std::optional<bool> stated = ByteOrderOfMRCStamp(this->Bytes);
    const std::string found = this->Out.BigEndian ? "big endian" : "little endian";
    if (!stated || *stated != this->Out.BigEndian)
    {
      char stamp[16];
      std::snprintf(stamp, sizeof(stamp), "%02x %02x %02x %02x", this->Bytes[212], this->Bytes[213],
        this->Bytes[214], this->Bytes[215]);
      this->Repair("The machine stamp (word 54) is " + std::string(stamp) +
        (stated ? ", which the rest of the header contradicts" : ", which is none") + ": read as " +
        found + ", the byte order in which the header makes sense.");
    }
    if (!this->Out.HasMapWord)
    {
      this->Repair("The identifier \"MAP \" (word 53) is missing: read as a map all the same.");
    }
  }

  void VoxelType()
  {
    // IMOD: bit 0 of its flags says that bytes are signed; its files without it hold 0..255.
    constexpr int imodStamp = 1146047817;
    const bool unsignedBytes = this->Words.Int(39) == imodStamp && (this->Words.Int(40) & 1) == 0;
    this->Out.Voxel = VoxelTypeOfMRCMode(this->Words.Int(4), unsignedBytes);
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
      this->Out.Sampling[i] = sampling[i];
      this->Out.CellLengths[i] = lengths[i];
      // Beyond these bounds spacings would over- or underflow, whatever the writer meant.
      if (sampling[i] > 0 && lengths[i] > 1e-6 && lengths[i] < 1e12)
      {
        continue;
      }
      const char axis = "xyz"[i];
      this->Repair(
        (sampling[i] <= 0 ? Field("The sampling M", "XYZ"[i], 8 + i) + Text(sampling[i])
                          : Field("The cell length along ", axis, 11 + i) + Text(lengths[i])) +
        ": spacing 1 angstrom along " + axis + ".");
      this->Out.Sampling[i] = std::max(1, sampling[i]);
      this->Out.CellLengths[i] = this->Out.Sampling[i];
    }
    this->Out.CellAngles = this->Words.Floats(14);
    if (!AnglesSpanAVolume(this->Out.CellAngles))
    {
      this->Repair("The cell angles (words 14-16) are " + Text(this->Out.CellAngles) +
        ", which no cell has: taken as 90, 90, 90 degrees.");
      this->Out.CellAngles = { 90.0, 90.0, 90.0 };
    }
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
        ", no position within 1e9 angstrom: taken as not set.");
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
      this->Repair("The skew transformation (words 26-37) is no rotation and translation: "
                   "not applied, so the map may lie beside its model.");
    }
  }

  void Facts()
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

}

MRCHeader DecodeMRCHeader(const MRCHeaderBytes& bytes, const MRCHeaderWords& words)
{
  return Decoder(bytes, words).Decode();
}

}
