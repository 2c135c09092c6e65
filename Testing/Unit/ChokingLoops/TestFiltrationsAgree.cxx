// Handles, tunnels and narrowings by both filtrations of Choking Loops, on tori and necklaces whose
// values are known and on shared surfaces; three of the thirty in each run (LongTests.h).

#include "BeadShapes.h"
#include "ChokingSurfaces.h"
#include "LongTests.h"
#include "Persistence/SurfaceDistance.h"
#include "Surfaces/HausdorffDistance.h"
#include "Surfaces/ShellNesting.h"
#include "TopologyFilterRun.h"
#include "vtkChokingLoops.h"

#include <vtkCellData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

/// Known features of a surface.
struct KnownValues
{
  std::array<double, 2> Polyhedron; ///< radii of the handle and of the tunnel
  std::array<double, 2> Smooth;     ///< those of the smooth surface
  double Hausdorff;                 ///< distance of the polyhedron from the smooth surface
};

struct SurfaceCase
{
  std::string Name;
  std::function<TriangleMesh()> Make;
  std::function<KnownValues(const TriangleMesh&)> Know; ///< none: nothing is known
};

/**
 * The value at which a ball passes through a narrowing of `surface` at `place`: the least along
 * `axis`, from -along to along, of the largest distance on a disk of radius `across`. Sampled; too
 * large by no more than the last step along the axis.
 */
double ValueAt(
  const SurfaceView& surface, const Point3& place, const Point3& axis, double along, double across)
{
  const Point3 other = std::abs(axis[2]) < 0.9 ? Point3{ 0, 0, 1 } : Point3{ 1, 0, 0 };
  const Point3 u = (1.0 / Length(Cross(axis, other))) * Cross(axis, other);
  const Point3 v = Cross(axis, u);
  const auto widest = [&](double t)
  {
    Point3 center = place + t * axis;
    double largest = 0.0;
    for (double size = across; size > 1e-4 * across; size *= 0.3)
    {
      std::vector<Point3> points;
      constexpr int steps = 8;
      for (int i = -steps; i <= steps; ++i)
      {
        for (int j = -steps; j <= steps; ++j)
        {
          points.push_back(center + (size * i / steps) * u + (size * j / steps) * v);
        }
      }
      const std::vector<double> distances = SurfaceDistances(surface, points);
      const auto best = std::max_element(distances.begin(), distances.end());
      largest = *best;
      center = points[static_cast<std::size_t>(best - distances.begin())];
    }
    return largest;
  };
  constexpr int steps = 12;
  double least = HUGE_VAL;
  for (int i = -steps; i <= steps; ++i)
  {
    least = std::min(least, widest(along * i / steps));
  }
  return least;
}

SurfaceCase TorusCase(double small, int around, int across)
{
  SurfaceCase c;
  c.Name = "torus " + std::to_string(small) + ", " + std::to_string(around) + " x " +
    std::to_string(across);
  c.Make = [=] { return Torus(1.0, small, around, across); };
  c.Know = [=](const TriangleMesh& torus)
  {
    const double period = 4.0 * M_PI / around; // of two cross-sections
    KnownValues known;
    known.Smooth = { small, 1.0 - small };
    known.Polyhedron = { ValueAt(torus, { 1, 0, 0 }, { 0, 1, 0 }, 0.5 * period, 0.3 * small),
      ValueAt(torus, { 0, 0, 0 }, { 0, 0, 1 }, 0.1 * small, 0.1) };
    // Each point of either surface is at most this far from the other one.
    const TriangleMesh fine = Torus(1.0, small, 12 * around, 12 * across);
    known.Hausdorff = HausdorffDistance(torus, fine) +
      small * (1.0 - std::cos(M_PI / (12 * across))) +
      (1.0 + small) * (1.0 - std::cos(M_PI / (12 * around)));
    return known;
  };
  return c;
}

