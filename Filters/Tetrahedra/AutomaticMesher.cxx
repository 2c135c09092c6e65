#include "Tetrahedra/AutomaticMesher.h"

#include "Core/Geometry.h"
#include "Core/NumberText.h"
#include "Remeshing/SurfaceRepair.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Surfaces/TriangleTree.h"
#include "Surfaces/WindingNumber.h"
#include "Tetrahedra/IsosurfaceStuffing.h"

#include <new>
#include <optional>
#include <set>
#include <stdexcept>

namespace isthmus
{

namespace
{

/// Distance to a soup, positive where it winds around a point by more than a half.
class SolidField
{
public:
  explicit SolidField(const SurfaceView& soup)
    : Winding(soup)
    , Tree(soup)
    , Triangles(static_cast<std::int64_t>(soup.Triangles.size()))
  {
  }

  double operator()(const Point3& x) const
  {
    // The nearest triangle of the last query, which is close to this one, saves most of the search;
    // the result does not depend on it.
    thread_local std::int64_t last = -1;
    const auto nearest = this->Tree.Find(x, last < this->Triangles ? last : -1);
    last = nearest.Guess;
    const double distance = std::sqrt(nearest.Squared);
    return std::abs(this->Winding(x)) > 0.5 ? distance : -distance;
  }

private:
  WindingNumber Winding;
  TriangleTree Tree;
  std::int64_t Triangles;
};

/// Keeps the tetrahedra of region 0 and the points they use.
TetrahedralMesh ExtractOutside(const TetrahedralMesh& mesh)
{
  TetrahedralMesh outside;
  std::vector<std::int64_t> ids(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    if (mesh.Regions[i] != 0)
    {
      continue;
    }
    Tetrahedron t = mesh.Tetrahedra[i];
    for (vtkIdType& id : t)
    {
      std::int64_t& known = ids[static_cast<std::size_t>(id)];
      if (known < 0)
      {
        known = static_cast<std::int64_t>(outside.Points.size());
        outside.Points.push_back(mesh.Points[static_cast<std::size_t>(id)]);
      }
      id = known;
    }
    outside.Tetrahedra.push_back(t);
  }
  outside.Regions.assign(outside.Tetrahedra.size(), 0);
  outside.OriginalPoints.assign(outside.Points.size(), -1);
  return outside;
}

}

TetrahedralMesh StuffSolid(const SurfaceView& soup, const SolidStuffingParameters& parameters,
  const ProgressCallback& progress)
{
  const char* const nothing =
    "The surface encloses nothing: it is neither closed nor nearly closed.";
  if (soup.Triangles.empty())
  {
    throw std::invalid_argument(nothing);
  }
  const Bounds3 bounds = ComputeBounds(soup);
  const double diagonal = bounds.Diagonal();
  if (!(diagonal > 0.0) || !std::isfinite(diagonal * diagonal * diagonal))
  {
    throw std::invalid_argument(
      "The surface is a single point, or its coordinates are too large: choose another unit.");
  }
  // The winding number in a cavity with the orientation of the shell around it would be 2.
  SurfaceCorrection correction;
  const std::vector<Triangle> turned = OrientShells(soup, correction);
  const SolidField field(SurfaceView(soup.Points, turned));
  StuffingParameters stuffing;
  // The inside is always meshed, since it shows whether anything is enclosed.
  stuffing.Side = parameters.Side == MeshedSide::Inside ? MeshedSide::Inside : MeshedSide::Both;
  stuffing.Margin = parameters.Side == MeshedSide::Inside ? 0.0 : parameters.BoxMargin * diagonal;
  stuffing.Memory = MemoryBudget::ForBytes(parameters.MaximumBytes);
  stuffing.GradingLevels = parameters.Side == MeshedSide::Inside ? 0 : 4;
  stuffing.CellSize = parameters.CellSize > 0.0 ? parameters.CellSize : diagonal / 100.0;
  TetrahedralMesh mesh = IsosurfaceStuffing(field, bounds, stuffing, progress).Mesh;
  if (std::count(mesh.Regions.begin(), mesh.Regions.end(), 1) == 0)
  {
    throw std::invalid_argument(nothing);
  }
  return parameters.Side == MeshedSide::Outside ? ExtractOutside(mesh) : std::move(mesh);
}

namespace
{

/// Triangles whose corners are finite and distinct points.
TriangleMesh ValidPart(const SurfaceView& mesh)
{
  const auto count = static_cast<std::int64_t>(mesh.Points.size());
  const auto isSound = [&](const Triangle& t)
  {
    for (const std::int64_t id : t)
    {
      if (id < 0 || id >= count)
      {
        return false;
      }
      const Point3& p = mesh.Points[static_cast<std::size_t>(id)];
      if (!std::isfinite(Dot(p, p)))
      {
        return false;
      }
    }
    return t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
  };
  TriangleMesh sound;
  sound.Points.assign(mesh.Points.begin(), mesh.Points.end());
  std::copy_if(
    mesh.Triangles.begin(), mesh.Triangles.end(), std::back_inserter(sound.Triangles), isSound);
  return sound;
}

/// As AutomaticMesh::VolumeBefore.
double InputVolume(const SurfaceView& sound)
{
  TriangleMesh turned = OrientConsistently(sound);
  SurfaceCorrection correction;
  turned.Triangles = OrientShells(turned, correction);
  const Bounds3 box = ComputeBounds(turned);
  const Point3 middle = 0.5 * (box.Min + box.Max);
  double sum = 0.0;
  for (const Triangle& t : turned.Triangles)
  {
    const auto at = [&](std::size_t c)
    { return turned.Points[static_cast<std::size_t>(t[c])] - middle; };
    sum += Dot(at(0), Cross(at(1), at(2)));
  }
  return std::abs(sum) / 6.0;
}

std::string Text(double value)
{
  return FormatNumber(value, 4);
}

class Attempts
{
public:
  Attempts(
    const SurfaceView& surface, TetrahedralParameters parameters, const ProgressCallback& progress)
    : Surface(surface)
    , Parameters(std::move(parameters))
    , Progress(progress)
  {
    // TetGen may run twice, and later stages take time too.
    this->Parameters.TetGen.Limits.TimeLimit *= 0.25;
  }

