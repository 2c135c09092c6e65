// On every shared surface: the filter's counts, loops and tables agree; each loop is long enough to
// enclose its ball, and has no sharp corners.

#include "ChokingLoops/LoopDrawing.h"
#include "ChokingLoops/SurfacePaths.h"
#include "ChokingSurfaces.h"
#include "Surfaces/SurfaceCleaning.h"
#include "vtkChokingLoops.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkLogger.h>
#include <vtkPointData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// The report of the loops for each feature.
struct ReportedFeature
{
  int Kind = 0;
  int Side = 0;
  double Radius = 0.0;
  double Uncertainty = 0.0;
  bool IsTrusted = false;
  double Longest = 0.0;
  std::vector<std::vector<Point3>> Loops;
};

double At(vtkDataSetAttributes* data, const char* name, vtkIdType i)
{
  return data->GetArray(name)->GetTuple1(i);
}

std::map<int, ReportedFeature> CollectReported(vtkPolyData* loops)
{
  std::map<int, ReportedFeature> reported;
  vtkCellData* data = loops->GetCellData();
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < loops->GetNumberOfCells(); ++c)
  {
    ReportedFeature& t = reported[static_cast<int>(At(data, "FeatureId", c))];
    t.Kind = static_cast<int>(At(data, "Kind", c));
    t.Side = static_cast<int>(At(data, "Side", c));
    t.Radius = At(data, "Radius", c);
    t.Uncertainty = At(data, "Uncertainty", c);
    t.IsTrusted = At(data, "Trusted", c) != 0.0;
    t.Longest = std::max(t.Longest, At(data, "Length", c));
    loops->GetLines()->GetCellAtId(c, ids);
    std::vector<Point3> polygon;
    for (vtkIdType i = 0; i + 1 < ids->GetNumberOfIds(); ++i)
    {
      Point3 p;
      loops->GetPoint(ids->GetId(i), p.data());
      polygon.push_back(p);
    }
    t.Loops.push_back(polygon);
    EXPECT_EQ(ids->GetId(0), ids->GetId(ids->GetNumberOfIds() - 1)) << "not closed";
    EXPECT_EQ(At(data, "Birth", c), t.Radius);
    EXPECT_EQ(At(data, "Persistence", c), At(data, "Death", c) - At(data, "Birth", c));
  }
  return reported;
}

/// Loops, membranes, choke points, diagram and field data are consistent.
void ExpectAgreement(vtkChokingLoops* filter, const std::map<int, ReportedFeature>& reported)
{
  vtkPolyData* loops = filter->GetOutput();
  std::array<vtkIdType, 4> counts{};
  for (const auto& [id, t] : reported)
  {
    ++counts[static_cast<std::size_t>(t.Kind < 2 ? t.Kind : 2 + t.Side)];
  }
  vtkFieldData* facts = loops->GetFieldData();
  EXPECT_EQ(facts->GetArray("NumberOfHandles")->GetTuple1(0), counts[0]);
  EXPECT_EQ(facts->GetArray("NumberOfTunnels")->GetTuple1(0), counts[1]);
  EXPECT_EQ(facts->GetArray("NumberOfAdditionalLoops")->GetTuple1(0), counts[2]);
  EXPECT_EQ(facts->GetArray("NumberOfAdditionalLoops")->GetTuple1(1), counts[3]);
  auto* points = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(2));
  ASSERT_EQ(points->GetNumberOfPoints(), static_cast<vtkIdType>(reported.size()));
  vtkDataSetAttributes* rows = vtkTable::SafeDownCast(filter->GetOutputDataObject(3))->GetRowData();
  for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
  {
    const auto id = static_cast<int>(At(points->GetPointData(), "FeatureId", i));
    const ReportedFeature& t = reported.at(id);
    EXPECT_EQ(At(points->GetPointData(), "Radius", i), t.Radius);
    ASSERT_LT(id, rows->GetArray("FeatureId")->GetNumberOfTuples());
    EXPECT_EQ(At(rows, "FeatureId", id), id);
    EXPECT_EQ(At(rows, "Kind", id), t.Kind);
    EXPECT_EQ(At(rows, "Side", id), t.Side);
    EXPECT_EQ(At(rows, At(rows, "Dimension", id) == 1 ? "Death" : "Birth", id), t.Radius);
    EXPECT_EQ(At(rows, "Radius", id), t.Radius);
  }
  auto* membranes = vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
  std::set<int> spanned;
  for (vtkIdType c = 0; c < membranes->GetNumberOfCells(); ++c)
  {
    spanned.insert(static_cast<int>(At(membranes->GetCellData(), "FeatureId", c)));
  }
  EXPECT_EQ(spanned.size(), reported.size());
  for (vtkIdType c = 0; c < loops->GetNumberOfCells(); ++c)
  {
    const auto first = static_cast<int>(At(loops->GetCellData(), "SharedWith", c));
    EXPECT_TRUE(first < 0 || reported.count(first) == 1) << first;
  }
}

