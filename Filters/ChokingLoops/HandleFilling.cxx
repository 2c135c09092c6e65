#include "ChokingLoops/HandleFilling.h"

#include "ChokingLoops/FeatureDiagram.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/Index.h"
#include "Remeshing/SelfIntersections.h"
#include "Remeshing/SurfaceBoolean.h"
#include "Remeshing/ThinTriangles.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// MembranePlate
namespace
{

constexpr double FewestPoints = 32.0;
constexpr double MostPoints = 256.0;

/// Each round averages a direction with its two neighbours; together they cover about two rim
/// widths.
constexpr int SmoothingRounds = 8;

double CurveLength(const std::vector<Point3>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += Distance(loop[i], loop[(i + 1) % loop.size()]);
  }
  return length;
}

/// `count` points of a closed polyline, equally far apart along it.
std::vector<Point3> Evenly(const std::vector<Point3>& loop, double length, std::size_t count)
{
  std::vector<Point3> points;
  double passed = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point3& p = loop[i];
    const Point3& q = loop[(i + 1) % loop.size()];
    const double edge = Distance(p, q);
    while (points.size() < count)
    {
      const double along =
        static_cast<double>(points.size()) / static_cast<double>(count) * length - passed;
      if (along > edge || edge <= 0.0)
      {
        break;
      }
      points.push_back(p + (along / edge) * (q - p));
    }
    passed += edge;
  }
  return points;
}

Point3 Unit(const Point3& v)
{
  const double length = Length(v);
  return length > 0.0 ? (1.0 / length) * v : v;
}

/// Makes unit vectors along a closed loop change slowly: otherwise vectors of neighbours would
/// cross at sharp bends.
void Smooth(std::vector<Point3>& directions)
{
  const std::size_t n = directions.size();
  std::vector<Point3> before(n);
  for (int round = 0; round < SmoothingRounds; ++round)
  {
    std::transform(directions.begin(), directions.end(), before.begin(), Unit);
    for (std::size_t i = 0; i < n; ++i)
    {
      directions[i] = Unit(before[(i + n - 1) % n] + 2.0 * before[i] + before[(i + 1) % n]);
    }
  }
}

/// At each point of the loop: the membrane's normal, and its direction beyond the loop.
struct Frame
{
  std::vector<Point3> Normals;
  std::vector<Point3> Outward;
};

Frame ComputeFrame(const std::vector<Point3>& loop, const std::vector<Triangle>& filling)
{
  const std::size_t n = loop.size();
  Frame frame{ std::vector<Point3>(n, Point3{ 0, 0, 0 }),
    std::vector<Point3>(n, Point3{ 0, 0, 0 }) };
  for (const Triangle& t : filling)
  {
    const Point3& origin = loop[At(t[0])];
    const Point3 normal = Cross(loop[At(t[1])] - origin, loop[At(t[2])] - origin);
    for (std::size_t k = 0; k < 3; ++k)
    {
      const std::size_t from = At(t[k]);
      const std::size_t to = At(t[(k + 1) % 3]);
      frame.Normals[from] = frame.Normals[from] + normal;
      const std::size_t step = from < to ? to - from : from - to;
      if (step == 1 || step == n - 1) // an edge of the loop
      {
        const Point3 outward = Unit(Cross(loop[to] - loop[from], normal));
        frame.Outward[from] = frame.Outward[from] + outward;
        frame.Outward[to] = frame.Outward[to] + outward;
      }
    }
  }
  for (std::vector<Point3>* directions : { &frame.Normals, &frame.Outward })
  {
    Smooth(*directions);
  }
  return frame;
}

/// The filling of the rim, above and below, and a wall. Corners are at a distance from the loop,
/// since on a straight wall they could lie on it, up to rounding.
TriangleMesh MakeSolid(const MembranePlate& plate, const std::vector<Triangle>& filling,
  const Frame& frame, double rim, bool isAlong)
{
  const std::size_t n = plate.Loop.size();
  TriangleMesh solid;
  for (const double up : { 0.5 * plate.Thickness, -0.5 * plate.Thickness })
  {
    for (std::size_t i = 0; i < n; ++i)
    {
      solid.Points.push_back(plate.Loop[i] + rim * frame.Outward[i] + up * frame.Normals[i]);
    }
  }
  const auto below = static_cast<std::int64_t>(n);
  for (const Triangle& t : filling)
  {
    solid.Triangles.push_back(t);
    solid.Triangles.push_back({ t[0] + below, t[2] + below, t[1] + below });
  }
  for (std::int64_t k = 0; k < below; ++k)
  {
    const std::int64_t i = isAlong ? k : (k + 1) % below; // an edge of the filling runs from i to j
    const std::int64_t j = isAlong ? (k + 1) % below : k;
    solid.Triangles.push_back({ j, i, i + below });
    solid.Triangles.push_back({ j, i + below, j + below });
  }
  return solid;
}

/// True if an edge of the filling connects consecutive points of the loop.
bool RunsAlong(const std::vector<Triangle>& filling, std::size_t n)
{
  for (const Triangle& t : filling)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      if ((At(t[k]) + 1) % n == At(t[(k + 1) % 3]))
      {
        return true;
      }
    }
  }
  return false;
}

}

