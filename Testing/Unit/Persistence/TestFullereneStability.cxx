// Molecules against GUDHI's alpha complex, polygons and solids known by hand, the grid against the
// exact values, the thesis' reference values, bad input.

#include "vtkFullereneStability.h"

#include "AlphaPeer.h"
#include "Persistence/AtomDistanceGrid.h"
#include "Persistence/FullereneStability.h"
#include "SharedData.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkMolecule.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <sstream>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Infinity = std::numeric_limits<double>::infinity();

std::vector<Point3> Polygon(int corners, double radius)
{
  std::vector<Point3> atoms;
  for (int i = 0; i < corners; ++i)
  {
    const double angle = 2.0 * Pi * i / corners + 0.3;
    // In a tilted plane, away from the origin.
    const double x = radius * std::cos(angle);
    const double y = radius * std::sin(angle);
    atoms.push_back({ x + 5.0, 0.6 * y - 3.0, 0.8 * y + 1.0 });
  }
  return atoms;
}

std::vector<Point3> ReadXYZ(const std::filesystem::path& path)
{
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  std::getline(file, line);
  std::vector<Point3> atoms;
  while (std::getline(file, line))
  {
    std::istringstream words(line);
    std::string element;
    Point3 p;
    if (words >> element >> p[0] >> p[1] >> p[2])
    {
      atoms.push_back(p);
    }
  }
  return atoms;
}

FullereneStability Exact(const std::vector<Point3>& atoms)
{
  return ComputeStability(atoms, AlphaBars(atoms), 0.2, Infinity);
}

FullereneStability OnGrid(const std::vector<Point3>& atoms, double spacing, bool marching = false)
{
  return ComputeStability(atoms, GridBars(atoms, {}, { spacing, 2.0, marching }), 0.2, 2.0);
}

/// All molecules of the shared folder.
[[maybe_unused]] std::vector<std::filesystem::path> Molecules() // unused without GUDHI
{
  std::vector<std::filesystem::path> paths;
  const auto folder = SharedDataFolder() / "fullerenes";
  for (const char* part : { "", "C36", "C40", "dft" })
  {
    for (const auto& entry : std::filesystem::directory_iterator(folder / part))
    {
      if (entry.path().extension() == ".xyz")
      {
        paths.push_back(entry.path());
      }
    }
  }
  std::sort(paths.begin(), paths.end());
  return paths;
}

vtkSmartPointer<vtkPolyData> Points(const std::vector<Point3>& atoms)
{
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  for (const Point3& atom : atoms)
  {
    points->InsertNextPoint(atom.data());
  }
  data->SetPoints(points);
  return data;
}

double At(vtkTable* table, const char* column, vtkIdType row)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column));
  EXPECT_NE(array, nullptr) << column;
  return array ? array->GetComponent(row, 0) : std::nan("");
}

}

TEST(FullereneStability, PolygonsByHand)
{
  // Born at half a side, filled at the circumradius; all in one plane.
  for (const int corners : { 4, 5, 6, 12 })
  {
    const double radius = 1.7;
    const auto bars = AlphaBars(Polygon(corners, radius));
    ASSERT_EQ(bars.size(), 1u) << corners;
    EXPECT_EQ(bars[0].Dimension, 1);
    EXPECT_NEAR(bars[0].Birth, radius * std::sin(Pi / corners), 1e-9);
    EXPECT_NEAR(bars[0].Death, radius, 1e-9);
  }
  // An acute triangle has a short bar.
  const auto bars = AlphaBars(Polygon(3, 2.0));
  ASSERT_EQ(bars.size(), 1u);
  EXPECT_NEAR(bars[0].Length(), 2.0 - 2.0 * std::sin(Pi / 3.0), 1e-9);
}