/// Angles between neighbouring triangles of a closed surface.
class SurfaceEdges
{
public:
  explicit SurfaceEdges(const TriangleMesh& mesh)
    : Mesh(mesh)
    , Surface(Mesh)
  {
    for (const HalfEdgeId h : this->Surface.HalfEdges())
    {
      const Point3 a = this->Normal(SurfaceAdjacency::Triangle(h));
      const Point3 b = this->Normal(SurfaceAdjacency::Triangle(this->Surface.Opposite(h)));
      const Point3 c = Cross(a, b);
      this->Angles.push_back(std::atan2(std::sqrt(Dot(c, c)), Dot(a, b)));
    }
  }

  /// The largest at the edges that pass `p`, and at those that share an end with them.
  double SharpestAt(const Point3& p, double reach) const
  {
    std::set<SimplexId> ends;
    this->ForEdges(
      [&](HalfEdgeId h)
      {
        if (IsSurrounded(
              p, reach, { this->At(this->Surface.From(h)), this->At(this->Surface.To(h)) }))
        {
          ends.insert({ this->Surface.From(h), this->Surface.To(h) });
        }
      });
    double sharpest = 0.0;
    this->ForEdges(
      [&](HalfEdgeId h)
      {
        if (ends.count(this->Surface.From(h)) + ends.count(this->Surface.To(h)) > 0)
        {
          sharpest = std::max(sharpest, this->Angles[h]);
        }
      });
    return sharpest;
  }

private:
  const Point3& At(SimplexId p) const { return this->Mesh.Points[static_cast<std::size_t>(p)]; }
  Point3 Normal(SurfaceTriangleId t) const
  {
    const Triangle& c = this->Mesh.Triangles[t.Index()];
    const auto p = [&](std::size_t k) { return this->Mesh.Points[static_cast<std::size_t>(c[k])]; };
    return Cross(p(1) - p(0), p(2) - p(0));
  }
  template <typename Visit>
  void ForEdges(Visit&& visit) const
  {
    for (const HalfEdgeId h : this->Surface.HalfEdges())
    {
      visit(h);
    }
  }

  TriangleMesh Mesh;
  SurfaceAdjacency Surface;
  HandleVector<HalfEdgeId, double> Angles;
};

