#include "Maps/MRCVoxels.h"

#include "Core/ParallelFor.h"
#include "Files/ReaderError.h"
#include "Files/StridedCopy.h"

#include <algorithm>
#include <cstring>
#include <memory>
#include <vector>

namespace isthmus
{
namespace
{

/// IEEE 754 half to single precision. Written without branches, so that the loop is vectorised.
float HalfToFloat(std::uint16_t half)
{
  const std::uint32_t magnitude = static_cast<std::uint32_t>(half & 0x7fffu) << 13;
  float value = 0;
  std::memcpy(&value, &magnitude, sizeof(value));
  value *= 0x1p112f; // the difference of the exponents' biases; right for subnormals too
  std::uint32_t bits = 0;
  std::memcpy(&bits, &value, sizeof(bits));
  bits |= magnitude >= 0x0f800000u ? 0x7f800000u : 0u; // infinity and NaN
  bits |= static_cast<std::uint32_t>(half & 0x8000u) << 16;
  std::memcpy(&value, &bits, sizeof(value));
  return value;
}

void DecodeHalves(const unsigned char* from, float* to, std::size_t voxels)
{
  for (std::size_t i = 0; i < voxels; ++i)
  {
    std::uint16_t half = 0;
    std::memcpy(&half, from + 2 * i, sizeof(half));
    to[i] = HalfToFloat(half);
  }
}

void DecodeNibbles(
  const unsigned char* from, unsigned char* to, std::size_t voxels, std::size_t skip)
{
  // The first voxel wanted is the high half of its byte.
  if (skip > 0 && voxels > 0)
  {
    *to++ = static_cast<unsigned char>(*from++ >> 4);
    --voxels;
  }
  for (std::size_t pair = 0; pair < voxels / 2; ++pair)
  {
    to[2 * pair] = static_cast<unsigned char>(from[pair] & 0xf);
    to[2 * pair + 1] = static_cast<unsigned char>(from[pair] >> 4);
  }
  if (voxels % 2 > 0)
  {
    to[voxels - 1] = static_cast<unsigned char>(from[voxels / 2] & 0xf);
  }
}

std::uint16_t SwapBytes(std::uint16_t word)
{
  return static_cast<std::uint16_t>((word >> 8) | (word << 8));
}

std::uint32_t SwapBytes(std::uint32_t word)
{
  return (word >> 24) | ((word >> 8) & 0xff00u) | ((word << 8) & 0xff0000u) | (word << 24);
}

/// Reverses the bytes of each word. vtkByteSwap does it at 0.5 GB/s, this at memory speed.
template <typename Word>
void SwapWords(unsigned char* bytes, std::size_t words)
{
  for (std::size_t i = 0; i < words; ++i)
  {
    Word word = 0;
    std::memcpy(&word, bytes + i * sizeof(Word), sizeof(Word));
    word = SwapBytes(word);
    std::memcpy(bytes + i * sizeof(Word), &word, sizeof(Word));
  }
}

}

bool IsKnownMRCMode(int mode)
{
  return (mode >= 0 && mode <= 4) || mode == 6 || mode == 12 || mode == 16 || mode == 101;
}

MRCVoxelType VoxelTypeFromMRCMode(int mode, bool unsignedBytes)
{
  switch (mode)
  {
    case 0:
      return { mode, unsignedBytes ? MRCValue::UnsignedChar : MRCValue::SignedChar, 1, 8, 1, 1 };
    case 1:
      return { mode, MRCValue::Short, 1, 16, 2, 2 };
    case 3:
      return { mode, MRCValue::Short, 2, 32, 2, 4 };
    case 4:
      return { mode, MRCValue::Float, 2, 64, 4, 8 };
    case 6:
      return { mode, MRCValue::UnsignedShort, 1, 16, 2, 2 };
    case 12:
      return { mode, MRCValue::Float, 1, 16, 2, 4 };
    case 16:
      return { mode, MRCValue::UnsignedChar, 3, 24, 1, 3 };
    case 101:
      return { mode, MRCValue::UnsignedChar, 1, 4, 1, 1 };
    default:
      return { mode, MRCValue::Float, 1, 32, 4, 4 };
  }
}

void DecodeMRCVoxels(const MRCVoxelType& type, bool swap, unsigned char* from, void* to,
  std::size_t voxels, std::size_t skip)
{
  if (type.FileBits == 4)
  {
    DecodeNibbles(from, static_cast<unsigned char*>(to), voxels, skip);
    return;
  }
  const std::size_t bytes = static_cast<std::size_t>(type.FileBytes(voxels));
  if (swap && type.Word == 2)
  {
    SwapWords<std::uint16_t>(from, bytes / 2);
  }
  else if (swap && type.Word == 4)
  {
    SwapWords<std::uint32_t>(from, bytes / 4);
  }
  if (type.Mode == 12)
  {
    DecodeHalves(from, static_cast<float*>(to), voxels);
  }
  else if (from != to)
  {
    std::memcpy(to, from, bytes);
  }
}

namespace
{

using Index3 = std::array<std::int64_t, 3>;
using Bytes = std::unique_ptr<unsigned char[]>;

Bytes Allocate(std::size_t size)
{
  return Bytes(new unsigned char[size]); // not std::vector, which would write zeros first
}

/// A box of selected voxels, counted in the selection along the file's axes.
struct Brick
{
  Index3 First{};
  Index3 Count{};
};

/// A selection of MRCSelection, whose axes are the output's, along the file's axes.
struct FileSelection
{
  FileSelection(const MRCVoxelLayout& layout, const MRCSelection& selection)
  {
    const Index3 step{ 1, selection.Count[0], selection.Count[0] * selection.Count[1] };
    for (std::size_t f = 0; f < 3; ++f)
    {
      const auto axis = static_cast<std::size_t>(layout.OutputAxis[f]);
      this->First[f] = selection.First[axis];
      this->Count[f] = selection.Count[axis];
      this->Stride[f] = selection.Stride[axis];
      this->OutStep[f] = step[axis];
    }
  }

