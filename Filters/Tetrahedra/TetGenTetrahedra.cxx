#include "Core/ChildProcess.h"
#include "Core/NumberText.h"
#include "Core/TetrahedralMesh.h"
#include "Core/TriangleMesh.h"
#include "Surfaces/ShellNesting.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

//--------------------------------------------------------------------------------------------------
// The text files that TetGen reads and writes.

/// Collects numbers as text and writes them a block at a time.
class TextWriter
{
public:
  explicit TextWriter(const std::filesystem::path& name)
    : File(name, std::ios::binary)
  {
  }

  template <typename Number>
  TextWriter& operator<<(Number value)
  {
    char digits[32];
    const auto end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    this->Text.append(digits, end).push_back(' ');
    return *this;
  }

  TextWriter& operator<<(const Point3& p) { return *this << p[0] << p[1] << p[2]; }

  void EndLine()
  {
    this->Text.push_back('\n');
    if (this->Text.size() > (1u << 20))
    {
      this->Flush();
    }
  }

  void Flush()
  {
    this->File.write(this->Text.data(), static_cast<std::streamsize>(this->Text.size()));
    this->File.flush();
    this->Text.clear();
    if (!this->File)
    {
      throw std::runtime_error("The surface could not be written for TetGen: free some space in "
                               "the folder for temporary files, or set TMPDIR to another.");
    }
  }

private:
  std::ofstream File;
  std::string Text;
};

/// Numbers of a text file, one after the other; '#' begins a comment.
class TextReader
{
public:
  explicit TextReader(const std::filesystem::path& name)
    : Name(name.filename().string())
  {
    std::ifstream file(name, std::ios::binary | std::ios::ate);
    if (!file)
    {
      throw std::runtime_error("TetGen wrote no file " + this->Name + ".");
    }
    this->Text.resize(static_cast<std::size_t>(file.tellg()));
    file.seekg(0);
    file.read(this->Text.data(), static_cast<std::streamsize>(this->Text.size()));
    this->At = this->Text.data();
    this->End = this->At + this->Text.size();
  }

  template <typename Number>
  Number Next()
  {
    this->SkipBlanks();
    Number value{};
    const auto [rest, error] = std::from_chars(this->At, this->End, value);
    if (error != std::errc{})
    {
      throw std::runtime_error("TetGen's file " + this->Name + " ends early: is the disk full?");
    }
    this->At = rest;
    return value;
  }

private:
  void SkipBlanks()
  {
    while (this->At != this->End && (*this->At <= ' ' || *this->At == '#'))
    {
      if (*this->At == '#')
      {
        this->At = std::find(this->At, this->End, '\n');
        continue;
      }
      ++this->At;
    }
  }

  std::string Name;
  std::string Text;
  const char* At = nullptr;
  const char* End = nullptr;
};

/// Writes points, triangles, a hole for each of `holes` and a region for each of `regions` (its
/// place in the list, from 1, being its attribute) as TetGen's .smesh, all digits kept.
void WriteTetGenSurface(const std::filesystem::path& file, const std::vector<SurfaceView>& surfaces,
  const std::vector<SpaceRegion>& holes, const std::vector<SpaceRegion>& regions)
{
  std::size_t points = 0;
  std::size_t triangles = 0;
  for (const SurfaceView& surface : surfaces)
  {
    points += surface.Points.size();
    triangles += surface.Triangles.size();
  }
  TextWriter out(file);
  (out << points << 3 << 0 << 0).EndLine();
  std::size_t id = 0;
  for (const SurfaceView& surface : surfaces)
  {
    for (const Point3& p : surface.Points)
    {
      (out << id++ << p).EndLine();
    }
  }
  (out << triangles << 0).EndLine();
  std::int64_t first = 0;
  for (const SurfaceView& surface : surfaces)
  {
    for (const Triangle& t : surface.Triangles)
    {
      (out << 3 << first + t[0] << first + t[1] << first + t[2]).EndLine();
    }
    first += static_cast<std::int64_t>(surface.Points.size());
  }
  (out << holes.size()).EndLine();
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    (out << i << holes[i].Seed).EndLine();
  }
  (out << regions.size()).EndLine();
  for (std::size_t i = 0; i < regions.size(); ++i)
  {
    (out << i << regions[i].Seed << i + 1).EndLine();
  }
  out.Flush();
}

