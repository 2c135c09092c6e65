#include "ChokingLoops/HandleFilling.h"

#include "ChokingLoops/ChokingSurface.h"
#include "ChokingLoops/EnclosureTest.h"
#include "ChokingLoops/LoopFeature.h"
#include "ChokingLoops/MembranePlate.h"
#include "Remeshing/SelfIntersections.h"
#include "Remeshing/SurfaceBoolean.h"
#include "Remeshing/ThinTriangles.h"
#include "Surfaces/SurfaceCheck.h"
#include "Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

constexpr int UntilGeodesic = 1000;

/// Plates are tried as thick as asked for, then thinner; with rims so wide, in thicknesses.
constexpr std::array<double, 4> Thinner{ 1.0, 0.5, 0.25, 0.125 };
constexpr std::array<double, 3> Rims{ 0.5, 1.0, 2.0 };

/// A plate encloses its membrane's area times its thickness, within this factor.
constexpr double VolumeFactor = 2.0;

/// Edges shorter than that where plate and surface meet are collapsed, in thicknesses.
constexpr double Finest = 0.05;

struct Topology
{
  std::int64_t Characteristic = 0;
  int Components = 0;
  double Volume = 0.0;

  explicit Topology(const SurfaceView& mesh)
    : Characteristic(EulerCharacteristic(mesh))
    , Volume(SignedVolume(mesh))
  {
    const std::vector<int> parts = isthmus::Components(mesh);
    this->Components = parts.empty() ? 0 : 1 + *std::max_element(parts.begin(), parts.end());
  }

  std::int64_t Genus() const { return this->Components - this->Characteristic / 2; }
};

double DistanceBetween(const std::vector<Point3>& a, const std::vector<Point3>& b)
{
  double least = HUGE_VAL;
  for (const Point3& p : a)
  {
    for (const Point3& q : b)
    {
      least = std::min(least, Distance(p, q));
    }
  }
  return least;
}

/// The features of one analysis, and what is made of the surface by filling them.
class FillingRound
{
public:
  FillingRound(FilledSurface& result, const HandleFillingParameters& parameters,
    const ProgressCallback& progress)
    : Result(result)
    , Parameters(parameters)
    , Loops(result.Mesh, WithoutCheck(parameters.Analysis), Between(progress, 0.0, 0.6))
    , Space(this->Loops.Samples(), this->Loops.Homology())
    , Now(result.Mesh)
  {
    const std::vector<std::size_t> small = this->Small();
    for (std::size_t i = 0; i < small.size(); ++i)
    {
      const double done = static_cast<double>(i) / static_cast<double>(small.size());
      Report(progress, 0.6 + 0.4 * done);
      this->Fill(small[i]);
    }
  }

  std::size_t Filled = 0;
  std::size_t Waiting = 0; ///< cross one that was filled
  std::size_t Failed = 0;

private:
  struct Done
  {
    FeatureKind Kind;
    MembranePlate Plate;
  };

  static ChokingLoopParameters WithoutCheck(ChokingLoopParameters parameters)
  {
    parameters.AllowSelfIntersections = true; // it was checked before
    return parameters;
  }

  std::vector<std::size_t> Small() const
  {
    const std::vector<ShapeFeature>& features = this->Loops.Diagram().Features;
    std::vector<std::size_t> small;
    for (std::size_t i = 0; i < features.size(); ++i)
    {
      const bool isWanted = features[i].Kind == FeatureKind::Handle ? this->Parameters.Inside
                                                                    : this->Parameters.Outside;
      if (IsGenerator(features[i]) && isWanted && features[i].Distance() < this->Parameters.Below)
      {
        small.push_back(i);
      }
    }
    return small;
  }

  void Fill(std::size_t index)
  {
    const ShapeFeature& feature = this->Loops.Diagram().Features[index];
    const LoopFeature geometry = MakeLoopFeature(this->Loops, index, UntilGeodesic);
    std::vector<Point3> loop;
    if (geometry.Loops.size() == 1)
    {
      for (const SimplexId p : geometry.Loops.front())
      {
        loop.push_back(geometry.Point(p, this->Loops.Samples()));
      }
    }
    if (!loop.empty() && this->Crosses(feature.Kind, loop))
    {
      ++this->Waiting;
    }
    else if (loop.empty() || !this->FillOne(feature, loop))
    {
      ++this->Failed;
    }
  }

