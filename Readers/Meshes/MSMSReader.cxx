#include "MSMSReader.h"

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr std::size_t VertexColumns = 9;
constexpr std::size_t FaceColumns = 5;

/// Up to ten leading numbers of a line; what follows them (an atom's name) is left out.
std::vector<double> NumbersOf(const std::string& line)
{
  std::vector<double> numbers;
  const char* at = line.c_str();
  char* end = nullptr;
  for (double x = std::strtod(at, &end); end != at && numbers.size() < 10;
       x = std::strtod(at, &end))
  {
    numbers.push_back(x);
    at = end;
  }
  return numbers;
}

/// Rows of numbers of one file, header and comments left out.
class Rows
{
public:
  Rows(const std::filesystem::path& path, std::size_t columns)
    : Path(path)
    , File(path)
    , Columns(columns)
  {
    if (!this->File)
    {
      throw std::runtime_error("There is no file " + path.string() +
        ", or it can't be read: MSMS surfaces come in pairs of .vert and .face.");
    }
  }

  /// False at the end of the file.
  bool Next(std::vector<double>& row)
  {
    for (std::string text; std::getline(this->File, text);)
    {
      ++this->Line;
      if (text.find_first_not_of(" \t\r") == std::string::npos || text[0] == '#')
      {
        continue;
      }
      row = NumbersOf(text);
      const bool counts = this->First && row.size() == 4;
      this->First = false;
      if (counts)
      {
        continue;
      }
      if (row.size() < this->Columns)
      {
        this->Fail("has " + std::to_string(row.size()) + " numbers instead of " +
          std::to_string(this->Columns));
      }
      return true;
    }
    return false;
  }

  [[noreturn]] void Fail(const std::string& reason) const
  {
    throw std::runtime_error("Line " + std::to_string(this->Line) + " of " + this->Path.string() +
      " " + reason + ": is it a file of MSMS, and whole?");
  }

  /// A column that must hold an integer.
  std::int64_t Integer(double value) const
  {
    if (!(std::abs(value) < 1e15) || value != std::floor(value))
    {
      this->Fail("has " + std::to_string(value) + " where a whole number belongs");
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
  std::ifstream File;
  std::size_t Columns;
  std::size_t Line = 0;
  bool First = true;
};

void ReadVertices(const std::filesystem::path& path, MSMSSurface& surface)
{
  Rows rows(path, VertexColumns);
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
}

void ReadFaces(
  const std::filesystem::path& path, int component, std::int64_t firstPoint, MSMSSurface& surface)
{
  const auto points = static_cast<std::int64_t>(surface.Points.size()) - firstPoint;
  Rows rows(path, FaceColumns);
  for (std::vector<double> row; rows.Next(row);)
  {
    std::array<std::int64_t, 3> triangle{};
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
    surface.ComponentOfTriangle.push_back(component);
  }
}

std::filesystem::path WithExtension(std::filesystem::path file, const char* extension)
{
  return file.replace_extension(extension);
}

}

void ReadMSMS(const std::filesystem::path& file, int component, MSMSSurface& surface)
{
  const auto firstPoint = static_cast<std::int64_t>(surface.Points.size());
  ReadVertices(WithExtension(file, ".vert"), surface);
  ReadFaces(WithExtension(file, ".face"), component, firstPoint, surface);
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
    Rows rows(file, vertices ? VertexColumns : FaceColumns);
    std::vector<double> row;
    return rows.Next(row);
  }
  catch (const std::runtime_error&)
  {
    return false;
  }
}

}