SurfaceCase NecklaceCase(int beads, double neck, double h)
{
  SurfaceCase c;
  c.Name = "necklace of " + std::to_string(beads) + ", neck " + std::to_string(neck) +
    ", cells of " + std::to_string(h);
  c.Make = [=] { return Necklace(beads, neck).Surface(h); };
  c.Know = [=](const TriangleMesh& surface)
  {
    const BeadShape shape = Necklace(beads, neck);
    KnownValues known;
    known.Polyhedron = { HUGE_VAL, ValueAt(surface, { 0, 0, 0.0213 }, { 0, 0, 1 }, 0.3, 0.2) };
    for (std::size_t i = 0; i < shape.Struts.size(); ++i)
    {
      const Point3 axis = shape.Centers[shape.Struts[i][1]] - shape.Centers[shape.Struts[i][0]];
      known.Polyhedron[0] = std::min(known.Polyhedron[0],
        ValueAt(surface, shape.Necks()[i].Place, (1.0 / Length(axis)) * axis, 2.0 * h, 0.3 * neck));
    }
    // The tunnel's ball touches the beads or, by symmetry in the plane of the ring, the struts.
    const double length = 0.5 * Length(shape.Centers[1] - shape.Centers[0]);
    const double middle = length / std::tan(M_PI / beads); // of a strut, from the center
    double hole = Length(shape.Centers[0] - Point3{ 0, 0, 0.0213 }) - shape.Bead;
    for (int i = 0; i <= 1000; ++i)
    {
      const double waist = 1e-3 * i;
      const double radius = neck + std::min(0.4, 0.95 * shape.Bead - neck) * waist * waist;
      hole = std::min(hole, std::hypot(middle - radius, length * waist));
    }
    known.Smooth = { neck, hole };
    // A finer surface is a few times nearer to the smooth one; the ratio of its cells bounds how
    // far it may be itself.
    known.Hausdorff = HausdorffDistance(surface, shape.Surface(h / 2.0)) * 2.0;
    return known;
  };
  return c;
}

std::vector<SurfaceCase> Cases()
{
  std::vector<SurfaceCase> cases;
  for (const double small : { 0.15, 0.3, 0.45, 0.6 })
  {
    cases.push_back(TorusCase(small, 48, 24));
    cases.push_back(TorusCase(small, 80, 36));
  }
  for (const int beads : { 3, 4, 5, 6 })
  {
    cases.push_back(NecklaceCase(beads, 0.3, 0.12));
    cases.push_back(NecklaceCase(beads, 0.5, 0.15));
  }
  for (const char* name : { "torus.obj", "double-torus.obj", "two-tori.obj", "knot1.off",
         "quadknot.obj", "3holes.off", "fertility.off", "eight.off", "genus3.off",
         "rocker_arm_1600.off", "Kitten.off", "bunny.off", "helix.off", "spot.obj" })
  {
    cases.push_back({ name, [name] { return ReadSurface(name); }, nullptr });
  }
  return cases;
}

struct Found
{
  double Radius, Uncertainty, Persistence;
  bool Trusted;
};

/// Features of each kind by a filtration, ascending by radius.
std::array<std::vector<Found>, 3> FeaturesBy(int filtration, vtkPolyData* surface)
{
  TopologyFilterRun<vtkChokingLoops> run(surface,
    [filtration](vtkChokingLoops* filter)
    {
      filter->SetFiltration(filtration);
      filter->SetMinimumPersistenceUnit(vtkChokingLoops::Absolute);
      filter->SetMinimumPersistence(0.0);
    });
  EXPECT_EQ(run.Messages().find("ERROR"), std::string::npos) << run.Messages();
  vtkCellData* loops = run.Surface(0)->GetCellData();
  std::array<std::vector<Found>, 3> found;
  double last = -1.0; // feature: each counts once
  for (vtkIdType i = 0; i < run.Surface(0)->GetNumberOfCells(); ++i)
  {
    const auto of = [&](const char* name) { return loops->GetArray(name)->GetTuple1(i); };
    if (of("FeatureId") != last)
    {
      last = of("FeatureId");
      found[static_cast<std::size_t>(of("Kind"))].push_back(
        { of("Radius"), of("Uncertainty"), of("Persistence"), of("Trusted") == 1.0 });
    }
  }
  for (std::vector<Found>& kind : found)
  {
    std::sort(
      kind.begin(), kind.end(), [](const Found& a, const Found& b) { return a.Radius < b.Radius; });
  }
  return found;
}