TEST(FullereneStability, CubeByHand)
{
  // Eight atoms at the corners of a cube of side 2: five independent rings from 1 to sqrt 2, and
  // the hollow from sqrt 2 to sqrt 3.
  std::vector<Point3> cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.push_back({ 2.0 * (i & 1), 1.0 * (i & 2), 0.5 * (i & 4) });
  }
  const FullereneStability row = Exact(cube);
  EXPECT_EQ(row.Atoms, 8);
  EXPECT_EQ(row.Bars, 5);
  EXPECT_NEAR(row.Integral, 5.0 * (std::sqrt(2.0) - 1.0), 1e-9);
  EXPECT_NEAR(row.Cavity, std::sqrt(3.0) - std::sqrt(2.0), 1e-9);
  EXPECT_NEAR(row.BoxLength, 2.0, 1e-12);
  EXPECT_NEAR(row.EnergyProxy, -row.FilteredIntegral / 8.0, 1e-15);
}

TEST(FullereneStability, BarsCountFromFilterDeltaOnOrIfTheyReachTheta)
{
  const std::vector<Point3> atoms{ { 0, 0, 0 }, { 4, 0, 0 }, { 0, 1, 0 } };
  const std::vector<DistanceBar> bars{ { 1, 1.0, 1.5 }, { 1, 1.0, 1.25 }, { 1, 1.9375, 2.0 },
    { 2, 1.0, 1.75 }, { 2, 1.0, 1.5 } };
  const FullereneStability row = ComputeStability(atoms, bars, 0.5, 2.0);
  EXPECT_EQ(row.Bars, 2);
  EXPECT_EQ(row.Integral, 0.8125);
  EXPECT_EQ(row.FilteredIntegral, 0.5625);
  EXPECT_EQ(row.Cavity, 0.75);
  EXPECT_EQ(row.BoxLength, 4.0);
  EXPECT_EQ(row.EnergyProxy, -0.1875);
  EXPECT_EQ(ComputeStability(atoms, bars, 0.5, Infinity).Bars, 1);
}

TEST(FullereneStability, FewAtomsLinesAndCopies)
{
  EXPECT_TRUE(AlphaBars({}).empty());
  EXPECT_TRUE(AlphaBars({ { 1, 2, 3 } }).empty());
  EXPECT_TRUE(AlphaBars({ { 1, 2, 3 }, { 1, 2, 4 } }).empty());
  EXPECT_TRUE(AlphaBars({ { 0, 0, 0 }, { 1, 1, 1 }, { 3, 3, 3 }, { 7, 7, 7 } }).empty());
  auto twice = Polygon(6, 1.4);
  const auto once = AlphaBars(twice);
  twice.insert(twice.end(), twice.begin(), twice.begin() + 3);
  const auto again = AlphaBars(twice);
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again[0].Death, once[0].Death);
}

TEST(FullereneStability, DoesNotDependOnCopiesOrUnit)
{
  std::vector<Point3> cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.push_back({ 2.0 * (i & 1) + 0.01 * i, 1.0 * (i & 2), 0.5 * (i & 4) });
  }
  auto twice = cube;
  twice.insert(twice.end(), cube.begin(), cube.end());
  for (const auto& atoms : { cube, Polygon(6, 1.4), twice })
  {
    const auto bars = AlphaBars(atoms);
    auto small = atoms;
    for (Point3& atom : small)
    {
      atom = 0x1p-10 * atom; // an angstrom in another unit
    }
    const auto smallBars = AlphaBars(small);
    ASSERT_EQ(smallBars.size(), bars.size());
    ASSERT_FALSE(bars.empty());
    for (std::size_t i = 0; i < bars.size(); ++i)
    {
      EXPECT_EQ(smallBars[i].Dimension, bars[i].Dimension);
      EXPECT_NEAR(smallBars[i].Birth, 0x1p-10 * bars[i].Birth, 1e-15);
      EXPECT_NEAR(smallBars[i].Death, 0x1p-10 * bars[i].Death, 1e-15);
    }
  }
  const auto once = AlphaBars(cube), again = AlphaBars(twice);
  ASSERT_EQ(again.size(), once.size());
  for (std::size_t i = 0; i < once.size(); ++i)
  {
    EXPECT_EQ(again[i].Birth, once[i].Birth);
    EXPECT_EQ(again[i].Death, once[i].Death);
  }
}

