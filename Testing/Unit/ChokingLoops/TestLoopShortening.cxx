// Geodesic loops against lengths known from formulas; their class; bad input.

#include "ChokingLoops/LoopShortening.h"
#include "ChokingSurfaces.h"
#include "vtkLoopShortening.h"

#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <set>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Large = 1.0;
constexpr double Small = 0.3;

/// A torus with `around` rings of `across` points; point ids as Torus() makes them.
struct TorusGrid
{
  TorusGrid(int around, int across)
    : Around(around)
    , Across(across)
    , Mesh(Torus(Large, Small, around, across))
    , Adjacency(Mesh)
  {
  }

  SimplexId Id(int i, int j) const
  {
    return static_cast<SimplexId>(
      (i + 2 * this->Around) % this->Around * this->Across + (j + 2 * this->Across) % this->Across);
  }

  /// Edges round the tube, with detours to the next ring and back.
  std::vector<SimplexId> RaggedMeridian(int i) const
  {
    std::vector<SimplexId> loop;
    for (int j = 0; j < this->Across; ++j)
    {
      loop.push_back(this->Id(i, j));
      if (j % 3 == 1 && j + 1 < this->Across)
      {
        loop.push_back(this->Id(i + 1, j + i % 2));
        loop.push_back(this->Id(i, j + 1));
        ++j;
      }
    }
    return loop;
  }

  /// Edges the long way around, on top of the tube.
  std::vector<SimplexId> Top() const
  {
    std::vector<SimplexId> loop;
    for (int i = 0; i < this->Around; ++i)
    {
      loop.push_back(this->Id(i, this->Across / 4));
    }
    return loop;
  }

  int Around;
  int Across;
  TriangleMesh Mesh;
  SurfaceAdjacency Adjacency;
};

double Sum(const SurfaceAdjacency& surface, const SurfaceCurve& curve)
{
  double length = 0.0;
  for (std::size_t i = 0; i < curve.Crossings.size(); ++i)
  {
    const Point3 d = ComputePosition(surface, curve.Crossings[(i + 1) % curve.Crossings.size()]) -
      ComputePosition(surface, curve.Crossings[i]);
    length += std::sqrt(Dot(d, d));
  }
  return length;
}

/// Consecutive crossings lie on one triangle, and no triangle is visited twice.
void ExpectSimpleAndClosed(const SurfaceCurve& curve, const SurfaceAdjacency& surface)
{
  std::set<SurfaceTriangleId> entered;
  for (std::size_t i = 0; i < curve.Crossings.size(); ++i)
  {
    const HalfEdgeId here = curve.Crossings[i].HalfEdge;
    const HalfEdgeId next = curve.Crossings[(i + 1) % curve.Crossings.size()].HalfEdge;
    EXPECT_EQ(SurfaceAdjacency::Triangle(here), SurfaceAdjacency::Triangle(surface.Opposite(next)));
    EXPECT_TRUE(entered.insert(SurfaceAdjacency::Triangle(here)).second);
  }
}

/// How often, mod 2, a curve crosses a loop of edges.
int Crossings(
  const SurfaceAdjacency& surface, const SurfaceCurve& curve, const std::vector<SimplexId>& loop)
{
  std::set<SurfaceEdgeId> edges;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const HalfEdgeId half = surface.Find(loop[i], loop[(i + 1) % loop.size()]);
    EXPECT_TRUE(half.Exists()) << "no edge after point " << i << " of the loop";
    if (half.Exists())
    {
      edges.insert(surface.Edge(half));
    }
  }
  int count = 0;
  for (const SurfaceCurvePoint& c : curve.Crossings)
  {
    count += static_cast<int>(edges.count(surface.Edge(c.HalfEdge)));
  }
  return count % 2;
}

