#include "Core/ChildProcess.h"
#include "Core/TetrahedralMesh.h"
#include "Tetrahedra/TetGenTetrahedra.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <csignal>
#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace isthmus
{
namespace
{

std::string Number(double value)
{
  char text[32];
  std::snprintf(text, sizeof text, "%.6f", value);
  return text;
}

/// TetGen's switches: p surface in, A regions, z ids from 0, F no files of faces and edges.
std::string Switches(const TetGenCriteria& criteria)
{
  std::string text = "-pAzF";
  if (criteria.KeepSurface)
  {
    text += "Y";
  }
  if (criteria.RadiusEdgeRatio > 0.0)
  {
    text += "q" + Number(criteria.RadiusEdgeRatio) + "/" + Number(criteria.MinimumDihedral);
  }
  if (criteria.MaximumVolume > 0.0)
  {
    char volume[40];
    // TetGen's parser of switches knows no exponents.
    std::snprintf(volume, sizeof volume, "a%.17f", criteria.MaximumVolume);
    text += volume;
  }
  return text;
}

std::string Seconds(double value)
{
  return std::to_string(static_cast<std::int64_t>(value)) + " s";
}

/// The last line TetGen wrote that tells of an error, in brackets.
std::string Complaint(const std::string& output)
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

/// Signals that no program brings upon itself.
bool FromOutside(int signal)
{
  return signal == SIGKILL || signal == SIGTERM || signal == SIGINT || signal == SIGHUP ||
    signal == SIGQUIT || signal == SIGXCPU;
}

/// Ends in a sentence unless TetGen ended well.
void Demand(const ChildResult& result, const TetGenCriteria& criteria)
{
  const std::string advice =
    " Remesh the surface (Surface Remesh), ask for less, or use CGAL instead.";
  const std::string memory = std::to_string(criteria.Limits.Bytes >> 20) + " MiB";
  if (result.End == ChildEnd::NotFound)
  {
    throw std::runtime_error("TetGen's program '" + criteria.Command +
      "' was not found: install it (Debian: package tetgen), name its path as TetGenCommand, or "
      "use CGAL instead.");
  }
  if (result.End == ChildEnd::NotRun)
  {
    throw std::runtime_error("TetGenCommand names '" + criteria.Command +
      "', which can't be run: it is a folder, or no program. Name the path of TetGen's program, or "
      "use CGAL instead.");
  }
  if (result.End == ChildEnd::Crashed && FromOutside(result.Code))
  {
    throw std::runtime_error("TetGen was ended from outside by the signal " +
      std::string(strsignal(result.Code)) +
      ": by somebody, or by the system for want of memory. Run it again, with a lower limit of "
      "memory or for fewer tetrahedra.");
  }
  if (result.End == ChildEnd::TimedOut)
  {
    throw std::runtime_error("TetGen was stopped after " + Seconds(criteria.Limits.Seconds) +
      ", the time limit: raise it if the mesh is large." + advice);
  }
  if (result.Output.find("emory") != std::string::npos)
  {
    throw std::runtime_error("TetGen ran out of memory (limit " + memory +
      "): raise the limit or ask for fewer tetrahedra.");
  }
  if (result.End == ChildEnd::Crashed || result.Code != 0)
  {
    throw std::runtime_error("TetGen failed on this surface" + Complaint(result.Output) +
      "; memory limit " + memory + "." + advice);
  }
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
  std::vector<SurfaceView> surfaces{ task.Surface };
  if (boxed)
  {
    surfaces.push_back(task.Box);
  }

  const TemporaryFolder folder;
  const auto input = folder.Path() / "surface.smesh";
  WriteTetGenSurface(input, surfaces, holes, wanted);
  Demand(RunChild({ criteria.Command, Switches(criteria), input.string() }, criteria.Limits,
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
  const std::size_t kept = std::min(task.Surface.Points.size(), mesh.Points.size());
  for (std::size_t i = 0; i < kept; ++i)
  {
    mesh.OriginalPoints[i] = static_cast<std::int64_t>(i);
  }
  return mesh;
}

}
