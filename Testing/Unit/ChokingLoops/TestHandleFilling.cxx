#include "ChokingLoops/HandleFilling.h"

#include "BeadShapes.h"
#include "Remeshing/SelfIntersections.h"
#include "Remeshing/SurfaceBoolean.h"
#include "ScatteredMemory.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"
#include "vtkHandleFilling.h"

#include <vtkCellData.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <set>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

std::int64_t ComputeGenus(const TriangleMesh& mesh)
{
  const std::vector<int> parts = Components(mesh);
  return 1 + *std::max_element(parts.begin(), parts.end()) - EulerCharacteristic(mesh) / 2;
}

/// Radii of handles, then of tunnels, each ascending.
std::array<std::vector<double>, 2> CollectRadii(const TriangleMesh& mesh)
{
  const ChokingLoops loops(mesh);
  std::array<std::vector<double>, 2> radii;
  for (const ShapeFeature& f : loops.Diagram().Features)
  {
    if (IsGenerator(f))
    {
      radii[static_cast<std::size_t>(f.Kind)].push_back(f.Radius());
    }
  }
  std::sort(radii[0].begin(), radii[0].end());
  std::sort(radii[1].begin(), radii[1].end());
  return radii;
}

FilledSurface FillBelow(const TriangleMesh& mesh, double below)
{
  HandleFillingParameters parameters;
  parameters.FillHandlesBelow = below;
  return FillHandles(mesh, parameters);
}

/// Closed, manifold, oriented, not crossing itself, and the genus lower by the number of fillings.
void ExpectSound(const TriangleMesh& before, const FilledSurface& after)
{
  EXPECT_TRUE(FindDefects(after.Mesh).None());
  EXPECT_TRUE(SelfIntersections(after.Mesh).empty());
  EXPECT_EQ(after.Filling.size(), after.Mesh.Triangles.size());
  EXPECT_EQ(
    ComputeGenus(after.Mesh), ComputeGenus(before) - static_cast<std::int64_t>(after.Fills.size()));
  EXPECT_EQ(ComputeGenus(after.Mesh), after.Genus);
  EXPECT_EQ(after.Left, 0U);
}

/// The volume changes by what the membranes predict, within `share` of it.
void ExpectVolume(const TriangleMesh& before, const FilledSurface& after, double share)
{
  double predicted = 0.0;
  double size = 0.0;
  for (const HandleFill& f : after.Fills)
  {
    predicted += (f.Kind == FeatureKind::Tunnel ? 1.0 : -1.0) * f.Area * f.Thickness;
    size += f.Area * f.Thickness;
  }
  EXPECT_NEAR(SignedVolume(after.Mesh) - std::abs(SignedVolume(before)), predicted, share * size);
}

/// All points of the given surface except those at a filling are kept bitwise.
void ExpectRestUntouched(const TriangleMesh& before, const FilledSurface& after, double share)
{
  const std::set<Point3> now(after.Mesh.Points.begin(), after.Mesh.Points.end());
  const auto lost = std::count_if(before.Points.begin(), before.Points.end(),
    [&now](const Point3& p) { return now.count(p) == 0; });
  EXPECT_LE(static_cast<double>(lost), share * static_cast<double>(before.Points.size()));
}

/// A plate 0.8 thick with three round holes along it, rounded everywhere.
TriangleMesh DrilledPlate(const std::array<double, 3>& radii)
{
  const auto f = [&radii](double x, double y, double z)
  {
    double value = std::max({ std::abs(x) - 3.0, std::abs(y) - 1.1, std::abs(z) - 0.4 });
    for (std::size_t k = 0; k < 3; ++k)
    {
      const double center = 2.0 * (static_cast<double>(k) - 1.0) + 0.013;
      value = std::max(value, radii[k] - std::hypot(x - center, y - 0.007));
    }
    return value;
  };
  return LevelSet(f, { -3.3, -1.4, -0.7 }, { 3.3, 1.4, 0.7 }, { 99, 42, 21 });
}