  Index3 First{};
  Index3 Count{};
  Index3 Stride{};
  Index3 OutStep{}; ///< voxels in the output between neighbours along each file axis
};

/// The selection seen along the file's axes, and what follows from it.
class Reading : private FileSelection
{
public:
  Reading(ByteSource& source, const MRCVoxelLayout& layout, const MRCSelection& selection,
    unsigned char* out)
    : FileSelection(layout, selection)
    , Source(source)
    , Layout(layout)
    , Out(out)
  {
    this->RowBytes = layout.Type.FileBytes(static_cast<std::uint64_t>(layout.Counts[0]));
    this->Direct = layout.Type.SameInFile() && this->OutStep[0] == 1 && this->Stride[0] == 1;
  }

  /// Largest brick of about `bytes` bytes for threads that read bricks in any order.
  Index3 BrickForThreads(std::int64_t bytes) const
  {
    Index3 size{};
    size[0] = std::clamp<std::int64_t>(bytes / this->ColumnBytes(), 1, this->Count[0]);
    const std::int64_t row = size[0] * this->ColumnBytes();
    // Output is written along x: where sections are x, a brick must hold many of them.
    const auto many =
      std::max<std::int64_t>(64, 256 / static_cast<std::int64_t>(this->Layout.Type.Bytes));
    const std::int64_t sections = this->OutStep[2] == 1 ? std::min(many, this->Count[2]) : 1;
    size[1] = std::clamp<std::int64_t>(bytes / (row * sections), 1, this->Count[1]);
    size[2] = std::clamp<std::int64_t>(bytes / (row * size[1]), 1, this->Count[2]);
    return size;
  }

  /// Largest brick of about `bytes` bytes of the stream, such that bricks follow one another in it.
  Index3 BrickForStream(std::int64_t bytes) const
  {
    const std::int64_t row = static_cast<std::int64_t>(this->RowBytes) * this->Stride[1];
    const std::int64_t section =
      static_cast<std::int64_t>(this->RowBytes) * this->Layout.Counts[1] * this->Stride[2];
    Index3 size{ 1, 1, 1 };
    size[0] = std::clamp<std::int64_t>(bytes / this->ColumnBytes(), 1, this->Count[0]);
    if (size[0] == this->Count[0])
    {
      size[1] = std::clamp<std::int64_t>(bytes / row, 1, this->Count[1]);
    }
    if (size[1] == this->Count[1])
    {
      size[2] = std::clamp<std::int64_t>(bytes / section, 1, this->Count[2]);
    }
    return size;
  }

  std::vector<Brick> Bricks(const Index3& size) const;