void ExpectAgreement(const SurfaceCase& c)
{
  const TriangleMesh mesh = c.Make();
  vtkNew<vtkPolyData> surface;
  SetMesh(mesh, surface);
  const auto delaunay = FeaturesBy(vtkChokingLoops::Delaunay, surface);
  const auto onMesh = FeaturesBy(vtkChokingLoops::TetrahedralMesh, surface);
  const double rounding = 1e-6 * ComputeBounds(mesh).Diagonal();
  for (std::size_t kind = 0; kind < 2; ++kind)
  {
    ASSERT_EQ(onMesh[kind].size(), delaunay[kind].size()) << c.Name << ", kind " << kind;
    for (std::size_t i = 0; i < delaunay[kind].size(); ++i)
    {
      const Found& a = delaunay[kind][i];
      const Found& b = onMesh[kind][i];
      EXPECT_NEAR(a.Radius, b.Radius, a.Uncertainty + b.Uncertainty + rounding)
        << c.Name << ", kind " << kind << ", number " << i;
      EXPECT_TRUE(!b.Trusted || b.Uncertainty < b.Radius) << c.Name;
    }
  }
  // Other trusted features of the mesh filtration exist.
  for (const Found& b : onMesh[2])
  {
    const bool isThere = std::any_of(delaunay[2].begin(), delaunay[2].end(),
      [&](const Found& a)
      { return std::abs(a.Radius - b.Radius) <= a.Uncertainty + b.Uncertainty + rounding; });
    EXPECT_TRUE(isThere || !b.Trusted) << c.Name << ", radius " << b.Radius;
  }
  if (!c.Know)
  {
    return;
  }
  const KnownValues known = c.Know(mesh);
  for (std::size_t kind = 0; kind < 2; ++kind)
  {
    ASSERT_EQ(delaunay[kind].size(), 1U) << c.Name;
    const Found& a = delaunay[kind].front();
    const Found& b = onMesh[kind].front();
    const double value = known.Polyhedron[kind];
    std::printf("%s, %s: polyhedron %.4f, smooth %.4f +- %.4f, Delaunay %.4f - %.4f, mesh %.4f "
                "+- %.4f\n",
      c.Name.c_str(), kind == 0 ? "handle" : "tunnel", value, known.Smooth[kind], known.Hausdorff,
      a.Radius, a.Uncertainty, b.Radius, b.Uncertainty);
    const double sampled = 0.01 * value; // ValueAt()'s own error
    EXPECT_LE(value, a.Radius + sampled) << c.Name;
    EXPECT_GE(value, a.Radius - a.Uncertainty - sampled) << c.Name;
    EXPECT_NEAR(value, b.Radius, b.Uncertainty + sampled) << c.Name;
    EXPECT_NEAR(known.Smooth[kind], a.Radius, a.Uncertainty + known.Hausdorff + rounding) << c.Name;
    EXPECT_NEAR(known.Smooth[kind], b.Radius, b.Uncertainty + known.Hausdorff + rounding) << c.Name;
  }
}

}

TEST(ChokingLoops, FiltrationsAgree)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/fertility.off");
  const std::vector<SurfaceCase> cases = Cases();
  const LongCases turn("FiltrationsAgree", 10);
  std::size_t done = 0;
  for (std::size_t i = 0; i < cases.size(); ++i)
  {
    if (turn.Has(i))
    {
      ExpectAgreement(cases[i]);
      ++done;
    }
  }
  turn.ReportCases(done, cases.size());
}
