// Damaged surfaces: each gives loops and a report of the repairs, or an error message. About two
// dozen cases in ctest; ISTHMUS_FUZZ_CASES=2000 in the environment runs more.

#include "ChokingLoops/SurfacePreparation.h"
#include "ChokingSurfaces.h"
#include "Remeshing/SelfIntersections.h"
#include "Remeshing/ThinTriangles.h"
#include "Surfaces/SurfaceDefects.h"
#include "TopologyFilterRun.h"

#include <vtkCellData.h>
#include <vtkChokingLoops.h>
#include <vtkFieldData.h>

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <limits>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

using FilterRun = TopologyFilterRun<vtkChokingLoops>;
using Random = std::mt19937_64;

std::size_t Below(Random& random, std::size_t n)
{
  return std::uniform_int_distribution<std::size_t>(0, n - 1)(random);
}

Point3& GetPoint(TriangleMesh& mesh, std::int64_t id)
{
  return mesh.Points[static_cast<std::size_t>(id)];
}

vtkSmartPointer<vtkPolyData> ToPolyData(const TriangleMesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  SetMesh(mesh, data);
  return data;
}

void Append(TriangleMesh& mesh, const TriangleMesh& other, const Point3& shift)
{
  const auto first = static_cast<std::int64_t>(mesh.Points.size());
  for (const Point3& p : other.Points)
  {
    mesh.Points.push_back(p + shift);
  }
  for (const Triangle& t : other.Triangles)
  {
    mesh.Triangles.push_back({ t[0] + first, t[1] + first, t[2] + first });
  }
}

/// Splits the edge opposite to corner 0 of triangle `t` at `middle`, and its twin.
void SplitEdge(TriangleMesh& mesh, std::size_t t, const Point3& middle)
{
  const Triangle first = mesh.Triangles[t];
  const auto id = static_cast<std::int64_t>(mesh.Points.size());
  mesh.Points.push_back(middle);
  for (std::size_t i = 0, n = mesh.Triangles.size(); i < n; ++i)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      const Triangle c = mesh.Triangles[i];
      const std::int64_t a = c[(k + 1) % 3], b = c[(k + 2) % 3];
      if ((a == first[1] && b == first[2]) || (a == first[2] && b == first[1]))
      {
        mesh.Triangles[i] = { c[k], a, id };
        mesh.Triangles.push_back({ c[k], id, b });
        break;
      }
    }
  }
}

/// A needle: an edge split very close to its end. `area` is that of the two triangles there.
void AddNeedle(TriangleMesh& mesh, std::size_t t, double area)
{
  const Point3 a = GetPoint(mesh, mesh.Triangles[t][1]);
  const Point3 b = GetPoint(mesh, mesh.Triangles[t][2]);
  SplitEdge(mesh, t, a + area * (b - a));
}

void ExpectCorrected(const TriangleMesh& damaged, double handles, double tunnels)
{
  RepairReport correction;
  const TriangleMesh mended = CheckedSurface(damaged, false, {}, &correction);
  EXPECT_TRUE(FindDefects(mended).None());
  EXPECT_TRUE(ThinTriangles(mended).empty());
  EXPECT_TRUE(SelfIntersections(mended).empty());
  EXPECT_GT(correction.Changed, 0);
  EXPECT_EQ(correction.Message.find("genus"), std::string::npos) << correction.Message;
  EXPECT_EQ(correction.Places.size(), static_cast<std::size_t>(correction.Changed));
  FilterRun run(ToPolyData(damaged));
  EXPECT_NE(run.Messages().find("It was repaired: "), std::string::npos) << run.Messages();
  auto* facts = run.Surface(0)->GetFieldData();
  ASSERT_TRUE(facts->GetArray("Repaired")) << run.Messages();
  EXPECT_EQ(facts->GetArray("Repaired")->GetTuple1(0), static_cast<double>(correction.Changed));
  EXPECT_EQ(facts->GetArray("RepairedPlaces")->GetNumberOfTuples(), correction.Changed);
  EXPECT_EQ(facts->GetArray("NumberOfHandles")->GetTuple1(0), handles);
  EXPECT_EQ(facts->GetArray("NumberOfTunnels")->GetTuple1(0), tunnels);
}