std::optional<MembranePlate> PlateOn(const std::vector<Point3>& loop, double thickness, double rim)
{
  const double length = CurveLength(loop);
  if (loop.size() < 3 || !(length > 0.0))
  {
    return std::nullopt;
  }
  const double count = std::clamp(std::ceil(2.0 * length / rim), FewestPoints, MostPoints);
  MembranePlate plate;
  plate.Thickness = thickness;
  plate.Loop = Evenly(loop, length, static_cast<std::size_t>(count));
  const std::vector<Triangle> filling = PolygonFilling(plate.Loop);
  if (filling.size() + 2 != plate.Loop.size())
  {
    return std::nullopt;
  }
  plate.Area = SurfaceArea({ plate.Loop, filling });
  const Frame frame = ComputeFrame(plate.Loop, filling);
  plate.Solid = MakeSolid(plate, filling, frame, rim, RunsAlong(filling, plate.Loop.size()));
  if (!SelfIntersections(plate.Solid).empty())
  {
    return std::nullopt;
  }
  return plate;
}

// ------------------------------------------------------------------------------------------
// HandleFilling
namespace
{

constexpr int UntilGeodesic = 1000;

/// Plates are tried with the given thickness, then thinner; widths of rims in thicknesses.
constexpr std::array<double, 4> Thinner{ 1.0, 0.5, 0.25, 0.125 };
constexpr std::array<double, 3> Rims{ 0.5, 1.0, 2.0 };

/// A plate encloses its membrane's area times its thickness, within this factor.
constexpr double VolumeFactor = 2.0;

/// Shorter edges where plate and surface meet are collapsed, in thicknesses.
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

/// The features of one analysis, and the surface that results from filling them.
class FillingRound
{
public:
  FillingRound(FilledSurface& result, const HandleFillingParameters& parameters,
    const ProgressCallback& progress)
    : Result(result)
    , Parameters(parameters)
    , Loops(result.Mesh, WithoutCheck(parameters), Between(progress, 0.0, 0.6))
    , Before(result.Mesh)
    , Adjacency(this->Before)
    , Homology(this->Adjacency)
    , Space(this->Before, this->Homology)
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
  std::size_t Waiting = 0; ///< cross a membrane that was filled
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
      const bool isWanted = this->Parameters.Side !=
        (features[i].Kind == FeatureKind::Handle ? SideSelection::Outside : SideSelection::Inside);
      if (IsGenerator(features[i]) && isWanted &&
        features[i].Radius() < this->Parameters.FillHandlesBelow)
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

  /// A filled feature of the other side: on the same side, plates may overlap.
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
      const double thickness = thinner * this->Parameters.Thickness * feature.Radius();
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
      after = CombineSurfaces(before, added,
        isTunnel ? BooleanOperation::Union : BooleanOperation::Difference,
        Finest * plate.Thickness);
    }
    catch (const std::runtime_error&)
    {
      return false; // another plate may succeed; if none does, it is counted as failed
    }
    const Topology then(after.Mesh);
    const double change = (isTunnel ? 1.0 : -1.0) * (then.Volume - this->Now.Volume);
    const double ratio = change / (plate.Area * plate.Thickness);
    if (then.Components != this->Now.Components || then.Genus() + 1 != this->Now.Genus() ||
      !(ratio < VolumeFactor) || !(VolumeFactor * ratio > 1.0) || !this->IsCleanResult(after.Mesh))
    {
      return false;
    }
    this->Result.Mesh = std::move(after.Mesh);
    this->Result.Filling = std::move(after.Tags);
    this->Result.Fills.push_back({ feature.Kind, feature.Radius(), plate.Area, plate.Thickness });
    this->Plates.push_back({ feature.Kind, plate });
    this->Now = then;
    ++this->Filled;
    return true;
  }

  bool IsCleanResult(const SurfaceView& mesh) const
  {
    return FindDefects(mesh).None() && SelfIntersections(mesh).empty() &&
      ThinTriangles(mesh).size() <= ThinTriangles(this->Result.Mesh).size();
  }

  FilledSurface& Result;
  const HandleFillingParameters& Parameters;
  ChokingLoops Loops;
  TriangleMesh Before;
  SurfaceAdjacency Adjacency;
  SurfaceHomology Homology;
  EnclosureTest Space;
  Topology Now;
  std::vector<Done> Plates;
};

}

FilledSurface FillHandles(
  TriangleMesh surface, const HandleFillingParameters& parameters, const ProgressCallback& progress)
{
  Check(parameters);
  FilledSurface result;
  result.Mesh = OutwardSurface(
    CheckedSurface(std::move(surface), false, Between(progress, 0.0, 0.2), &result.Repairs));
  result.Filling.assign(result.Mesh.Triangles.size(), 0);
  double from = 0.2;
  for (result.Genus = Topology(result.Mesh).Genus(); result.Genus > 0;)
  {
    const double to = 0.5 * (1.0 + from); // a second round is rare
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
