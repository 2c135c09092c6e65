#include "Tetrahedra/AutomaticMesher.h"

#include "Core/Geometry.h"
#include "Remeshing/SurfaceRepair.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "Tetrahedra/SolidStuffing.h"

#include <new>
#include <optional>
#include <set>
#include <sstream>

namespace isthmus
{
namespace
{

/// Triangles of finite points, each corner there and different.
TriangleMesh SoundPart(const SurfaceView& mesh)
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
double VolumeAsGiven(const SurfaceView& sound)
{
  const TriangleMesh turned = TurnedAlike(sound);
  const Bounds3 box = BoundsOf(turned);
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
  std::ostringstream text;
  text.precision(4);
  text << value;
  return text.str();
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
    this->Parameters.TetGen.Limits.Seconds *= 0.25;
  }

  AutomaticMesh Run()
  {
    const bool done = this->TryTetGen(this->Surface, MeshingWay::TetGen, 0.0, 0.2) ||
      (this->TryRepair() &&
        (this->TryTetGen(this->Repaired->Mesh, MeshingWay::RepairedTetGen, 0.3, 0.5) ||
          this->TryCGAL()));
    if (!done)
    {
      this->Stuff();
    }
    this->Tell();
    return std::move(this->Result);
  }

private:
  /// Runs `body`; what goes wrong is kept for the report. A request to stop is none of that.
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

  bool TryTetGen(const SurfaceView& mesh, MeshingWay way, double from, double to)
  {
    return this->Try("TetGen",
      [&]
      {
        this->Parameters.Library = TetrahedralLibrary::TetGen;
        this->Result.Mesh =
          MeshTetrahedra(mesh, this->Parameters, Between(this->Progress, from, to));
        this->Result.Way = way;
      });
  }

  bool TryRepair()
  {
    const bool clean = this->Try("Repair",
      [&]
      {
        this->Repaired = RepairSurface(this->Surface, Between(this->Progress, 0.2, 0.3));
        this->Changes = this->Repaired->Changes;
        DemandCleanSurface(this->Repaired->Mesh, {}, true);
        const TriangleMesh sound = SoundPart(this->Surface);
        const double lost = OneSidedDistance(sound, this->Repaired->Mesh);
        if (!(lost <= 0.02 * BoundsOf(sound).Diagonal()))
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
        this->Result.Way = MeshingWay::RepairedCGAL;
      });
  }

  void Stuff()
  {
    // Crossings and holes do no harm here, triangles turned against each other do.
    const TriangleMesh sound =
      this->Repaired ? this->Repaired->Mesh : TurnedAlike(SoundPart(this->Surface));
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
    this->Result.Way = MeshingWay::Stuffing;
  }

  void Tell()
  {
    AutomaticMesh& result = this->Result;
    result.Changes = this->Changes;
    for (std::int64_t& id : result.Mesh.OriginalPoints)
    {
      id = id < 0 || result.Way != MeshingWay::RepairedTetGen
        ? id
        : this->Repaired->OriginalPoints[static_cast<std::size_t>(id)];
    }
    const TriangleMesh sound = SoundPart(this->Surface);
    result.VolumeBefore = VolumeAsGiven(sound);
    const TriangleMesh skin = this->SkinOfSolids();
    result.VolumeAfter = std::abs(SignedVolume(skin));
    result.IsDoubtful =
      !(std::abs(result.VolumeAfter - result.VolumeBefore) <= 0.01 * result.VolumeBefore);
    const bool kept = result.Way == MeshingWay::TetGen && this->Parameters.TetGen.KeepSurface;
    result.Hausdorff = kept ? 0.0 : HausdorffDistance(sound, skin);
    static const char* const names[] = { "TetGen", "TetGen after repair", "CGAL after repair",
      "isosurface stuffing from the winding number" };
    result.Report = std::string("Tetrahedra by ") + names[static_cast<int>(result.Way)] +
      (kept
          ? ": the surface is kept."
          : ": the surface moved by at most " + Text(result.Hausdorff) + ", the volume went from " +
            Text(result.VolumeBefore) + " to " + Text(result.VolumeAfter) + ".");
    if (result.IsDoubtful)
    {
      result.Report += " The volume is doubtful: it depends on how holes are closed and crossings "
                       "understood; look at the skin of the mesh, or mend the surface before.";
    }
    if (result.Way != MeshingWay::TetGen)
    {
      result.Report += (this->Changes.empty() ? "" : " " + this->Changes) +
        (this->Reasons.empty() ? "" : " Tried before:" + this->Reasons);
    }
  }

  /// For the outside alone it is the skin of what is not meshed, but for the box.
  TriangleMesh SkinOfSolids() const
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
    TriangleMesh skin = BoundarySurface(outside);
    const auto isBox = [&](const Triangle& t)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        for (const double at : { box.Min[a], box.Max[a] })
        {
          if (std::all_of(t.begin(), t.end(),
                [&](std::int64_t id)
                { return std::abs(skin.Points[static_cast<std::size_t>(id)][a] - at) < slack; }))
          {
            return true;
          }
        }
      }
      return false;
    };
    skin.Triangles.erase(
      std::remove_if(skin.Triangles.begin(), skin.Triangles.end(), isBox), skin.Triangles.end());
    return skin;
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
    CheckTetrahedralParameters(both);
  }
  if (surface.Triangles.empty())
  {
    return {};
  }
  return Attempts(surface, parameters, progress).Run();
}

}
