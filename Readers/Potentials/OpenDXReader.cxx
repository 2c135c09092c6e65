#include "Potentials/OpenDXReader.h"

#include "Core/CheckedProduct.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Files/NumberTypes.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

namespace isthmus
{
namespace
{

/// Refuses axes that are not finite or lie in one plane.
void CheckAxes(const VoxelLattice& grid, const TextWords& text)
{
  const std::array<double, 3> spacing = grid.Spacing();
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (!(spacing[a] > 0.0) || !std::isfinite(spacing[a]) || !std::isfinite(grid.Origin[a]))
    {
      text.Reject("origin and deltas should be finite, and no delta of length zero.");
    }
  }
  const Matrix3& m = grid.Steps;
  const double volume = m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
    m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
    m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
  if (!(std::abs(volume / (spacing[0] * spacing[1] * spacing[2])) > 1e-6))
  {
    text.Reject("the three deltas lie in one plane, so they span no grid.");
  }
}

/// The words after `type`.
void ReadArrayType(TextWords& text, std::string& word, OpenDXArray& array)
{
  word = text.Word();
  array.Unsigned = word == "unsigned";
  if (word == "signed" || word == "unsigned")
  {
    word = text.Word();
  }
  array.Single = word == "float";
  array.Whole = word == "int";
  array.ItemBytes = word == "double" ? 8 : 4;
  if (!array.Single && !array.Whole && word != "double")
  {
    text.Reject("values of type " + word + " are not read, only float, double and int.");
  }
}

/// Three numbers after `key`, or from `word` on where a file lacks the keys; false: `word` is
/// neither. Reads one word further.
bool ReadRow(TextWords& text, std::string& word, const char* key, std::array<double, 3>& row)
{
  double first = 0.0;
  const bool isNumber = FromText(word, first);
  if (word != key && !isNumber)
  {
    return false;
  }
  for (double& number : row)
  {
    number = isNumber && &number == row.data() ? first : text.Number(key);
  }
  word = text.Word();
  return true;
}

/**
 * The grid of an object of class `gridpositions`, whose class has just been read: counts, origin (0
 * where there is none), three rows of delta; files without any keys, which PyMOL reads, have all of
 * these numbers. Reads one word further, into `word`.
 * @throws ReaderError, with the line, unless all are finite and the deltas span a volume.
 */
VoxelLattice ReadOpenDXPositions(TextWords& text, std::string& word)
{
  VoxelLattice grid;
  word = text.Word();
  if (word != "counts")
  {
    text.Reject("the grid should state its counts, not '" + word + "'.");
  }
  for (std::int64_t& count : grid.Dimensions)
  {
    count = text.Whole("a count of the grid");
    if (count < 1 || count > std::numeric_limits<int>::max())
    {
      text.Reject("a count of the grid is " + std::to_string(count) +
        ", but should be between 1 and 2147483647.");
    }
  }
  word = text.Word();
  ReadRow(text, word, "origin", grid.Origin);
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::array<double, 3> delta{};
    if (!ReadRow(text, word, "delta", delta))
    {
      text.Reject("three rows of delta should follow, but '" + word + "' was found instead.");
    }
    for (std::size_t i = 0; i < 3; ++i)
    {
      grid.Steps[i][axis] = delta[i];
    }
  }
  CheckAxes(grid, text);
  return grid;
}

/**
 * The description of an object of class `array` before its values, up to the word `follows`, which
 * is left in `word`. Whether it fits the grid is not checked.
 * @throws ReaderError, with the line, for types and forms that are not read.
 */
OpenDXArray ReadOpenDXArray(TextWords& text, std::string& word)
{
  OpenDXArray array;
  array.Single = true; // OpenDX' default
  array.ItemBytes = 4;
  bool bigEndian = !IsLittleEndian();
  for (word = text.Word(); word != "follows"; word = text.Word())
  {
    if (word == "type")
    {
      ReadArrayType(text, word, array);
    }
    else if (word == "rank")
    {
      if (text.Whole("the rank") > 1)
      {
        text.Reject("values of rank 2 and more (matrices) are not read.");
      }
    }
    else if (word == "shape")
    {
      const std::int64_t shape = text.Whole("the shape");
      array.Components = static_cast<int>(std::clamp<std::int64_t>(shape, 0, 1000));
    }
    else if (word == "items")
    {
      array.Items = text.Whole("the number of items");
    }
    else if (word == "lsb" || word == "msb")
    {
      bigEndian = word == "msb";
      array.Binary = true;
    }
    else if (word == "binary" || word == "ieee")
    {
      array.Binary = true;
    }
    else if (word == "text" || word == "ascii")
    {
      array.Binary = false;
    }
    else if (word != "data" && word != "category" && word != "real")
    {
      text.Reject(word.empty() ? std::string("the file ends within the description of an array.")
                               : "'" + word +
            "' is not understood in the description of an array: its values "
            "should follow in this file, as text or IEEE numbers.");
    }
  }
  array.Swap = bigEndian == IsLittleEndian();
  return array;
}