  /// Memory that Fetch() and Finish() need for bricks of up to `size`; none if they read directly
  /// into the output.
  std::size_t ScratchBytes(const Index3& size) const
  {
    return this->Direct
      ? 0
      : this->RawBytes(size) + (this->Layout.Type.SameInFile() ? 0 : this->DecodedBytes(size));
  }

  std::uint64_t Offset(const Brick& brick) const
  {
    return this->RowOffset(brick, 0, 0) + this->FirstByte(brick);
  }

  void Fetch(const Brick& brick, unsigned char* scratch) const;
  void Finish(const Brick& brick, unsigned char* scratch) const;

private:
  /// Bytes of the file that one selected column represents, at least 1.
  std::int64_t ColumnBytes() const
  {
    return std::max<std::int64_t>(1, this->Stride[0] * this->Layout.Type.FileBits / 8);
  }

  std::uint64_t RowOffset(const Brick& brick, std::int64_t row, std::int64_t section) const
  {
    const std::int64_t r = this->First[1] + (brick.First[1] + row) * this->Stride[1];
    const std::int64_t s = this->First[2] + (brick.First[2] + section) * this->Stride[2];
    return this->Layout.Offset +
      this->RowBytes * static_cast<std::uint64_t>(r + this->Layout.Counts[1] * s);
  }

  std::int64_t FirstColumn(const Brick& brick) const
  {
    return this->First[0] + brick.First[0] * this->Stride[0];
  }
  std::uint64_t FirstByte(const Brick& brick) const
  {
    const auto column = static_cast<std::uint64_t>(this->FirstColumn(brick));
    return this->Layout.Type.FileBits == 4 ? column / 2 : this->Layout.Type.FileBytes(column);
  }
  /// Voxels of a row from the first to the last selected one.
  std::int64_t Span(std::int64_t columns) const { return (columns - 1) * this->Stride[0] + 1; }
  /// Bytes that are fetched of each row.
  std::size_t SpanBytes(const Brick& brick) const
  {
    const std::int64_t odd = this->Layout.Type.FileBits == 4 ? this->FirstColumn(brick) % 2 : 0;
    return static_cast<std::size_t>(
      this->Layout.Type.FileBytes(static_cast<std::uint64_t>(this->Span(brick.Count[0]) + odd)));
  }

  std::size_t RawBytes(const Index3& size) const
  {
    const std::size_t row = static_cast<std::size_t>(
      this->Layout.Type.FileBytes(static_cast<std::uint64_t>(this->Span(size[0]) + 1)));
    // Rounded up, so that decoded voxels behind it are aligned.
    return (row * static_cast<std::size_t>(size[1] * size[2]) + 63) / 64 * 64;
  }
  std::size_t DecodedBytes(const Index3& size) const
  {
    return this->Layout.Type.Bytes *
      static_cast<std::size_t>(this->Span(size[0]) * size[1] * size[2]);
  }

  unsigned char* GetOutputPointer(const Brick& brick, std::int64_t row, std::int64_t section) const
  {
    const std::int64_t voxel = brick.First[0] * this->OutStep[0] +
      (brick.First[1] + row) * this->OutStep[1] + (brick.First[2] + section) * this->OutStep[2];
    return this->Out + this->Layout.Type.Bytes * static_cast<std::size_t>(voxel);
  }

  /// Number of rows that are contiguous in the file (and in the output, if read directly): 1 or
  /// all.
  std::int64_t RowsAtOnce(const Brick& brick) const
  {
    const bool wholeRows =
      brick.Count[0] == this->Layout.Counts[0] && this->Stride[0] == 1 && this->Stride[1] == 1;
    const bool follow = !this->Direct || this->OutStep[1] == this->Count[0];
    return wholeRows && follow ? brick.Count[1] : 1;
  }

  void ReadExactly(std::uint64_t offset, unsigned char* to, std::size_t size) const;