// A torus whose inner side just crosses itself at the axis: as triangles of genus 1, as a solid of
// genus 0; the repair gives genus 0.
TEST(RepairReport, ReportsAChangedGenus)
{
  FilterRun run(ToPolyData(Torus(0.297, 0.3, 60, 40)));
  EXPECT_NE(run.Messages().find("the genus from 1 to 0."), std::string::npos) << run.Messages();
  EXPECT_EQ(run.Surface(0)->GetFieldData()->GetArray("NumberOfHandles")->GetTuple1(0), 0.0);
}

TEST(RepairReport, NothingToDo)
{
  RepairReport correction;
  const TriangleMesh torus = Torus(1.0, 0.3, 30, 20);
  const TriangleMesh checked = CheckedSurface(torus, false, {}, &correction);
  EXPECT_EQ(checked.Triangles, torus.Triangles);
  EXPECT_EQ(correction.Changed, 0);
  EXPECT_TRUE(correction.Message.empty());
  FilterRun run(ToPolyData(torus));
  EXPECT_FALSE(run.Surface(0)->GetFieldData()->GetArray("Repaired"));
}

TEST(RepairReport, Needles)
{
  for (const double area : { 1e-8, 1e-10, 1e-12, 1e-14, 1e-15 })
  {
    SCOPED_TRACE(area);
    TriangleMesh mesh = Torus(1.0, 0.3, 30, 20);
    AddNeedle(mesh, 17, area);
    AddNeedle(mesh, 630, area);
    ExpectCorrected(mesh, 1.0, 1.0);
  }
}

TEST(RepairReport, CapsAndPointsOnEdges)
{
  TriangleMesh mesh = Torus(1.0, 0.3, 30, 20);
  const Triangle t = mesh.Triangles[100];
  // The corner opposite to an edge moved onto it: two flat triangles, or almost flat ones.
  GetPoint(mesh, t[0]) = 0.5 * (GetPoint(mesh, t[1]) + GetPoint(mesh, t[2]));
  ExpectCorrected(mesh, 1.0, 1.0);
}

TEST(RepairReport, SheetsThatTouchInAPoint)
{
  TriangleMesh pair = Torus(1.0, 0.3, 30, 20);
  const TriangleMesh other = pair;
  // Outermost points in one place.
  Append(pair, other, { 2.6, 0.0, 0.0 });
  const auto near = [&pair](std::size_t begin, std::size_t end, const Point3& p)
  {
    std::size_t best = begin;
    for (std::size_t i = begin; i < end; ++i)
    {
      const Point3 d = pair.Points[i] - p;
      const Point3 e = pair.Points[best] - p;
      best = Dot(d, d) < Dot(e, e) ? i : best;
    }
    return best;
  };
  const std::size_t half = other.Points.size();
  const Point3 touch{ 1.3, 0.0, 0.0 };
  const std::size_t mine = near(0, half, touch);
  pair.Points[near(half, 2 * half, touch)] = pair.Points[mine];
  ExpectCorrected(pair, 2.0, 2.0);
}

TEST(RepairReport, TooMuchToRepairIsRefused)
{
  TriangleMesh crossed = Torus(1.0, 0.3, 30, 20);
  Append(crossed, Torus(1.0, 0.3, 30, 20), { 0.5, 0.1, 0.2 });
  FilterRun run(ToPolyData(crossed));
  EXPECT_NE(run.Messages().find("crosses itself in"), std::string::npos) << run.Messages();
  EXPECT_NE(run.Messages().find("allow self-intersections"), std::string::npos) << run.Messages();
  EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 0);
}