  AutomaticMesh Run()
  {
    const bool done = this->TryTetGen(this->Surface, MeshingBackend::TetGen, 0.0, 0.2) ||
      (this->TryRepair() &&
        (this->TryTetGen(this->Repaired->Mesh, MeshingBackend::RepairedTetGen, 0.3, 0.5) ||
          this->TryCGAL()));
    if (!done)
    {
      this->Stuff();
    }
    this->WriteReport();
    return std::move(this->Result);
  }

private:
  /// Runs `body` and stores its error for the report. Cancellation is not treated as an error.
  template <typename Body>
  bool Try(const char* what, Body&& body)
  {
    try
    {
      body();
      return true;
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::bad_alloc&)
    {
      this->Reasons += std::string(" ") + what + ": not enough memory.";
    }
    catch (const std::exception& error)
    {
      this->Reasons += std::string(" ") + what + ": " + error.what();
    }
    return false;
  }

  bool TryTetGen(const SurfaceView& mesh, MeshingBackend backend, double from, double to)
  {
    return this->Try("TetGen",
      [&]
      {
        this->Parameters.Library = TetrahedralLibrary::TetGen;
        this->Result.Mesh =
          MeshTetrahedra(mesh, this->Parameters, Between(this->Progress, from, to));
        this->Result.Backend = backend;
      });
  }

  bool TryRepair()
  {
    const bool clean = this->Try("Repair",
      [&]
      {
        this->Repaired = RepairSurface(this->Surface, Between(this->Progress, 0.2, 0.3));
        this->Changes = this->Repaired->Changes;
        RequireCleanSurface(this->Repaired->Mesh, {}, true);
        const TriangleMesh sound = ValidPart(this->Surface);
        const double lost = OneSidedDistance(sound, this->Repaired->Mesh);
        // If repair dropped parts, the mesh would represent another body.
        if (!(lost <= 0.02 * ComputeBounds(sound).Diagonal()))
        {
          throw std::runtime_error("it would lose parts that are " + Text(lost) + " away.");
        }
      });
    if (!clean)
    {
      this->Repaired.reset();
      this->Changes.clear();
    }
    return clean;
  }

  bool TryCGAL()
  {
    return this->Try("CGAL",
      [&]
      {
        this->Parameters.Library = TetrahedralLibrary::CGAL;
        this->Result.Mesh =
          MeshTetrahedra(this->Repaired->Mesh, this->Parameters, Between(this->Progress, 0.5, 0.7));
        this->Result.Backend = MeshingBackend::RepairedCGAL;
      });
  }