TEST(FullereneStability, EqualsGudhiOnAllMolecules)
{
  ISTHMUS_NEEDS_SHARED_DATA("fullerenes/C20-Ih.xyz");
#if !ISTHMUS_HAS_GUDHI_ALPHA
  GTEST_SKIP() << "GUDHI is not installed (libgudhi-dev)";
#else
  const auto paths = Molecules();
  ASSERT_GT(paths.size(), 80u);
  for (const auto& path : paths)
  {
    const auto atoms = ReadXYZ(path);
    ASSERT_GE(atoms.size(), 20u) << path;
    const FullereneStability ours = Exact(atoms);
    const FullereneStability theirs =
      ComputeStability(atoms, AlphaBarsOfGudhi(atoms), 0.2, Infinity);
    EXPECT_NEAR(ours.Integral, theirs.Integral, 1e-9) << path;
    EXPECT_NEAR(ours.FilteredIntegral, theirs.FilteredIntegral, 1e-9) << path;
    EXPECT_NEAR(ours.Cavity, theirs.Cavity, 1e-9) << path;
    EXPECT_EQ(ours.Bars, theirs.Bars) << path;
    EXPECT_EQ(ours.Bars, ours.Atoms / 2 + 1) << path;
  }
#endif
}

TEST(FullereneStability, ReferenceValuesAndConvergenceOfTheGrid)
{
  ISTHMUS_NEEDS_SHARED_DATA("fullerenes/C20-Ih.xyz");
  const auto folder = SharedDataFolder() / "fullerenes";
  const auto c20 = ReadXYZ(folder / "C20-Ih.xyz");
  const auto c60 = ReadXYZ(folder / "C60_Ih-ANGS.xyz");
  EXPECT_NEAR(Exact(c20).FilteredIntegral, 5.2402, 5e-5);
  EXPECT_NEAR(Exact(c60).FilteredIntegral, 19.410, 5e-4);
  EXPECT_LT(Exact(c60).EnergyProxy, Exact(c20).EnergyProxy);
  // The filtered grid value comes to the exact one from below, by at most a quarter of a spacing
  // for each bar; the unfiltered one grows past it.
  double unfiltered = 0.0;
  for (const double spacing : { 0.2, 0.1, 0.05 })
  {
    const FullereneStability grid = OnGrid(c20, spacing);
    EXPECT_EQ(grid.Bars, 11);
    EXPECT_LT(grid.FilteredIntegral, Exact(c20).FilteredIntegral);
    EXPECT_LT(Exact(c20).FilteredIntegral - grid.FilteredIntegral,
      (spacing > 0.1 ? 0.3 : 0.25) * spacing * 11.0);
    EXPECT_GT(grid.Integral, unfiltered);
    unfiltered = grid.Integral;
  }
  EXPECT_GT(unfiltered, Exact(c20).Integral);
}

TEST(FullereneStability, FastMarchingConverges)
{
  // One atom: the distance itself. From a point, first order up to a logarithm.
  double last = 1.0;
  for (const double spacing : { 0.1, 0.05, 0.025 })
  {
    const auto exact = AtomDistance({ { 0.03, 0.01, 0.02 } }, {}, { spacing, 1.0, false });
    const auto marched = AtomDistance({ { 0.03, 0.01, 0.02 } }, {}, { spacing, 1.0, true });
    ASSERT_EQ(exact.Values.size(), marched.Values.size());
    double worst = 0.0;
    for (std::size_t i = 0; i < exact.Values.size(); ++i)
    {
      worst = std::max(worst, static_cast<double>(std::abs(exact.Values[i] - marched.Values[i])));
    }
    EXPECT_LT(worst, 0.75 * last) << spacing;
    last = worst;
  }
  EXPECT_LT(last, 0.045);
  const auto ring = Polygon(6, 1.4);
  EXPECT_NEAR(OnGrid(ring, 0.1, true).FilteredIntegral, Exact(ring).FilteredIntegral, 0.1);
}

TEST(FullereneStability, ScalesGrowBallsByRadius)
{
  // Two atoms of radius 1 and 3, 8 apart: they meet where the distances over the radii agree, at 2.
  const auto grid = AtomDistance({ { 0, 0, 0 }, { 8, 0, 0 } }, { 1.0, 3.0 }, { 0.25, 2.5, false });
  const auto node = [&](double x)
  {
    const auto index = [&](double value, std::size_t axis)
    { return std::llround((value - grid.Origin[axis]) / grid.Spacing); };
    return grid.Values[static_cast<std::size_t>(
      index(x, 0) + grid.Dimensions[0] * (index(0.0, 1) + grid.Dimensions[1] * index(0.0, 2)))];
  };
  EXPECT_NEAR(node(1.0), 1.0, 1e-6);
  EXPECT_NEAR(node(5.0), 1.0, 1e-6);
  EXPECT_NEAR(node(2.0), 2.0, 1e-6);
}