TEST(RepairReport, MemoryLimitIsReported)
{
  FilterRun run(
    ToPolyData(Torus(1.0, 0.3, 30, 20)), [](vtkChokingLoops* f) { f->SetMemoryLimit(5); });
  EXPECT_NE(run.Messages().find("MemoryLimit is"), std::string::npos) << run.Messages();
  EXPECT_NE(
    run.Messages().find("raise SampleSpacing or simplify the surface, or raise MemoryLimit"),
    std::string::npos);
  EXPECT_EQ(run.Surface(0)->GetNumberOfCells(), 0);
}

/// A kind of damage that surfaces acquire in other programs.
void Damage(TriangleMesh& mesh, Random& random)
{
  const std::size_t t = Below(random, mesh.Triangles.size());
  const Triangle c = mesh.Triangles[t];
  const double edge = std::sqrt(
    Dot(GetPoint(mesh, c[0]) - GetPoint(mesh, c[1]), GetPoint(mesh, c[0]) - GetPoint(mesh, c[1])));
  const Point3 shift{ 0.1 * edge, -0.07 * edge, 0.05 * edge };
  switch (Below(random, 7))
  {
    case 0:
      AddNeedle(mesh, t, std::pow(10.0, -10.0 - static_cast<double>(Below(random, 11))));
      break;
    case 1:
      GetPoint(mesh, c[0]) = 0.3 * GetPoint(mesh, c[1]) + 0.7 * GetPoint(mesh, c[2]);
      break;
    case 2:
      mesh.Triangles.push_back(c);
      break;
    case 3: // sheets that touch
      GetPoint(mesh, c[0]) = mesh.Points[Below(random, mesh.Points.size())];
      break;
    case 4: // through the neighbour, by a tenth of an edge
      GetPoint(mesh, c[0]) = 1.1 * GetPoint(mesh, c[1]) + -0.1 * GetPoint(mesh, c[0]) + shift;
      break;
    case 5:
      GetPoint(mesh, c[0])[Below(random, 3)] = std::numeric_limits<double>::quiet_NaN();
      break;
    default:
      GetPoint(mesh, c[0])[Below(random, 3)] = Below(random, 2) ? 1e150 : 1e-150;
  }
}

int Cases()
{
  const char* asked = std::getenv("ISTHMUS_FUZZ_CASES");
  return asked ? std::atoi(asked) : 24;
}

TEST(RepairReport, DamagedSurfaces)
{
  const std::vector<std::string> names{ "Kitten.off", "double-torus.obj", "fandisk.off",
    "knot1.off", "rocker_arm_1600.off", "eight.off" };
  int loops = 0, sentences = 0;
  double longest = 0.0;
  for (int i = 0; i < Cases(); ++i)
  {
    const std::string& name = names[static_cast<std::size_t>(i) % names.size()];
    ISTHMUS_NEEDS_SHARED_DATA("surfaces/" + name);
    SCOPED_TRACE(name + ", case " + std::to_string(i));
    Random random(static_cast<std::uint64_t>(i));
    TriangleMesh mesh = ReadSurface(name);
    for (std::size_t n = 1 + Below(random, 3); n > 0; --n)
    {
      Damage(mesh, random);
    }
    const auto started = std::chrono::steady_clock::now();
    FilterRun run(ToPolyData(mesh), [](vtkChokingLoops* f) { f->SetMemoryLimit(4096); });
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - started;
    longest = std::max(longest, took.count());
    vtkFieldData* facts = run.Surface(0)->GetFieldData();
    const bool ended = facts->GetArray("NumberOfSamples") != nullptr;
    EXPECT_TRUE(ended || run.Messages().size() > 20) << run.Messages();
    ++(ended ? loops : sentences);
    if (vtkDataArray* lengths = run.Surface(0)->GetCellData()->GetArray("Length"))
    {
      for (vtkIdType k = 0; k < lengths->GetNumberOfTuples(); ++k)
      {
        EXPECT_TRUE(std::isfinite(lengths->GetTuple1(k)));
      }
    }
  }
  std::printf("%d with loops, %d with a sentence; longest %.1f s\n", loops, sentences, longest);
}

}