  /// One of the other side that was filled: on the same side, plates may share room.
  bool Crosses(FeatureKind kind, const std::vector<Point3>& loop) const
  {
    return std::any_of(this->Plates.begin(), this->Plates.end(),
      [&](const Done& done)
      {
        const double apart = DistanceBetween(done.Plate.Loop, loop);
        const double step = Distance(done.Plate.Loop[0], done.Plate.Loop[1]);
        return done.Kind != kind && apart < 4.0 * done.Plate.Thickness + step;
      });
  }

  bool FillOne(const ShapeFeature& feature, const std::vector<Point3>& loop)
  {
    for (const double thinner : Thinner)
    {
      const double thickness = thinner * this->Parameters.Thickness * feature.Distance();
      for (const double rim : Rims)
      {
        const auto plate = PlateOn(loop, thickness, rim * thickness);
        if (plate && this->IsHeld(*plate, feature.Kind) && this->Accept(feature, *plate))
        {
          return true;
        }
      }
    }
    return false;
  }

  /// The plate's edge lies in the wall: of a tunnel's inside the surface, of a handle's outside.
  bool IsHeld(const MembranePlate& plate, FeatureKind kind) const
  {
    return std::all_of(plate.Solid.Points.begin(), plate.Solid.Points.end(),
      [&](const Point3& p)
      { return (this->Space.Enclosing(p).size() % 2 == 1) == (kind == FeatureKind::Tunnel); });
  }

  bool Accept(const ShapeFeature& feature, const MembranePlate& plate)
  {
    const bool isTunnel = feature.Kind == FeatureKind::Tunnel;
    const int tag = 1 + static_cast<int>(this->Result.Fills.size());
    const TaggedSurface before{ this->Result.Mesh, this->Result.Filling };
    const TaggedSurface added{ plate.Solid, std::vector<int>(plate.Solid.Triangles.size(), tag) };
    TaggedSurface after;
    try
    {
      after =
        Combined(before, added, isTunnel ? BooleanOperation::Union : BooleanOperation::Difference,
          Finest * plate.Thickness);
    }
    catch (const std::runtime_error&)
    {
      return false; // another plate may do; if none does, it is counted
    }
    const Topology then(after.Mesh);
    const double change = (isTunnel ? 1.0 : -1.0) * (then.Volume - this->Now.Volume);
    const double ratio = change / (plate.Area * plate.Thickness);
    if (then.Components != this->Now.Components || then.Genus() + 1 != this->Now.Genus() ||
      !(ratio < VolumeFactor) || !(VolumeFactor * ratio > 1.0) || !this->IsSound(after.Mesh))
    {
      return false;
    }
    this->Result.Mesh = std::move(after.Mesh);
    this->Result.Filling = std::move(after.Tags);
    this->Result.Fills.push_back({ feature.Kind, feature.Distance(), plate.Area, plate.Thickness });
    this->Plates.push_back({ feature.Kind, plate });
    this->Now = then;
    ++this->Filled;
    return true;
  }

  bool IsSound(const SurfaceView& mesh) const
  {
    return FindDefects(mesh).None() && SelfIntersections(mesh).empty() &&
      ThinTriangles(mesh).size() <= ThinTriangles(this->Result.Mesh).size();
  }

  FilledSurface& Result;
  const HandleFillingParameters& Parameters;
  ChokingLoops Loops;
  EnclosureTest Space;
  Topology Now;
  std::vector<Done> Plates;
};

}

FilledSurface FillHandles(
  TriangleMesh surface, const HandleFillingParameters& parameters, const ProgressCallback& progress)
{
  if (!(parameters.Below > 0.0) || !std::isfinite(parameters.Below))
  {
    throw std::invalid_argument("FillHandlesBelow has to be above 0 and finite: the radius below "
                                "which handles and tunnels are filled.");
  }
  if (!(parameters.Thickness > 0.0 && parameters.Thickness <= 1.0))
  {
    throw std::invalid_argument("The thickness of fillings has to be above 0 and at most one "
                                "radius.");
  }
  FilledSurface result;
  result.Mesh = OutwardSurface(
    CheckedSurface(std::move(surface), false, Between(progress, 0.0, 0.2), &result.Mended));
  result.Filling.assign(result.Mesh.Triangles.size(), 0);
  double from = 0.2;
  for (result.Genus = Topology(result.Mesh).Genus(); result.Genus > 0;)
  {
    const double to = 0.5 * (1.0 + from); // a second round is the exception
    const FillingRound round(result, parameters, Between(progress, from, to));
    result.Left = round.Failed + round.Waiting;
    result.Genus -= static_cast<std::int64_t>(round.Filled);
    if (round.Waiting == 0 || round.Filled == 0)
    {
      break;
    }
    result.Left = 0; // those of the next round, if any
    from = to;
  }
  Report(progress, 1.0);
  return result;
}

}