TEST(FullereneStability, TableOfSeveralMolecules)
{
  vtkNew<vtkFullereneStability> filter;
  filter->AddInputDataObject(Points(Polygon(6, 1.4)));
  vtkNew<vtkMolecule> molecule;
  for (const Point3& atom : Polygon(5, 1.2))
  {
    molecule->AppendAtom(6, atom[0], atom[1], atom[2]);
  }
  filter->AddInputDataObject(molecule);
  filter->Update();
  vtkTable* table = filter->GetOutput();
  ASSERT_EQ(table->GetNumberOfRows(), 2);
  EXPECT_EQ(At(table, "Atoms", 0), 6.0);
  EXPECT_EQ(At(table, "Bars", 0), 1.0);
  EXPECT_NEAR(At(table, "FilteredIntegral", 0), 1.4 - 0.7, 1e-9);
  EXPECT_NEAR(At(table, "Integral", 0), 1.4 - 0.7, 1e-9);
  EXPECT_NEAR(At(table, "EnergyProxy", 0), -0.7 / 6.0, 1e-9);
  EXPECT_EQ(At(table, "Cavity", 0), 0.0);
  EXPECT_EQ(At(table, "Molecule", 1), 1.0);
  EXPECT_EQ(At(table, "Atoms", 1), 5.0);
  auto* bars = vtkTable::SafeDownCast(filter->GetOutputDataObject(1));
  ASSERT_EQ(bars->GetNumberOfRows(), 2);
  EXPECT_NEAR(At(bars, "Death", 1), 1.2, 1e-6);
  // Bars below the filter count only in the integral.
  filter->SetFilterDelta(0.6);
  filter->Update();
  EXPECT_EQ(At(table, "Bars", 1), 0.0);
  EXPECT_GT(At(table, "Integral", 1), 0.4);
}

TEST(FullereneStability, ReportsBadInput)
{
  vtkNew<vtkFullereneStability> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> pipeline;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  const auto said = [&]()
  {
    observer->Clear();
    filter->Modified();
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfRows() == 0, observer->GetError());
    return observer->GetErrorMessage();
  };
  filter->SetInputData(Points(Polygon(6, 1.4)));
  EXPECT_EQ(said(), "");
  filter->SetFilterDelta(std::nan(""));
  EXPECT_NE(said().find("FilterDelta is not a number"), std::string::npos);
  filter->SetFilterDelta(0.2);
  filter->ScaleByRadiusOn();
  EXPECT_NE(said().find("needs the method Grid"), std::string::npos);
  filter->SetMethod(vtkFullereneStability::Grid);
  EXPECT_NE(said().find("needs a point array Radius"), std::string::npos);
  filter->ScaleByRadiusOff();
  for (const double bad : { 0.0, -1.0, std::nan(""), Infinity })
  {
    filter->SetSpacing(bad);
    EXPECT_NE(said().find("Spacing is"), std::string::npos);
    filter->SetSpacing(0.2);
    filter->SetTheta(bad);
    EXPECT_NE(said().find("Theta is"), std::string::npos);
    filter->SetTheta(2.0);
  }
  filter->SetSpacing(1e-7);
  EXPECT_NE(said().find("more than 2^31 nodes"), std::string::npos);
  filter->SetMethod(vtkFullereneStability::Exact);
  filter->SetInputData(Points({ { 0, 0, 0 }, { 1, std::nan(""), 0 }, { 0, 1, 0 }, { 0, 0, 1 } }));
  EXPECT_NE(said().find("Atom 1 has a coordinate"), std::string::npos);
  observer->Clear();
  filter->SetInputData(vtkNew<vtkPolyData>());
  filter->Update();
  EXPECT_FALSE(observer->GetError());
  EXPECT_EQ(filter->GetOutput()->GetNumberOfRows(), 0);
}