TEST(LoopShortening, RoundTheTubeOfATorus)
{
  double before = HUGE_VAL;
  for (const int n : { 12, 24, 48 })
  {
    const TorusGrid torus(3 * n, n);
    const SurfaceCurve curve = ShortenLoop(torus.Adjacency, torus.RaggedMeridian(7));
    EXPECT_TRUE(curve.Converged);
    EXPECT_FALSE(curve.Contractible);
    EXPECT_NEAR(curve.Length, Sum(torus.Adjacency, curve), 1e-12);
    ExpectSimpleAndClosed(curve, torus.Adjacency);
    EXPECT_EQ(Crossings(torus.Adjacency, curve, torus.Top()), 1) << "its class";
    const double error = std::abs(curve.Length / (2.0 * M_PI * Small) - 1.0);
    EXPECT_LT(error, before / 3.0) << "not of second order at " << n;
    before = error;
  }
  EXPECT_LT(before, 0.002);
}

// The loop along the top must slide down to the inner equator, the only stable geodesic of its
// class.
TEST(LoopShortening, SlidesToTheInnerEquatorOfATorus)
{
  const TorusGrid torus(96, 32);
  const SurfaceCurve curve = ShortenLoop(torus.Adjacency, torus.Top(), { 2000, 1e-6 });
  EXPECT_TRUE(curve.Converged);
  ExpectSimpleAndClosed(curve, torus.Adjacency);
  EXPECT_EQ(Crossings(torus.Adjacency, curve, torus.RaggedMeridian(7)), 1);
  EXPECT_EQ(Crossings(torus.Adjacency, curve, torus.Top()), 0);
  EXPECT_NEAR(curve.Length, 2.0 * M_PI * (Large - Small), 0.003 * 2.0 * M_PI * (Large - Small));
}

TEST(LoopShortening, FindsTheNeckOfADumbbell)
{
  const double neck = 0.3;
  const int around = 60;
  const TriangleMesh mesh =
    Revolution([neck](double z) { return DumbbellRadius(z, neck); }, -2.0, 2.0, around, 120);
  const SurfaceAdjacency adjacency(mesh);
  std::vector<SimplexId> ring;
  for (int i = 0; i < around; ++i)
  {
    ring.push_back(static_cast<SimplexId>(1 + 66 * around + i)); // a ring well above the neck
  }
  const SurfaceCurve curve = ShortenLoop(adjacency, ring, { 2000, 1e-6 });
  EXPECT_TRUE(curve.Converged);
  EXPECT_NEAR(curve.Length, 2.0 * M_PI * neck, 0.003 * 2.0 * M_PI * neck);
}

// Bands of equal triangles unfold to straight strips: the geodesic's length is known exactly.
TEST(LoopShortening, IsExactOnACylinder)
{
  const int around = 24;
  const double radius = 0.5;
  const TriangleMesh mesh = Revolution([radius](double) { return radius; }, -2.0, 2.0, around, 30);
  const SurfaceAdjacency adjacency(mesh);
  const auto id = [](int i, int j)
  { return static_cast<SimplexId>(1 + (j - 1) * around + (i + around) % around); };
  std::vector<SimplexId> loop; // up one ring and down again, and up two
  for (int i = 0; i < around; ++i)
  {
    loop.push_back(id(i, 16));
    if (i % 4 == 1)
    {
      loop.push_back(id(i, 17));
      loop.push_back(id(i + 1, 18));
      loop.push_back(id(i + 1, 17));
    }
  }
  const SurfaceCurve curve = ShortenLoop(adjacency, loop);
  EXPECT_TRUE(curve.Converged);
  const double exact = 2.0 * around * radius * std::sin(M_PI / around);
  EXPECT_NEAR(curve.Length, exact, 1e-6 * exact);
}

TEST(LoopShortening, LeavesAContractibleLoopUnchanged)
{
  const TorusGrid torus(36, 12);
  const SimplexId p = torus.Id(5, 3);
  std::vector<SimplexId> link;
  const HalfEdgeId first = torus.Adjacency.Leaving(p);
  HalfEdgeId h = first;
  do
  {
    link.push_back(torus.Adjacency.To(h));
    h = torus.Adjacency.Turn(h);
  } while (h != first);
  const SurfaceCurve curve = ShortenLoop(torus.Adjacency, link);
  EXPECT_TRUE(curve.Contractible);
  EXPECT_FALSE(curve.Converged);
  EXPECT_EQ(curve.Crossings.size(), link.size());
  EXPECT_NEAR(curve.Length, Sum(torus.Adjacency, curve), 1e-12);
}

