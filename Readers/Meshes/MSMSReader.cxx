#include "Meshes/MSMSReader.h"

#include "Core/Handles.h"
#include "Core/NumberText.h"
#include "Core/RangeChecks.h"
#include "Files/OpenByteSource.h"
#include "Files/ReaderError.h"
#include "Files/TextLines.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

namespace isthmus
{
namespace
{

constexpr std::size_t VertexColumns = 9;
constexpr std::size_t FaceColumns = 5;

using ComponentNumber = Handle<struct MSMSComponent, int>;

/// Up to ten leading numbers of a line, whatever the locale; what follows them (an atom's name) is
/// skipped. Too small for a double is 0, too large infinite.
std::vector<double> ParseNumbers(std::string_view line)
{
  std::vector<double> numbers;
  while (numbers.size() < 10)
  {
    line.remove_prefix(std::min(line.find_first_not_of(" \t\n\v\f\r"), line.size()));
    if (line.size() > 1 && line[0] == '+' && line[1] != '-')
    {
      line.remove_prefix(1); // from_chars takes no plus
    }
    double x = 0.0;
    const auto [rest, error] = std::from_chars(line.data(), line.data() + line.size(), x);
    if (error == std::errc::invalid_argument)
    {
      break;
    }
    const auto length = static_cast<std::size_t>(rest - line.data());
    if (error == std::errc::result_out_of_range)
    {
      const std::string_view word = line.substr(0, length);
      const bool isTiny = word.find("e-") != word.npos || word.find("E-") != word.npos;
      x = isTiny ? 0.0 : std::numeric_limits<double>::infinity();
    }
    numbers.push_back(x);
    line.remove_prefix(length);
  }
  return numbers;
}

/// Rows of numbers of one file, without header and comments.
class Rows
{
public:
  Rows(const std::filesystem::path& path, std::string_view text, std::size_t columns,
    const ProgressCallback& progress = {})
    : Path(path)
    , Lines(text, path.string(), progress)
    , Columns(columns)
  {
  }

  /// False at the end of the file.
  bool Next(std::vector<double>& row)
  {
    std::string text;
    for (std::string_view line; this->Lines.Next(line);)
    {
      ++this->Line;
      text = line;
      if (text.find_first_not_of(" \t\r") == std::string::npos || text[0] == '#')
      {
        continue;
      }
      row = ParseNumbers(text);
      // A vertex has nine numbers and a face five: a first row of four is the line of counts.
      const bool counts = this->First && row.size() == 4;
      this->First = false;
      if (counts)
      {
        this->Promised = row[0];
        continue;
      }
      if (row.size() < this->Columns)
      {
        this->Fail("has " + std::to_string(row.size()) + " numbers instead of " +
          std::to_string(this->Columns));
      }
      ++this->Count;
      return true;
    }
    return false;
  }

  /// Checks that there are as many rows as the line of counts states, or any rows without it.
  void CheckCount(const char* what) const
  {
    if (this->Promised < 0.0 && this->Count == 0)
    {
      throw ReaderError(ReaderFailure::Truncated,
        this->Path.string() + ": it has neither counts nor " + what +
          ". The file is truncated or damaged: run MSMS again.");
    }
    if (this->Promised >= 0.0 && this->Promised != static_cast<double>(this->Count))
    {
      throw ReaderError(ReaderFailure::Truncated,
        this->Path.string() + ": its first line states " + FormatNumber(this->Promised) + " " +
          what + ", but there are " + std::to_string(this->Count) +
          ". The file is truncated or damaged: run MSMS again.");
    }
  }

  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw std::runtime_error("Line " + std::to_string(this->Line) + " of " + this->Path.string() +
      " " + reason + ". The file may be truncated, damaged, or not an MSMS file.");
  }

  /// A column that must hold an integer.
  std::int64_t Integer(double value) const
  {
    if (!(std::abs(value) < 1e15) || value != std::floor(value))
    {
      this->Fail("has " + FormatNumber(value) + " where an integer is expected");
    }
    return static_cast<std::int64_t>(value);
  }