TriangleMesh Torus(double large, double small)
{
  return LevelSet([=](double x, double y, double z)
    { return std::hypot(std::hypot(x, y) - large, z) - small; },
    { -2.31, -2.32, -1.03 }, { 2.32, 2.31, 1.02 }, { 46, 46, 20 });
}

/// A torus of radii 2 and 0.7 as a grid of quadrilaterals, halved.
TriangleMesh GridTorus(std::int64_t around, std::int64_t along)
{
  TriangleMesh mesh;
  const auto id = [=](std::int64_t i, std::int64_t k) { return (i % around) * along + k % along; };
  for (std::int64_t i = 0; i < around; ++i)
  {
    for (std::int64_t k = 0; k < along; ++k)
    {
      const double u = 2.0 * Pi * static_cast<double>(i) / static_cast<double>(around);
      const double v = 2.0 * Pi * static_cast<double>(k) / static_cast<double>(along);
      const double r = 2.0 + 0.7 * std::cos(v);
      mesh.Points.push_back({ r * std::cos(u), r * std::sin(u), 0.7 * std::sin(v) });
      mesh.Triangles.push_back({ id(i, k), id(i + 1, k), id(i + 1, k + 1) });
      mesh.Triangles.push_back({ id(i, k), id(i + 1, k + 1), id(i, k + 1) });
    }
  }
  return mesh;
}

}

TEST(HandleFilling, FillsTheTunnelsBelowASizeAndLeavesTheOthers)
{
  const TriangleMesh plate = DrilledPlate({ 0.16, 0.36, 0.24 });
  const FilledSurface filled = FillBelow(plate, 0.3);
  ASSERT_EQ(filled.Fills.size(), 2U);
  ExpectSound(plate, filled);
  ExpectVolume(plate, filled, 0.05);
  ExpectRestUntouched(plate, filled, 0.02);
  const std::array<double, 2> drilled{ 0.16, 0.24 };
  for (std::size_t k = 0; k < 2; ++k)
  {
    const HandleFill& fill = filled.Fills[k];
    EXPECT_EQ(fill.Kind, FeatureKind::Tunnel);
    EXPECT_NEAR(fill.Radius, drilled[k], 0.05 * drilled[k]);
    EXPECT_NEAR(fill.Area, M_PI * drilled[k] * drilled[k], 0.08 * fill.Area);
    EXPECT_DOUBLE_EQ(fill.Thickness, 0.25 * fill.Radius);
  }
  const auto radii = CollectRadii(filled.Mesh);
  ASSERT_EQ(radii[1].size(), 1U);
  EXPECT_NEAR(radii[1][0], CollectRadii(plate)[1][2], 1e-3);
}

TEST(HandleFilling, CutsTheHandlesBelowASizeAndLeavesTheOthers)
{
  BeadShape shape = Lattice(2, 0.0);
  for (std::size_t s = 0; s < shape.Radii.size(); ++s)
  {
    shape.Radii[s] = 0.20 + 0.02 * static_cast<double>((5 * s) % 12);
  }
  const TriangleMesh lattice = shape.Surface(0.1);
  const auto before = CollectRadii(lattice);
  ASSERT_EQ(before[0].size(), 5U);
  const double below = 0.5 * (before[0][2] + before[0][3]);
  const FilledSurface filled = FillBelow(lattice, below);
  ASSERT_EQ(filled.Fills.size(), 3U);
  ExpectSound(lattice, filled);
  ExpectVolume(lattice, filled, 0.1);
  const auto after = CollectRadii(filled.Mesh);
  ASSERT_EQ(after[0].size(), 2U);
  ASSERT_EQ(after[1].size(), 2U);
  EXPECT_NEAR(after[0][0], before[0][3], 0.01 * before[0][3]);
  EXPECT_NEAR(after[0][1], before[0][4], 0.01 * before[0][4]);
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_EQ(filled.Fills[k].Kind, FeatureKind::Handle);
    EXPECT_NEAR(filled.Fills[k].Radius, before[0][k], 1e-12);
    EXPECT_NEAR(
      filled.Fills[k].Area, M_PI * before[0][k] * before[0][k], 0.06 * filled.Fills[k].Area);
  }
}