TEST(LoopShortening, StopsOnRequestAtAnyTime)
{
  const TorusGrid torus(96, 32);
  double last = -1.0;
  int calls = 0;
  ShortenLoop(torus.Adjacency, torus.Top(), { 2000, 1e-6 },
    [&](double fraction)
    {
      EXPECT_GT(fraction, last);
      last = fraction;
      ++calls;
      return true;
    });
  ASSERT_GT(calls, 2);
  for (int stop = 0; stop < calls; ++stop)
  {
    int call = 0;
    EXPECT_THROW(ShortenLoop(torus.Adjacency, torus.Top(), { 2000, 1e-6 },
                   [&call, stop](double) { return call++ < stop; }),
      Cancelled);
  }
}

/// The filter on one polyline through given points.
class ShortenedLoop
{
public:
  ShortenedLoop(const TriangleMesh& mesh, const std::vector<Point3>& polyline)
  {
    vtkNew<vtkPolyData> surface;
    SetMesh(mesh, surface);
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkPolyData> loops;
    if (!polyline.empty())
    {
      lines->InsertNextCell(static_cast<int>(polyline.size()));
    }
    for (const Point3& p : polyline)
    {
      lines->InsertCellPoint(points->InsertNextPoint(p.data()));
    }
    loops->SetPoints(points);
    loops->SetLines(lines);
    this->Filter->AddObserver(vtkCommand::ErrorEvent, this->Observer);
    this->Filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, this->Pipeline);
    this->Filter->SetInputData(loops);
    this->Filter->SetSurfaceData(surface);
    this->Filter->Update();
  }

  std::string Error() const { return this->Observer->GetErrorMessage(); }
  vtkPolyData* Result() { return this->Filter->GetOutput(); }

private:
  vtkNew<vtkLoopShortening> Filter;
  vtkNew<vtkTest::ErrorObserver> Observer, Pipeline;
};

TEST(LoopShortening, FilterJoinsFarPointsAlongTheSurface)
{
  // Four points round the tube, none of them a point of the mesh.
  ShortenedLoop shortened(Torus(Large, Small, 96, 32),
    { { 1.31, 0, 0 }, { 1, 0, 0.31 }, { 0.69, 0, 0 }, { 1, 0, -0.31 }, { 1.31, 0, 0 } });
  EXPECT_EQ(shortened.Error(), "");
  ASSERT_EQ(shortened.Result()->GetNumberOfCells(), 1);
  const double length = shortened.Result()->GetCellData()->GetArray("Length")->GetTuple1(0);
  EXPECT_NEAR(length, 2.0 * M_PI * Small, 0.01 * 2.0 * M_PI * Small);
}

TEST(LoopShortening, FilterReportsInvalidInput)
{
  const TriangleMesh torus = Torus(Large, Small, 48, 16);
  EXPECT_NE(ShortenedLoop(torus, { { 1.3, 0, 0 }, { 1.3, 0.01, 0 } }).Error().find("Loop 0"),
    std::string::npos);
  TriangleMesh two = torus;
  for (const Point3& p : torus.Points)
  {
    two.Points.push_back({ p[0] + 5.0, p[1], p[2] });
  }
  for (const Triangle& t : torus.Triangles)
  {
    const auto n = static_cast<std::int64_t>(torus.Points.size());
    two.Triangles.push_back({ t[0] + n, t[1] + n, t[2] + n });
  }
  ShortenedLoop across(two, { { 1.3, 0, 0 }, { 6.3, 0, 0 }, { 1.0, 0, 0.3 } });
  EXPECT_NE(across.Error().find("two parts"), std::string::npos);
  EXPECT_EQ(across.Result()->GetNumberOfCells(), 0);
  TriangleMesh open = torus;
  open.Triangles.pop_back();
  EXPECT_NE(
    ShortenedLoop(open, { { 1.3, 0, 0 }, { 1, 0, 0.3 }, { 0.7, 0, 0 } }).Error().find("hole"),
    std::string::npos);
  EXPECT_EQ(ShortenedLoop(torus, {}).Error(), "");
  EXPECT_EQ(ShortenedLoop(torus, {}).Result()->GetNumberOfCells(), 0);
}

}