  ByteSource& Source;
  const MRCVoxelLayout& Layout;
  unsigned char* Out;
  std::uint64_t RowBytes = 0;
  bool Direct = false; ///< rows go to the output as they are, byte order apart
};

std::vector<Brick> Reading::Bricks(const Index3& size) const
{
  std::vector<Brick> bricks;
  for (std::int64_t s = 0; s < this->Count[2]; s += size[2])
  {
    for (std::int64_t r = 0; r < this->Count[1]; r += size[1])
    {
      for (std::int64_t c = 0; c < this->Count[0]; c += size[0])
      {
        bricks.push_back({ { c, r, s },
          { std::min(size[0], this->Count[0] - c), std::min(size[1], this->Count[1] - r),
            std::min(size[2], this->Count[2] - s) } });
      }
    }
  }
  return bricks;
}

void Reading::ReadExactly(std::uint64_t offset, unsigned char* to, std::size_t size) const
{
  if (this->Source.Read(offset, to, size) < size)
  {
    const std::array<std::int64_t, 3>& counts = this->Layout.Counts;
    const std::uint64_t end =
      this->Layout.Offset + this->RowBytes * static_cast<std::uint64_t>(counts[1] * counts[2]);
    const std::uint64_t found = this->Source.CountUpTo(end, {});
    throw ReaderError(ReaderFailure::Truncated,
      this->Source.Path() +
        (found < end ? ": the file is truncated: " + std::to_string(end) + " bytes expected" +
              (this->Source.RandomAccess() ? "" : " after decompression") + ", found " +
              std::to_string(found) + ". Fetch the file again."
                     : std::string(": the file changed while it was read, or its disk failed. "
                                   "Read it again when no other program is writing it.")));
  }
}

void Reading::Fetch(const Brick& brick, unsigned char* scratch) const
{
  const std::int64_t rows = this->RowsAtOnce(brick);
  const std::size_t bytes = this->SpanBytes(brick) * static_cast<std::size_t>(rows);
  unsigned char* next = scratch;
  for (std::int64_t s = 0; s < brick.Count[2]; ++s)
  {
    for (std::int64_t r = 0; r < brick.Count[1]; r += rows)
    {
      this->ReadExactly(this->RowOffset(brick, r, s) + this->FirstByte(brick),
        this->Direct ? this->GetOutputPointer(brick, r, s) : next, bytes);
      next += bytes;
    }
  }
}

void Reading::Finish(const Brick& brick, unsigned char* scratch) const
{
  const MRCVoxelType& type = this->Layout.Type;
  const std::int64_t rows = brick.Count[1] * brick.Count[2];
  const auto span = static_cast<std::size_t>(this->Span(brick.Count[0]));
  if (this->Direct)
  {
    for (std::int64_t row = 0; this->Layout.Swap && row < rows; ++row)
    {
      unsigned char* const to =
        this->GetOutputPointer(brick, row % brick.Count[1], row / brick.Count[1]);
      DecodeMRCVoxels(type, true, to, to, span, 0);
    }
    return;
  }
  const std::size_t rawBytes = this->SpanBytes(brick);
  unsigned char* const decoded =
    type.SameInFile() ? scratch : scratch + this->RawBytes(brick.Count);
  const std::size_t skip =
    type.FileBits == 4 ? static_cast<std::size_t>(this->FirstColumn(brick) % 2) : 0;
  for (std::int64_t row = 0; row < rows; ++row)
  {
    const auto nth = static_cast<std::size_t>(row);
    DecodeMRCVoxels(type, this->Layout.Swap, scratch + nth * rawBytes,
      decoded + nth * span * type.Bytes, span, skip);
  }
  const auto steps = static_cast<std::int64_t>(span);
  StridedCopy({ brick.Count, { this->Stride[0], steps, steps * brick.Count[1] }, this->OutStep },
    type.Bytes, decoded, this->GetOutputPointer(brick, 0, 0));
}

void ReadInParallel(const Reading& reading, const ProgressCallback& progress)
{
  constexpr std::int64_t brickBytes = std::int64_t{ 1 } << 20;
  const Index3 size = reading.BrickForThreads(brickBytes);
  const std::vector<Brick> bricks = reading.Bricks(size);
  const auto body = [&](std::int64_t first, std::int64_t last)
  {
    const Bytes scratch = Allocate(reading.ScratchBytes(size));
    for (std::int64_t i = first; i < last; ++i)
    {
      const Brick& brick = bricks[static_cast<std::size_t>(i)];
      reading.Fetch(brick, scratch.get());
      reading.Finish(brick, scratch.get());
    }
  };
  ParallelFor(0, static_cast<std::int64_t>(bricks.size()), 4, body, progress);
}

void ReadInOrder(const Reading& reading, ByteSource& source, const ProgressCallback& progress)
{
  constexpr std::int64_t brickBytes = std::int64_t{ 1 } << 24;
  const Index3 size = reading.BrickForStream(brickBytes);
  const std::vector<Brick> bricks = reading.Bricks(size);
  Bytes current = Allocate(reading.ScratchBytes(size));
  Bytes next = Allocate(reading.ScratchBytes(size));
  const std::size_t count = bricks.size();
  for (std::size_t i = 0; i <= count; ++i)
  {
    const double from = static_cast<double>(i) / static_cast<double>(count + 1);
    const double to = static_cast<double>(i + 1) / static_cast<double>(count + 1);
    if (i < count)
    {
      source.SkipTo(reading.Offset(bricks[i]), Between(progress, from, to));
    }
    const auto half = [&](std::int64_t first, std::int64_t)
    {
      if (first == 0 && i < count)
      {
        reading.Fetch(bricks[i], next.get());
      }
      else if (first == 1 && i > 0)
      {
        reading.Finish(bricks[i - 1], current.get());
      }
    };
    if (source.UsesThreads())
    {
      half(0, 1);
      half(1, 2);
    }
    else
    {
      ParallelFor(0, 2, 1, half);
    }
    std::swap(current, next);
    Report(progress, to);
  }
}

/// Means of boxes of voxels, section by section of the means and some of their rows at a time.
/// Count and OutStep are those of the means, Stride is the side of a box.
class MeanReading : private FileSelection
{
public:
  MeanReading(ByteSource& source, const MRCVoxelLayout& layout, const MRCSelection& selection,
    const std::optional<double>& ignored, float* out)
    : FileSelection(layout, selection)
    , Source(source)
    , Layout(layout)
    , Ignored(ignored)
    , Out(out)
  {
  }