/// A number of the file's binary form, in this machine's byte order, as T.
template <typename Stored, typename T>
void Decode(const unsigned char* bytes, bool swap, std::int64_t count, T* values)
{
  for (std::int64_t i = 0; i < count; ++i)
  {
    std::array<unsigned char, sizeof(Stored)> one;
    std::memcpy(one.data(), bytes + i * static_cast<std::int64_t>(sizeof(Stored)), sizeof(Stored));
    if (swap)
    {
      std::reverse(one.begin(), one.end());
    }
    Stored value;
    std::memcpy(&value, one.data(), sizeof(Stored));
    values[i] = static_cast<T>(value);
  }
}

}

OpenDXReader::OpenDXReader(const std::string& path, int index, const ProgressCallback& progress)
  : Source(OpenTextSource(path))
  , Text(*this->Source)
{
  RequireRange("FieldIndex", index, 0, std::numeric_limits<int>::max(), "It counts from 0.");
  this->Word = this->Text.Word();
  if (this->Word != "object")
  {
    throw ReaderError(ReaderFailure::ForeignFormat,
      path + ": this is not an OpenDX file: it begins with '" + this->Word.substr(0, 40) +
        "', not with the word object.");
  }
  for (int array = 0; this->NextArray(); ++array)
  {
    this->CheckArray();
    this->CheckPromisedSize(progress);
    if (array == index)
    {
      return;
    }
    this->SkipValues(progress);
    this->Word = this->Text.Word();
  }
  throw ReaderError(index == 0 ? ReaderFailure::Damaged : ReaderFailure::BadRequest,
    path + ": there is no array of values number " + std::to_string(index) +
      " (counted from 0) in the file. Choose another FieldIndex, or fetch the file again.");
}

bool OpenDXReader::NextArray()
{
  while (!this->Word.empty())
  {
    if (this->Word != "object")
    {
      this->Word = this->Text.Word(); // attributes, components: ignored before the values
      continue;
    }
    this->ReadObject();
    if (this->Word == "gridpositions")
    {
      this->Grid = ReadOpenDXPositions(this->Text, this->Word);
      this->GridName = this->ObjectName;
      this->HasGrid = true;
    }
    else if (this->Word == "array")
    {
      this->ArrayName = this->ObjectName;
      this->Values = ReadOpenDXArray(this->Text, this->Word);
      return true;
    }
    else if (this->Word == "regulararray" || this->Word == "product" || this->Word == "path")
    {
      this->Text.Reject("positions of class " + this->Word +
        " are not read: write the grid as gridpositions with counts, origin and deltas.");
    }
    else
    {
      this->Word = this->Text.Word();
    }
  }
  return false;
}

void OpenDXReader::ReadObject()
{
  this->ObjectName = this->Text.Word();
  this->Word = this->Text.Word();
  if (this->Word != "class")
  {
    this->Text.Reject("an object should have a name or number and a class, but '" + this->Word +
      "' was found instead of class.");
  }
  this->Word = this->Text.Word();
}

void OpenDXReader::CheckArray() const
{
  if (!this->HasGrid)
  {
    this->Text.Reject("values come before the grid (gridpositions) that they lie on.");
  }
  std::int64_t nodes = 1;
  for (const std::int64_t count : this->Grid.Dimensions)
  {
    if (!MultiplyInRange(nodes, count))
    {
      this->Text.Reject("the grid has more nodes than 64 bits can count.");
    }
  }
  if (this->Values.Items != nodes)
  {
    this->Text.Reject("the array has " + std::to_string(this->Values.Items) +
      " items, but the grid has " + std::to_string(nodes) + " nodes.");
  }
  if (this->Values.Components < 1 || nodes > std::numeric_limits<std::int64_t>::max() / 16000)
  {
    this->Text.Reject("the shape of the array should be 1 to 1000 numbers for each node of a grid "
                      "that memory can hold.");
  }
}

void OpenDXReader::CheckPromisedSize(const ProgressCallback& progress)
{
  constexpr std::uint64_t harmless = std::uint64_t{ 1 } << 25;
  constexpr std::uint64_t usual = 32; // times that gzip shrinks such text; more is rare
  const auto numbers = static_cast<std::uint64_t>(this->Values.Items) *
    static_cast<std::uint64_t>(this->Values.Components);
  const std::uint64_t least = this->Values.Binary ? numbers * this->Values.ItemBytes : 2 * numbers;
  std::uint64_t most = this->Source->MaximumBytes();
  if (least <= most && !this->Source->RandomAccess() &&
    least > std::max(harmless, usual * this->Source->FileSize()))
  {
    most = this->Source->CountUpTo(least, progress);
  }
  if (least > most + 1) // the last number of a text may end the file
  {
    throw ReaderError(ReaderFailure::Truncated,
      this->Source->Path() + ": the file is truncated or its counts are wrong: " +
        std::to_string(numbers) + " values need " + std::to_string(least) +
        " bytes, and it has at most " + std::to_string(most) + ". Fetch the file again.");
  }
}

