/**
 * @file MeshWords.h
 * @brief Counts, points and vertex numbers of a mesh file, checked, with messages about its lines.
 */
#ifndef isthmus_MeshWords_h
#define isthmus_MeshWords_h

#include "Core/PrintableText.h"
#include "Core/Progress.h"
#include "Files/ByteSource.h"
#include "Files/TextWords.h"

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace isthmus
{

/// A TextWords that knows the number of points. Everything throws ReaderError and Cancelled.
class MeshWords : public TextWords
{
public:
  MeshWords(ByteSource& source, ProgressCallback progress)
    : TextWords(source)
    , MaximumBytes(source.MaximumBytes())
    , Progress(std::move(progress))
  {
  }

  /// Reads a count of items that each take at least this number of bytes in the file, so that a
  /// damaged count causes an error and not an allocation.
  std::int64_t Count(const char* what, std::uint64_t bytes = 2)
  {
    const std::int64_t count = this->Whole(what);
    if (count < 0 || static_cast<std::uint64_t>(count) > this->MaximumBytes / bytes)
    {
      this->Reject(std::string(what) + " is given as " + std::to_string(count) +
        ", for which the file is too short. It is truncated or damaged: write or fetch it again.");
    }
    return count;
  }

  double Coordinate()
  {
    const double value = this->Number("a coordinate");
    if (!std::isfinite(value))
    {
      this->Reject("a coordinate is not a finite number. Correct it, or write the file again.");
    }
    return value;
  }

  /// Appends three of them.
  void Point(std::vector<double>& coordinates)
  {
    for (int c = 0; c < 3; ++c)
    {
      coordinates.push_back(this->Coordinate());
    }
  }

  /// The next vertex as a number from 0; the file counts from `first` to first + points - 1.
  std::int64_t Vertex(std::int64_t points, std::int64_t first)
  {
    const std::int64_t id = this->Whole("the number of a vertex");
    if (id < first || id - first >= points)
    {
      this->Reject("vertex " + std::to_string(id) + " is named, but " +
        (points == 0 ? std::string("there are none")
                     : "they are numbered " + std::to_string(first) + " to " +
              std::to_string(first + points - 1)) +
        ". The file is damaged, or was written by another program: write it again.");
    }
    return id - first;
  }

  /// Refuses anything but comments up to the end of the file, which has been read as far as its
  /// counts state.
  void EndFile(std::int64_t rows, const char* what)
  {
    const std::string word(this->Word());
    if (!word.empty())
    {
      this->Reject("the file should end after its " + std::to_string(rows) + " " + what +
        ", but '" + Printable(word.substr(0, 30)) +
        "' follows. Correct the number of rows in the file, or write it again.");
    }
  }

  /// Reports progress from time to time, after `done` rows of `all`.
  void ReportRow(std::int64_t done, std::int64_t all)
  {
    constexpr std::int64_t rowsBetweenReports = 1 << 14;
    if (done % rowsBetweenReports == 0)
    {
      Report(this->Progress, static_cast<double>(done) / static_cast<double>(all > 0 ? all : 1));
    }
  }

private:
  std::uint64_t MaximumBytes;
  ProgressCallback Progress;
};

}

#endif