  std::int64_t Rows() const { return this->Count[1]; }
  std::int64_t Sections() const { return this->Count[2]; }

  /// Rows of means whose voxels in one section of the file take about a MiB.
  std::int64_t RowsAtOnce() const
  {
    constexpr std::int64_t pieceBytes = std::int64_t{ 1 } << 20;
    const std::int64_t rowBytes = this->Count[0] * this->Stride[0] * this->Stride[1] *
      static_cast<std::int64_t>(this->Layout.Type.Bytes);
    return std::clamp<std::int64_t>(pieceBytes / rowBytes, 1, this->Count[1]);
  }

  /// The means of these rows of a section of means.
  void Read(std::int64_t section, std::int64_t firstRow, std::int64_t endRow,
    const ProgressCallback& progress) const
  {
    std::vector<double> sums(static_cast<std::size_t>(this->Count[0] * (endRow - firstRow)), 0.0);
    std::vector<std::int32_t> counts(sums.size(), 0);
    std::vector<unsigned char> voxels;
    const std::int64_t piece = this->RowsAtOnce();
    for (std::int64_t s = 0; s < this->Stride[2]; ++s)
    {
      for (std::int64_t row = firstRow; row < endRow; row += piece)
      {
        const std::int64_t rows = std::min(piece, endRow - row);
        const auto at = static_cast<std::size_t>(this->Count[0] * (row - firstRow));
        this->ReadVoxels(section * this->Stride[2] + s, row, rows, voxels);
        this->AddVoxels(rows, voxels, &sums[at], &counts[at]);
        Report(progress,
          static_cast<double>(s * (endRow - firstRow) + row + rows - firstRow) /
            static_cast<double>(this->Stride[2] * (endRow - firstRow)));
      }
    }
    for (std::int64_t row = firstRow; row < endRow; ++row)
    {
      float* const to = this->Out + section * this->OutStep[2] + row * this->OutStep[1];
      for (std::int64_t c = 0; c < this->Count[0]; ++c)
      {
        const auto n = static_cast<std::size_t>(this->Count[0] * (row - firstRow) + c);
        to[c * this->OutStep[0]] = static_cast<float>(
          counts[n] > 0 ? sums[n] / static_cast<double>(counts[n]) : this->Ignored.value_or(0.0));
      }
    }
  }

private:
  /// The voxels of some rows of means in one section of the file, counted from First.
  void ReadVoxels(std::int64_t section, std::int64_t row, std::int64_t rows,
    std::vector<unsigned char>& voxels) const
  {
    const Index3 first{ 0, row * this->Stride[1], section },
      count{ this->Count[0] * this->Stride[0], rows * this->Stride[1], 1 };
    MRCSelection part;
    for (std::size_t f = 0; f < 3; ++f)
    {
      const auto axis = static_cast<std::size_t>(this->Layout.OutputAxis[f]);
      part.First[axis] = this->First[f] + first[f];
      part.Count[axis] = count[f];
    }
    voxels.resize(static_cast<std::size_t>(count[0] * count[1]) * this->Layout.Type.Bytes);
    const Reading reading(this->Source, this->Layout, part, voxels.data());
    const Bytes scratch = Allocate(reading.ScratchBytes(count));
    const Brick all{ {}, count };
    reading.Fetch(all, scratch.get());
    reading.Finish(all, scratch.get());
  }