/// Reads NAME.1.node and NAME.1.ele; Regions holds the attributes as they are.
/// @throws std::runtime_error when one is missing or ends early.
TetrahedralMesh ReadTetGenMesh(const std::filesystem::path& folder, const std::string& name)
{
  TetrahedralMesh mesh;
  {
    TextReader nodes(folder / (name + ".1.node"));
    mesh.Points.resize(nodes.Next<std::size_t>());
    const int dimension = nodes.Next<int>();
    const int attributes = nodes.Next<int>();
    const int markers = nodes.Next<int>();
    if (dimension != 3 || attributes != 0 || markers != 0)
    {
      throw std::runtime_error("TetGen's file of points has unexpected columns.");
    }
    for (Point3& p : mesh.Points)
    {
      nodes.Next<std::int64_t>(); // its own number
      p = { nodes.Next<double>(), nodes.Next<double>(), nodes.Next<double>() };
    }
  }
  TextReader cells(folder / (name + ".1.ele"));
  const auto count = cells.Next<std::size_t>();
  cells.Next<int>(); // corners
  const int attributes = cells.Next<int>();
  mesh.Tetrahedra.resize(count);
  mesh.Regions.resize(count);
  const auto points = static_cast<std::int64_t>(mesh.Points.size());
  for (std::size_t i = 0; i < count; ++i)
  {
    cells.Next<std::int64_t>();
    for (vtkIdType& corner : mesh.Tetrahedra[i])
    {
      corner = cells.Next<std::int64_t>();
      if (corner < 0 || corner >= points)
      {
        throw std::runtime_error(
          "TetGen's file of tetrahedra refers to a point that does not exist.");
      }
    }
    mesh.Regions[i] = attributes > 0 ? static_cast<int>(cells.Next<double>()) : 0;
  }
  return mesh;
}

//--------------------------------------------------------------------------------------------------
// TetGen as a child process.

/// TetGen's switches: p surface in, A regions, z ids from 0, F no files of faces and edges.
std::string Switches(const TetGenCriteria& criteria, bool smooths)
{
  std::string text = "-pAzF";
  if (criteria.PreserveSurface)
  {
    text += "Y";
  }
  if (criteria.RadiusEdgeRatio > 0.0)
  {
    text += "q" + FixedNumber(criteria.RadiusEdgeRatio, 6) + "/" +
      FixedNumber(criteria.MinimumDihedralAngle, 6);
  }
  if (criteria.MaximumVolume > 0.0)
  {
    // TetGen's parser of switches does not understand exponents.
    text += "a" + FixedNumber(criteria.MaximumVolume, 17);
  }
  if (smooths)
  {
    text += "s0/0"; // no iterations; 1.5 has no such switch, and fails
  }
  return text;
}

std::string Seconds(double value)
{
  return std::to_string(static_cast<std::int64_t>(value)) + " s";
}

/// The last line of TetGen's output that reports an error, in brackets.
std::string FindErrorMessage(const std::string& output)
{
  std::size_t from = std::string::npos;
  for (const char* word : { "Error:", "error:", "memory", "Warning:", "  PLC" })
  {
    from = output.rfind(word);
    if (from != std::string::npos)
    {
      break;
    }
  }
  if (from == std::string::npos)
  {
    return {};
  }
  return " (it says: " + output.substr(from, output.find('\n', from) - from) + ")";
}

/// Signals that a program does not send to itself.
bool IsExternalSignal(int signal)
{
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP ||
    signal == SIGQUIT || signal == SIGXCPU;
}