  void Stuff()
  {
    // Crossings and holes are harmless here, inconsistently oriented triangles are not.
    const TriangleMesh sound =
      this->Repaired ? this->Repaired->Mesh : OrientConsistently(ValidPart(this->Surface));
    const SolidStuffingParameters parameters{ this->Parameters.CGAL.CellSize, this->Parameters.Side,
      this->Parameters.BoxMargin, this->Parameters.TetGen.Limits.Bytes };
    try
    {
      this->Result.Mesh = StuffSolid(sound, parameters, Between(this->Progress, 0.7, 0.95));
    }
    catch (const std::invalid_argument& error)
    {
      throw std::invalid_argument(error.what() + this->Reasons);
    }
    this->Result.Backend = MeshingBackend::Stuffing;
  }

  void WriteReport()
  {
    AutomaticMesh& result = this->Result;
    result.Changes = this->Changes;
    for (std::int64_t& id : result.Mesh.OriginalPoints)
    {
      id = id < 0 || result.Backend != MeshingBackend::RepairedTetGen
        ? id
        : this->Repaired->OriginalPoints[static_cast<std::size_t>(id)];
    }
    const TriangleMesh sound = ValidPart(this->Surface);
    result.VolumeBefore = InputVolume(sound);
    const TriangleMesh boundary = this->BoundaryOfSolids();
    result.VolumeAfter = std::abs(SignedVolume(boundary));
    result.IsDoubtful =
      !(std::abs(result.VolumeAfter - result.VolumeBefore) <= 0.01 * result.VolumeBefore);
    const bool kept =
      result.Backend == MeshingBackend::TetGen && this->Parameters.TetGen.PreserveSurface;
    result.Hausdorff = kept ? 0.0 : HausdorffDistance(sound, boundary);
    static const char* const names[] = { "TetGen", "TetGen after repair", "CGAL after repair",
      "isosurface stuffing from the winding number" };
    result.Report = std::string("Tetrahedra by ") + names[static_cast<int>(result.Backend)] +
      (kept ? ": the surface is kept."
            : ": the surface moved by at most " + Text(result.Hausdorff) +
            ", the volume changed from " + Text(result.VolumeBefore) + " to " +
            Text(result.VolumeAfter) + ".");
    if (result.IsDoubtful)
    {
      result.Report +=
        " The volume is doubtful, since it depends on how holes are closed and crossings are "
        "interpreted: inspect the boundary of the mesh, or repair the surface beforehand.";
    }
    if (result.Backend != MeshingBackend::TetGen)
    {
      result.Report += (this->Changes.empty() ? "" : " " + this->Changes) +
        (this->Reasons.empty() ? "" : " Tried before:" + this->Reasons);
    }
  }

  /// With Outside it is the boundary of the meshed region, without the box.
  TriangleMesh BoundaryOfSolids() const
  {
    if (this->Parameters.Side != MeshedSide::Outside)
    {
      return BoundarySurface(this->Result.Mesh);
    }
    TetrahedralMesh outside = this->Result.Mesh;
    Bounds3 box{ outside.Points.at(0), outside.Points.at(0) };
    for (const Point3& p : outside.Points)
    {
      box.Add(p);
    }
    const double slack = 1e-7 * box.Diagonal(); // CGAL's corners of the box are rounded
    outside.Regions.assign(outside.Tetrahedra.size(), 1);
    TriangleMesh boundary = BoundarySurface(outside);
    const auto isBox = [&](const Triangle& t)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        for (const double at : { box.Min[a], box.Max[a] })
        {
          if (std::all_of(t.begin(), t.end(),
                [&](std::int64_t id) {
                  return std::abs(boundary.Points[static_cast<std::size_t>(id)][a] - at) < slack;
                }))
          {
            return true;
          }
        }
      }
      return false;
    };
    boundary.Triangles.erase(
      std::remove_if(boundary.Triangles.begin(), boundary.Triangles.end(), isBox),
      boundary.Triangles.end());
    return boundary;
  }

  SurfaceView Surface;
  TetrahedralParameters Parameters;
  const ProgressCallback& Progress;
  AutomaticMesh Result;
  std::optional<RepairedSurface> Repaired;
  std::string Changes;
  std::string Reasons;
};

}

AutomaticMesh AutomaticTetrahedra(const SurfaceView& surface,
  const TetrahedralParameters& parameters, const ProgressCallback& progress)
{
  for (const TetrahedralLibrary library : { TetrahedralLibrary::TetGen, TetrahedralLibrary::CGAL })
  {
    TetrahedralParameters both = parameters;
    both.Library = library;
    Check(both);
  }
  if (surface.Triangles.empty())
  {
    return {};
  }
  return Attempts(surface, parameters, progress).Run();
}

}