  void AddVoxels(std::int64_t rows, const std::vector<unsigned char>& voxels, double* sums,
    std::int32_t* counts) const
  {
    const auto as = [&](auto value)
    { this->Add(rows, reinterpret_cast<const decltype(value)*>(voxels.data()), sums, counts); };
    switch (this->Layout.Type.Value)
    {
      case MRCValue::SignedChar:
        return as(static_cast<signed char>(0));
      case MRCValue::UnsignedChar:
        return as(static_cast<unsigned char>(0));
      case MRCValue::Short:
        return as(short(0));
      case MRCValue::UnsignedShort:
        return as(static_cast<unsigned short>(0));
      case MRCValue::Float:
        return as(0.0F);
    }
  }

  template <typename T>
  void Add(std::int64_t rows, const T* voxels, double* sums, std::int32_t* counts) const
  {
    // Of the axes x, y, z of the voxels that were read, columns are those of the smaller number.
    const bool columnsFirst = this->Layout.OutputAxis[0] < this->Layout.OutputAxis[1];
    const std::int64_t columns = this->Count[0] * this->Stride[0];
    const std::int64_t columnStep = columnsFirst ? 1 : rows * this->Stride[1];
    const std::int64_t rowStep = columnsFirst ? columns : 1;
    for (std::int64_t r = 0; r < rows * this->Stride[1]; ++r)
    {
      const std::int64_t to = this->Count[0] * (r / this->Stride[1]);
      for (std::int64_t c = 0; c < this->Count[0]; ++c)
      {
        double sum = sums[to + c];
        std::int32_t count = counts[to + c];
        const T* at = voxels + r * rowStep + c * this->Stride[0] * columnStep;
        for (std::int64_t k = 0; k < this->Stride[0]; ++k, at += columnStep)
        {
          const auto value = static_cast<double>(*at);
          if (!this->Ignored || value != *this->Ignored)
          {
            sum += value;
            ++count;
          }
        }
        sums[to + c] = sum;
        counts[to + c] = count;
      }
    }
  }

  ByteSource& Source;
  const MRCVoxelLayout& Layout;
  std::optional<double> Ignored;
  float* Out;
};

}

void ReadMRCVoxels(ByteSource& source, const MRCVoxelLayout& layout, const MRCSelection& selection,
  void* out, const ProgressCallback& progress)
{
  const Reading reading(source, layout, selection, static_cast<unsigned char*>(out));
  if (source.RandomAccess())
  {
    ReadInParallel(reading, progress);
  }
  else
  {
    ReadInOrder(reading, source, progress);
  }
}

void ReadMRCMeans(ByteSource& source, const MRCVoxelLayout& layout, const MRCSelection& selection,
  const std::optional<double>& ignored, float* out, const ProgressCallback& progress)
{
  const MeanReading reading(source, layout, selection, ignored, out);
  if (source.RandomAccess())
  {
    const std::int64_t piece = reading.RowsAtOnce();
    const std::int64_t pieces = (reading.Rows() + piece - 1) / piece;
    ParallelFor(
      0, reading.Sections() * pieces, 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t n = first; n < last; ++n)
        {
          const std::int64_t row = n % pieces * piece;
          reading.Read(n / pieces, row, std::min(reading.Rows(), row + piece), {});
        }
      },
      progress);
    return;
  }
  for (std::int64_t section = 0; section < reading.Sections(); ++section)
  {
    const auto share = [&](std::int64_t n)
    { return static_cast<double>(n) / static_cast<double>(reading.Sections()); };
    reading.Read(section, 0, reading.Rows(), Between(progress, share(section), share(section + 1)));
  }
}

}