/// Throws with a message unless TetGen succeeded.
void CheckResult(const ChildResult& result, const TetGenCriteria& criteria)
{
  const std::string advice =
    " Remesh the surface (Surface Remesh), relax the bounds, or use CGAL instead.";
  const std::string memory = std::to_string(criteria.Limits.Bytes >> 20) + " MiB";
  if (result.End == ChildEnd::NotFound)
  {
    throw std::runtime_error("TetGen's program '" + criteria.TetGenCommand +
      "' was not found: install it (Debian: package tetgen), name its path as TetGenCommand, or "
      "use CGAL instead.");
  }
  if (result.End == ChildEnd::NotRun)
  {
    throw std::runtime_error("TetGenCommand names '" + criteria.TetGenCommand +
      "', which can't be run: it is a folder, or not a program. Set the path of the TetGen "
      "executable, or use CGAL instead.");
  }
  if (result.End == ChildEnd::Crashed && IsExternalSignal(result.Code))
  {
    throw std::runtime_error("TetGen was killed by the signal " +
      std::string(strsignal(result.Code)) +
      ": by a user, or by the system because memory ran out. Run it again, with a lower limit of "
      "memory or for fewer tetrahedra.");
  }
  if (result.End == ChildEnd::TimedOut)
  {
    throw std::runtime_error("TetGen was stopped after " + Seconds(criteria.Limits.TimeLimit) +
      ", the time limit: raise it if the mesh is large." + advice);
  }
  if (result.Output.find("emory") != std::string::npos)
  {
    throw std::runtime_error("TetGen ran out of memory (limit " + memory +
      "): raise the limit or request fewer tetrahedra.");
  }
  if (result.End == ChildEnd::Crashed || result.Code != 0)
  {
    throw std::runtime_error("TetGen failed on this surface" + FindErrorMessage(result.Output) +
      "; memory limit " + memory + "." + advice);
  }
}

/// Whether TetGen smooths the mesh after refining it, which can move points so far that tetrahedra
/// exceed the bounds, and takes longer than the refinement: true from 1.6 on. The program prints
/// its version only on a terminal, but the output for a single tetrahedron differs: 1.6 "improves"
/// meshes, 1.5 "optimises" them.
bool CanSmooth(const TetGenCriteria& criteria, const std::filesystem::path& folder,
  const ProgressCallback& progress)
{
  const std::vector<Point3> corners{ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const std::vector<Triangle> faces{ { 0, 2, 1 }, { 0, 1, 3 }, { 0, 3, 2 }, { 1, 2, 3 } };
  const auto input = folder / "probe.smesh";
  WriteTetGenSurface(input, { SurfaceView{ corners, faces } }, {}, {});
  const ChildResult result = RunChild({ criteria.TetGenCommand, "-pzF", input.string() },
    criteria.Limits, folder / "probe.log", Between(progress, 0.0, 0.0));
  CheckResult(result, criteria);
  return result.Output.find("Improving mesh") != std::string::npos;
}

}

namespace
{

/**
 * The box with its faces in squares of about `edge`. With PreserveSurface TetGen adds no points to
 * any face, those of the box included; faces of two triangles would make tetrahedra as long as the
 * box.
 */
TriangleMesh MeshBoxFaces(const SurfaceView& box, double edge)
{
  constexpr double mostCells = 500.0;
  const Point3& low = box.Points[0];
  const Point3& high = box.Points[7]; // corners in the order of AddBox
  const Point3 size = high - low;
  std::array<int, 3> cells{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    cells[axis] = static_cast<int>(std::clamp(std::ceil(size[axis] / edge), 1.0, mostCells));
  }
  TriangleMesh grid;
  std::map<std::array<int, 3>, std::int64_t> ids; // of the places that have a point
  const auto point = [&](const std::array<int, 3>& place)
  {
    const auto [found, isNew] = ids.emplace(place, static_cast<std::int64_t>(grid.Points.size()));
    if (isNew)
    {
      Point3 p = low;
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        // The far faces exactly at the far corner.
        p[axis] = place[axis] == cells[axis] ? high[axis]
                                             : low[axis] + size[axis] * place[axis] / cells[axis];
      }
      grid.Points.push_back(p);
    }
    return found->second;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3;
    const std::size_t v = (axis + 2) % 3;
    for (const bool isFar : { false, true })
    {
      for (int i = 0; i < cells[u]; ++i)
      {
        for (int j = 0; j < cells[v]; ++j)
        {
          const auto corner = [&](int along, int across)
          {
            std::array<int, 3> place{};
            place[axis] = isFar ? cells[axis] : 0;
            place[u] = i + along;
            place[v] = j + across;
            return point(place);
          };
          const std::int64_t a = corner(0, 0);
          const std::int64_t b = corner(isFar ? 1 : 0, isFar ? 0 : 1);
          const std::int64_t c = corner(1, 1);
          const std::int64_t d = corner(isFar ? 0 : 1, isFar ? 1 : 0);
          grid.Triangles.push_back({ a, b, c }); // facing outwards
          grid.Triangles.push_back({ a, c, d });
        }
      }
    }
  }
  return grid;
}