  int SmallInteger(double value) const
  {
    if (!(std::abs(value) < 2e9))
    {
      this->Fail("has a number that is too large");
    }
    return static_cast<int>(this->Integer(value));
  }

private:
  std::filesystem::path Path;
  TextLines Lines;
  std::size_t Columns;
  std::size_t Line = 0;
  std::int64_t Count = 0;
  double Promised = -1.0; ///< rows, by the line of counts; negative: there is none
  bool First = true;
};

/// Reads the whole file. Folders, pipes and other files that are not regular are refused without
/// waiting.
std::string ReadContent(const std::filesystem::path& path, const ProgressCallback& progress)
{
  try
  {
    return ReadAll(*OpenTextSource(path.string()), progress);
  }
  catch (const ReaderError& error)
  {
    if (error.Kind == ReaderFailure::NoSuchFile)
    {
      throw ReaderError(error.Kind,
        "There is no file " + path.string() + ": MSMS surfaces come in pairs of .vert and .face.");
    }
    throw ReaderError(
      error.Kind, std::string(error.what()) + " MSMS surfaces come in pairs of .vert and .face.");
  }
}

void ReadVertices(
  const std::filesystem::path& path, MSMSSurface& surface, const ProgressCallback& progress)
{
  const std::string text = ReadContent(path, Between(progress, 0.0, 0.2));
  Rows rows(path, text, VertexColumns, Between(progress, 0.2, 1.0));
  for (std::vector<double> row; rows.Next(row);)
  {
    for (std::size_t c = 0; c < 6; ++c)
    {
      if (!std::isfinite(row[c]))
      {
        rows.Fail("has a coordinate that is not a finite number");
      }
    }
    surface.Points.push_back({ row[0], row[1], row[2] });
    surface.Normals.push_back({ row[3], row[4], row[5] });
    surface.AnalyticFaceOfPoint.push_back(rows.SmallInteger(row[6]));
    surface.SphereOfPoint.push_back(rows.SmallInteger(row[7]) - 1);
    surface.TypeOfPoint.push_back(rows.SmallInteger(row[8]));
  }
  rows.CheckCount("vertices");
}

/// `component` is that of all of them, their points are those from `firstPoint` on.
void ReadFaces(const std::filesystem::path& path, ComponentNumber component,
  std::int64_t firstPoint, MSMSSurface& surface, const ProgressCallback& progress)
{
  const auto points = static_cast<std::int64_t>(surface.Points.size()) - firstPoint;
  const std::string text = ReadContent(path, Between(progress, 0.0, 0.2));
  Rows rows(path, text, FaceColumns, Between(progress, 0.2, 1.0));
  for (std::vector<double> row; rows.Next(row);)
  {
    Triangle triangle{};
    for (std::size_t c = 0; c < 3; ++c)
    {
      const std::int64_t id = rows.Integer(row[c]);
      if (id < 1 || id > points)
      {
        rows.Fail("names vertex " + std::to_string(id) + ", but there are " +
          std::to_string(points) + " of them");
      }
      triangle[c] = firstPoint + id - 1;
    }
    surface.Triangles.push_back(triangle);
    surface.TypeOfTriangle.push_back(rows.SmallInteger(row[3]));
    surface.AnalyticFaceOfTriangle.push_back(rows.SmallInteger(row[4]));
    surface.ComponentOfTriangle.push_back(component.Value);
  }
  rows.CheckCount("faces");
}

std::filesystem::path WithExtension(std::filesystem::path file, const char* extension)
{
  return file.replace_extension(extension);
}

}

void ReadMSMS(const std::filesystem::path& file, int component, MSMSSurface& surface,
  const ProgressCallback& progress)
{
  const auto firstPoint = static_cast<std::int64_t>(surface.Points.size());
  ReadVertices(WithExtension(file, ".vert"), surface, Between(progress, 0.0, 0.5));
  ReadFaces(WithExtension(file, ".face"), ComponentNumber(component), firstPoint, surface,
    Between(progress, 0.5, 1.0));
}

std::vector<std::filesystem::path> MSMSComponents(const std::filesystem::path& file)
{
  std::vector<std::filesystem::path> result{ file };
  const std::filesystem::path stem = WithExtension(file, "");
  for (int i = 1;; ++i)
  {
    const std::filesystem::path next = stem.string() + "_" + std::to_string(i) + ".vert";
    if (!std::filesystem::exists(next))
    {
      return result;
    }
    result.push_back(next);
  }
}

bool LooksLikeMSMS(const std::filesystem::path& file)
{
  const bool vertices = file.extension() == ".vert";
  if (!vertices && file.extension() != ".face")
  {
    return false;
  }
  try
  {
    std::string begin(std::size_t{ 1 } << 16, '\0');
    begin.resize(OpenTextSource(file.string())->Read(0, begin.data(), begin.size()));
    Rows rows(file, begin, vertices ? VertexColumns : FaceColumns);
    std::vector<double> row;
    return rows.Next(row);
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

}