TEST(HandleFilling, OneCutEndsAHandleAndTheTunnelThroughIt)
{
  for (const double large : { 1.1, 1.6 }) // the hole, or the ring, is the narrower one
  {
    const TriangleMesh torus = Torus(large, 0.6);
    const FilledSurface filled = FillBelow(torus, 1.2);
    ASSERT_EQ(filled.Fills.size(), 1U);
    EXPECT_EQ(filled.Fills[0].Kind, large < 1.25 ? FeatureKind::Tunnel : FeatureKind::Handle);
    ExpectSound(torus, filled);
    ExpectVolume(torus, filled, 0.1);
    EXPECT_EQ(FillBelow(torus, 0.45).Fills.size(), 0U);
  }
}

namespace
{

vtkSmartPointer<vtkPolyData> ToPolyData(const TriangleMesh& mesh)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  SetMesh(mesh, data);
  return data;
}

/// The filter's message for `surface`; empty if there is none.
std::string RecordError(vtkPolyData* surface, double below, double thickness = 0.25)
{
  vtkNew<vtkHandleFilling> filter;
  vtkNew<vtkTest::ErrorObserver> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->SetInputData(surface);
  filter->SetFillHandlesBelow(below);
  filter->SetThickness(thickness);
  filter->Update();
  EXPECT_TRUE(filter->GetOutput()->GetNumberOfPoints() == 0 || !errors->GetError());
  return errors->GetError() ? errors->GetErrorMessage() : "";
}

}

TEST(HandleFilling, TakesTheRequestedSide)
{
  HandleFillingParameters parameters;
  parameters.FillHandlesBelow = 1.2;
  parameters.Side = SideSelection::Outside; // though the ring is narrower than its hole
  const TriangleMesh torus = Torus(1.6, 0.6);
  const FilledSurface filled = FillHandles(torus, parameters);
  ASSERT_EQ(filled.Fills.size(), 1U);
  EXPECT_EQ(filled.Fills[0].Kind, FeatureKind::Tunnel);
  EXPECT_NEAR(filled.Fills[0].Area, M_PI, 0.05);
  ExpectSound(torus, filled);
}

TEST(HandleFilling, FilterReportsWhatItFilled)
{
  const TriangleMesh torus = Torus(1.1, 0.6);
  const auto input = ToPolyData(torus);
  vtkNew<vtkIntArray> year;
  year->SetName("Year");
  year->InsertNextValue(2026);
  input->GetFieldData()->AddArray(year);
  vtkNew<vtkHandleFilling> filter;
  filter->SetInputData(input);
  filter->SetFillHandlesBelow(0.55);
  filter->SetThickness(0.5);
  filter->Update();
  auto* surface = filter->GetOutput();
  auto* table = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(table->GetNumberOfRows(), 1);
  EXPECT_EQ(table->GetValueByName(0, "KindName").ToString(), "tunnel");
  EXPECT_NEAR(table->GetValueByName(0, "Radius").ToDouble(), 0.5, 0.01);
  EXPECT_NEAR(table->GetValueByName(0, "Area").ToDouble(), 0.25 * M_PI, 0.02);
  EXPECT_NEAR(table->GetValueByName(0, "Volume").ToDouble(), 0.25 * M_PI * 0.25, 0.01);
  auto* genus = surface->GetFieldData()->GetArray("Genus");
  EXPECT_EQ(genus->GetTuple1(0), 1.0);
  EXPECT_EQ(genus->GetTuple1(1), 0.0);
  EXPECT_EQ(surface->GetFieldData()->GetArray("LeftOpen")->GetTuple1(0), 0.0);
  EXPECT_NE(surface->GetFieldData()->GetArray("Year"), nullptr);
  // The marked part is the plate: two discs and a little of the wall, flat to above and below.
  const TriangleMesh mesh = ToTriangleMesh(surface);
  auto* filling = surface->GetCellData()->GetArray("Filling");
  double area = 0.0;
  for (vtkIdType i = 0; i < surface->GetNumberOfCells(); ++i)
  {
    const Triangle& t = mesh.Triangles[static_cast<std::size_t>(i)];
    const auto at = [&](std::size_t k) { return mesh.Points[static_cast<std::size_t>(t[k])]; };
    area += filling->GetTuple1(i) == 1.0 ? TriangleArea(at(0), at(1), at(2)) : 0.0;
  }
  EXPECT_NEAR(area, 2.0 * M_PI * 0.25, 0.1);
}