/// A loop turns by more than 60 degrees only where the surface itself bends by three quarters of
/// that, or where the samples are too far apart for the ball to cut it: straight on, a path over an
/// edge turns by no more than the edge does, and by somewhat more at a point where several meet.
/// Nothing is required where the distance of samples exceeds the ball's diameter.
void ExpectNoCorners(const SurfaceEdges& edges, const std::vector<Point3>& loop,
  const ReportedFeature& reported, int feature)
{
  const double radius = reported.Radius;
  // Above half the radius: then the uncertainty is d - sqrt(d^2 - e^2) > 0.134 d.
  const bool isCoarse = reported.Uncertainty > 0.134 * radius;
  if (reported.Uncertainty >= radius)
  {
    return;
  }
  std::vector<Point3> corners; // that are apart
  for (const Point3& p : loop)
  {
    const Point3 d = corners.empty() ? Point3{ radius, 0, 0 } : p - corners.back();
    if (std::sqrt(Dot(d, d)) > 1e-6 * radius)
    {
      corners.push_back(p);
    }
  }
  const std::size_t n = corners.size();
  for (std::size_t i = 0; n > 2 && i < n; ++i)
  {
    const Point3 in = corners[i] - corners[(i + n - 1) % n];
    const Point3 out = corners[(i + 1) % n] - corners[i];
    const Point3 c = Cross(in, out);
    const double turn = std::atan2(std::sqrt(Dot(c, c)), Dot(in, out));
    if (turn >= (isCoarse ? M_PI / 2.0 : M_PI / 3.0))
    {
      EXPECT_GE(edges.SharpestAt(corners[i], 1e-4 * radius), M_PI / 4.0)
        << "feature " << feature << " of radius " << radius << " turns by " << turn * 180.0 / M_PI
        << " degrees at " << corners[i][0] << " " << corners[i][1] << " " << corners[i][2];
    }
  }
}

class EverySurface : public ::testing::TestWithParam<const char*>
{
};

TEST_P(EverySurface, AgreesWithItself)
{
  ISTHMUS_NEEDS_SHARED_DATA(std::string("surfaces/") + GetParam());
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_ERROR);
  const TriangleMesh mesh = ReadSurface(GetParam());
  vtkNew<vtkPolyData> surface;
  SetMesh(mesh, surface);
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkChokingLoops> filter;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->SetInputData(surface);
  filter->Update();
  ASSERT_FALSE(observer->GetError()) << observer->GetErrorMessage();
  const std::map<int, ReportedFeature> reported = CollectReported(filter->GetOutput());
  ExpectAgreement(filter, reported);
  const SurfaceEdges edges(MergePoints(mesh));
  vtkDataSetAttributes* data = filter->GetOutput()->GetCellData();
  int shared = 0;
  for (vtkIdType c = 0; c < filter->GetOutput()->GetNumberOfCells(); ++c)
  {
    shared += At(data, "SharedWith", c) >= 0.0;
  }
  double least = HUGE_VAL;
  double sharpest = 0.0;
  for (const auto& [id, t] : reported)
  {
    const double bound = 2.0 * M_PI * (t.Radius - t.Uncertainty);
    if (t.IsTrusted)
    {
      least = std::min(least, t.Longest / bound);
      EXPECT_GE(t.Longest, 0.98 * bound) << "feature " << id;
    }
    for (const auto& loop : t.Loops)
    {
      sharpest = std::max(sharpest, SharpestTurn(loop, 1e-6 * t.Radius));
      ExpectNoCorners(edges, loop, t, id);
    }
  }
  std::cout << GetParam() << ": " << reported.size() << " features, shortest " << least
            << " of its bound; sharpest turn " << sharpest * 180.0 / M_PI << " degrees, shared "
            << shared << "\n";
}

INSTANTIATE_TEST_SUITE_P(Shared, EverySurface,
  ::testing::Values("129110__sf.obj", "1514499.stl", "2sphere.off", "3holes.off", "65004.stl",
    "697224__sf.obj", "72214.stl", "Kitten.off", "armadillo.obj", "botijo.off", "bumpy.off",
    "bunny.off", "casting.off", "cup_input_simple_10000.off", "double-torus.obj", "eight.off",
    "elk.off", "emd_5043.obj", "fandisk.off", "fertility.off", "genus3.off", "helix.off",
    "helmet.off", "knot1.off", "quadknot.obj", "olivier_hand.off", "rocker-arm.obj",
    "rocker_arm_1600.off", "skull_low_resolution.obj", "soccerball.obj", "sphere.off", "spot.obj",
    "torus.obj", "torus_binary.stl", "torus_rdzhao.off", "two-tori.obj"),
  [](const auto& test)
  {
    std::string name = test.param;
    std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); },
      '_');
    return name;
  });

}