template <typename T>
void OpenDXReader::ReadNumbers(T* values, std::int64_t count)
{
  if (!this->Values.Binary)
  {
    this->Text.Numbers(values, count);
    return;
  }
  const std::size_t each = this->Values.ItemBytes;
  std::vector<unsigned char> bytes(static_cast<std::size_t>(count) * each);
  this->Text.Bytes(bytes.data(), bytes.size());
  if (this->Values.Whole && this->Values.Unsigned)
  {
    Decode<std::uint32_t>(bytes.data(), this->Values.Swap, count, values);
  }
  else if (this->Values.Whole)
  {
    Decode<std::int32_t>(bytes.data(), this->Values.Swap, count, values);
  }
  else if (this->Values.Single)
  {
    Decode<float>(bytes.data(), this->Values.Swap, count, values);
  }
  else
  {
    Decode<double>(bytes.data(), this->Values.Swap, count, values);
  }
}

void OpenDXReader::SkipValues(const ProgressCallback& progress)
{
  NodeBox nothing{ 0, -1, 0, -1, 0, -1 };
  this->Read<double>(nothing, nullptr, progress);
}

template <typename T>
void OpenDXReader::Read(const NodeBox& box, T* out, const ProgressCallback& progress)
{
  if (this->Values.Binary)
  {
    this->Text.EndLine();
  }
  const auto& n = this->Grid.Dimensions;
  const std::int64_t components = this->Values.Components;
  const std::int64_t plane = n[1] * n[2] * components;
  // Enough planes that whole cache lines of the output are written at once.
  const std::int64_t thick = std::clamp<std::int64_t>((1 << 21) / plane, 1, n[0]);
  std::vector<T> values(static_cast<std::size_t>(thick * plane));
  const std::int64_t nx = box[1] - box[0] + 1;
  const std::int64_t ny = box[3] - box[2] + 1;
  for (std::int64_t first = 0; first < n[0]; first += thick)
  {
    const std::int64_t planes = std::min(thick, n[0] - first);
    this->ReadNumbers(values.data(), planes * plane);
    const std::int64_t low = std::max(first, box[0]);
    const std::int64_t high = std::min(first + planes - 1, box[1]);
    const auto copy = [&](std::int64_t beginZ, std::int64_t endZ)
    {
      for (std::int64_t k = beginZ; k < endZ; ++k)
      {
        for (std::int64_t j = box[2]; j <= box[3]; ++j)
        {
          T* to = out + (low - box[0] + nx * (j - box[2] + ny * (k - box[4]))) * components;
          const T* from = values.data() + (low - first) * plane + (j * n[2] + k) * components;
          for (std::int64_t i = low; i <= high; ++i, from += plane, to += components)
          {
            std::copy_n(from, components, to);
          }
        }
      }
    };
    ParallelFor(box[4], low <= high ? box[5] + 1 : box[4], 8, copy);
    Report(progress, static_cast<double>(first + planes) / static_cast<double>(n[0]));
  }
}

template void OpenDXReader::Read(const NodeBox&, float*, const ProgressCallback&);
template void OpenDXReader::Read(const NodeBox&, double*, const ProgressCallback&);

void OpenDXReader::ReadRest()
{
  this->Word = this->Text.Word();
  double value;
  if (FromText(std::string_view(this->Word), value))
  {
    this->Text.Reject("there are more values than the " + std::to_string(this->Values.Items) +
      " items that the array declares.");
  }
  for (; !this->Word.empty(); this->Word = this->Text.Word())
  {
    if (this->Word == "object")
    {
      this->ReadObject();
      if (this->Word == "field")
      {
        this->Name = this->ObjectName;
        this->CheckField();
      }
      if (this->Word == "field" || this->Word == "array")
      {
        break; // what follows belongs to other fields
      }
    }
  }
  if (this->Word.empty())
  {
    this->Source->CheckEnd();
  }
}

void OpenDXReader::CheckField()
{
  std::string positions, data, other;
  for (this->Word = this->Text.Word(); !this->Word.empty() && this->Word != "object";
       this->Word = this->Text.Word())
  {
    if (this->Word == "component")
    {
      const std::string component(this->Text.Word());
      const bool named = this->Text.Word() == "value";
      const std::string value(named ? this->Text.Word() : std::string_view());
      (component == "positions" ? positions : component == "data" ? data : other) = value;
    }
  }
  if (data == this->ArrayName && !positions.empty() && positions != this->GridName)
  {
    this->Text.Reject("the field says that array " + data + " lies on the grid " + positions +
      ", but the grid before the array is " + this->GridName +
      ": files whose grids and arrays do not alternate are not supported. Write one field per "
      "file.");
  }
  this->Word = "field"; // what follows belongs to other fields
}

bool LooksLikeOpenDXFile(const std::string& path)
{
  try
  {
    const std::unique_ptr<ByteSource> source = OpenTextSource(path);
    return TextWords(*source).Word() == "object";
  }
  catch (const std::exception&)
  {
    return false;
  }
}

}