TEST(HandleFilling, LeavesASurfaceWithoutSmallHandlesUnchanged)
{
  const TriangleMesh torus = Torus(1.6, 0.6);
  const FilledSurface filled = FillBelow(torus, 0.3);
  EXPECT_EQ(filled.Mesh.Points, torus.Points);
  EXPECT_EQ(filled.Mesh.Triangles.size(), torus.Triangles.size());
  EXPECT_NEAR(SignedVolume(filled.Mesh), std::abs(SignedVolume(torus)), 1e-9);
  EXPECT_EQ(filled.Genus, 1);
}

TEST(HandleFilling, DoesNotDependOnOrientation)
{
  const TriangleMesh torus = Torus(1.1, 0.6);
  TriangleMesh turned = torus;
  for (Triangle& t : turned.Triangles)
  {
    std::swap(t[0], t[1]);
  }
  const FilledSurface one = FillBelow(torus, 0.55);
  const FilledSurface other = FillBelow(turned, 0.55);
  ASSERT_EQ(other.Fills.size(), 1U);
  ExpectSound(turned, other);
  EXPECT_NEAR(SignedVolume(one.Mesh), SignedVolume(other.Mesh), 1e-3);
}

// A round hole is filled by triangles of which many are equally good; CGAL's choice among them
// depended on memory addresses.
TEST(HandleFilling, DoesNotDependOnAddresses)
{
  for (const int count : { 36, 53, 100 })
  {
    std::vector<Point3> rim;
    for (int i = 0; i < count; ++i)
    {
      const double angle = 2.0 * Pi * i / count;
      rim.push_back({ std::cos(angle), 0.6 * std::sin(angle), 0.8 * std::sin(angle) });
    }
    const std::vector<Triangle> first = PolygonFilling(rim);
    ASSERT_EQ(first.size() + 2, rim.size());
    for (std::uint64_t run = 0; run < 10; ++run)
    {
      const ScatteredMemory other(run);
      EXPECT_EQ(PolygonFilling(rim), first) << count << " points, run " << run;
    }
  }
  const auto expectSame = [](const TriangleMesh& torus, double below, std::uint64_t runs)
  {
    const FilledSurface first = FillBelow(torus, below);
    ASSERT_EQ(first.Fills.size(), 1U);
    for (std::uint64_t run = 0; run < runs; ++run)
    {
      const ScatteredMemory other(run);
      const FilledSurface again = FillBelow(torus, below);
      EXPECT_EQ(again.Mesh.Points, first.Mesh.Points) << run;
      EXPECT_EQ(again.Mesh.Triangles, first.Mesh.Triangles) << run;
      EXPECT_EQ(again.Filling, first.Filling) << run;
    }
  };
  expectSame(Torus(1.1, 0.6), 0.55, 3);
  expectSame(GridTorus(40, 20), 2.0, 4); // with needles where the plate meets it
}

TEST(HandleFilling, ReportsInvalidInput)
{
  const auto torus = ToPolyData(Torus(1.1, 0.6));
  EXPECT_NE(RecordError(torus, 0.0).find("above 0"), std::string::npos);
  EXPECT_NE(RecordError(torus, -1.0).find("above 0"), std::string::npos);
  EXPECT_NE(RecordError(torus, std::nan("")).find("above 0"), std::string::npos);
  EXPECT_NE(RecordError(torus, 0.5, 0.0).find("Thickness is 0"), std::string::npos);
  TriangleMesh open = Torus(1.1, 0.6);
  open.Triangles.pop_back();
  EXPECT_NE(RecordError(ToPolyData(open), 0.5).find("at a hole"), std::string::npos)
    << RecordError(ToPolyData(open), 0.5);
  const vtkNew<vtkPolyData> nothing;
  EXPECT_EQ(RecordError(nothing, 0.5), "");
}