/// Of the squares on the box: a tetrahedron on half of one, as high as wide, has half of the
/// largest volume allowed, and none is longer than the box's distance from the surface.
double EdgeOnBox(const TetrahedralTask& task)
{
  const TetGenCriteria& criteria = task.Parameters.TetGen;
  double edge = task.Parameters.BoxMargin * ComputeBounds(task.Surface).Diagonal();
  if (criteria.MaximumVolume > 0.0)
  {
    edge = std::min(edge, std::cbrt(3.0 * criteria.MaximumVolume));
  }
  return edge;
}

/// `surface` without points that no triangle uses, which TetGen would make vertices of the mesh or
/// drop, so that its points were not numbered as those of the surface; `ids`: of the points left.
TriangleMesh WithUsedPoints(const SurfaceView& surface, std::vector<std::int64_t>& ids)
{
  std::vector<std::int64_t> number(surface.Points.size(), -1);
  for (const Triangle& corners : surface.Triangles)
  {
    for (const vtkIdType point : corners)
    {
      number[static_cast<std::size_t>(point)] = 0;
    }
  }
  TriangleMesh used;
  for (std::size_t i = 0; i < number.size(); ++i)
  {
    if (number[i] == 0)
    {
      number[i] = static_cast<std::int64_t>(ids.size());
      ids.push_back(static_cast<std::int64_t>(i));
      used.Points.push_back(surface.Points[i]);
    }
  }
  for (const Triangle& corners : surface.Triangles)
  {
    used.Triangles.push_back({ number[static_cast<std::size_t>(corners[0])],
      number[static_cast<std::size_t>(corners[1])], number[static_cast<std::size_t>(corners[2])] });
  }
  return used;
}

}

TetrahedralMesh TetGenTetrahedra(const TetrahedralTask& task, const ProgressCallback& progress)
{
  const TetGenCriteria& criteria = task.Parameters.TetGen;
  std::vector<SpaceRegion> wanted;
  std::vector<SpaceRegion> holes;
  std::vector<SpaceRegion> all = task.Nesting.InnerRegions;
  const bool boxed = !task.Box.Triangles.empty();
  if (boxed)
  {
    all.push_back(task.Exterior);
  }
  for (const SpaceRegion& region : all)
  {
    (task.IsWanted(region.Id) ? wanted : holes).push_back(region);
  }
  std::vector<std::int64_t> ids;
  TriangleMesh used = WithUsedPoints(task.Surface, ids);
  std::vector<SurfaceView> surfaces{ used };
  TriangleMesh box;
  if (boxed)
  {
    const bool splits =
      criteria.PreserveSurface && (criteria.RadiusEdgeRatio > 0.0 || criteria.MaximumVolume > 0.0);
    box = splits ? MeshBoxFaces(task.Box, EdgeOnBox(task)) : CopyMesh(task.Box);
    surfaces.emplace_back(box);
  }

  const TemporaryFolder folder;
  const auto input = folder.Path() / "surface.smesh";
  WriteTetGenSurface(input, surfaces, holes, wanted);
  surfaces.clear();
  used = box = {}; // TetGen has them
  const bool isBounded = criteria.RadiusEdgeRatio > 0.0 || criteria.MaximumVolume > 0.0;
  const std::string switches =
    Switches(criteria, isBounded && CanSmooth(criteria, folder.Path(), progress));
  CheckResult(RunChild({ criteria.TetGenCommand, switches, input.string() }, criteria.Limits,
                folder.Path() / "log", Between(progress, 0.0, 0.8)),
    criteria);
  Report(progress, 0.8);
  TetrahedralMesh mesh = ReadTetGenMesh(folder.Path(), "surface");

  for (int& region : mesh.Regions)
  {
    if (region < 1 || static_cast<std::size_t>(region) > wanted.size())
    {
      throw std::runtime_error("TetGen found a region that the surface does not bound: remesh the "
                               "surface or use CGAL instead.");
    }
    region = wanted[static_cast<std::size_t>(region - 1)].Id;
  }
  mesh.OriginalPoints.assign(mesh.Points.size(), -1);
  std::copy_n(ids.begin(), std::min(ids.size(), mesh.Points.size()), mesh.OriginalPoints.begin());
  return mesh;
}

}
