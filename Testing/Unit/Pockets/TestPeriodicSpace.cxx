// Pockets and pores of crystals: lattices with known holes and windows; the same crystal in other
// cells, places and orders; a molecule alone in a large box; input without a usable cell.

#include "Core/Geometry.h"
#include "vtkMolecularPockets.h"
#include "vtkPoreProfile.h"

#include "Atoms/PeriodicCell.h"
#include "BallPoints.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PeriodicSpace.h"
#include "Pockets/PoreProfile.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

using namespace isthmus;
using isthmus::testing::MakeAtoms;

namespace
{

using Vectors = std::vector<Point3>;

struct Crystal
{
  Vectors Cell;
  std::vector<Ball> Atoms;
};

/// The radii of the largest ball, and of those that get through along a, b, c; NAN: blocked.
struct CrystalRadii
{
  double Included = NAN;
  std::array<double, 3> Free{ NAN, NAN, NAN };
};

CrystalRadii Measure(const Crystal& crystal)
{
  const PeriodicPores found = FindPeriodicPores(crystal.Atoms, PeriodicCell(crystal.Cell), {});
  CrystalRadii radii;
  radii.Included = found.LargestRadius;
  for (const Pore& pore : found.Pores)
  {
    double& least = radii.Free.at(static_cast<std::size_t>(pore.Direction[0] - 'a'));
    least = HUGE_VAL;
    for (const PoreSample& sample : pore.Samples)
    {
      least = std::min(least, sample.Radius);
    }
  }
  return radii;
}

void ExpectRadii(const CrystalRadii& a, const CrystalRadii& b, double tolerance)
{
  EXPECT_NEAR(a.Included, b.Included, tolerance);
  for (std::size_t k = 0; k < 3; ++k)
  {
    EXPECT_EQ(std::isnan(a.Free[k]), std::isnan(b.Free[k])) << k;
    if (!std::isnan(a.Free[k]))
    {
      EXPECT_NEAR(a.Free[k], b.Free[k], tolerance) << k;
    }
  }
}

/// A cubic cell with an edge of 6 and atoms of radius 1 at these fractions.
Crystal Cubic(const std::vector<Point3>& fractions)
{
  Crystal crystal{ { { 6.0, 0.0, 0.0 }, { 0.0, 6.0, 0.0 }, { 0.0, 0.0, 6.0 } }, {} };
  for (const Point3& f : fractions)
  {
    crystal.Atoms.push_back({ 6.0 * f, 1.0 });
  }
  return crystal;
}

/// A triclinic cell with `count` atoms at random places.
Crystal Random(int count, unsigned int seed)
{
  Crystal crystal{ { { 8.0, 0.0, 0.0 }, { 2.5, 9.0, 0.0 }, { -1.5, 1.0, 10.0 } }, {} };
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> fraction;
  for (int i = 0; i < count; ++i)
  {
    const double f = fraction(generator), g = fraction(generator), h = fraction(generator);
    crystal.Atoms.push_back(
      { f * crystal.Cell[0] + g * crystal.Cell[1] + h * crystal.Cell[2], 1.0 });
  }
  return crystal;
}

Crystal Repeat(const Crystal& crystal, const std::array<int, 3>& times)
{
  Crystal repeated;
  for (std::size_t k = 0; k < 3; ++k)
  {
    repeated.Cell.push_back(static_cast<double>(times[k]) * crystal.Cell[k]);
  }
  const PeriodicCell cell(crystal.Cell);
  CellShift s{};
  for (s[0] = 0; s[0] < times[0]; ++s[0])
  {
    for (s[1] = 0; s[1] < times[1]; ++s[1])
    {
      for (s[2] = 0; s[2] < times[2]; ++s[2])
      {
        for (const Ball& atom : crystal.Atoms)
        {
          repeated.Atoms.push_back({ atom.Center + cell.Vector(s), atom.Radius });
        }
      }
    }
  }
  return repeated;
}

Point3 TurnCrystal(const Point3& p)
{
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Point3 q{ c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
  return { q[0], c * q[1] - s * q[2], s * q[1] + c * q[2] };
}

PocketResult FindAll(const Crystal& crystal)
{
  PocketOptions options;
  options.MinimumVolume = 0.0;
  options.InnerRadius = 1.4; // more of them
  options.Cell = crystal.Cell;
  return FindPockets(crystal.Atoms, options);
}

/// Volume, area, largest radius and mouths of the pockets with more than a trace of volume.
std::vector<std::array<double, 5>> Rows(const PocketResult& result)
{
  std::vector<std::array<double, 5>> rows;
  for (const Pocket& pocket : result.Pockets)
  {
    if (pocket.Volume > 0.01)
    {
      double mouths = 0.0;
      for (const PocketMouth& mouth : pocket.Mouths)
      {
        mouths += mouth.Area;
      }
      rows.push_back({ pocket.Volume, pocket.Area, pocket.Radius,
        static_cast<double>(pocket.Mouths.size()), mouths });
    }
  }
  std::sort(rows.begin(), rows.end());
  return rows;
}

void ExpectRows(const std::vector<std::array<double, 5>>& a,
  const std::vector<std::array<double, 5>>& b, double tolerance)
{
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    for (std::size_t k = 0; k < 5; ++k)
    {
      EXPECT_NEAR(a[i][k], b[i][k], tolerance) << i << " " << k;
    }
  }
}

/// A cage of atoms with a window, and a groove outside.
std::vector<Ball> Cage()
{
  std::vector<Ball> atoms;
  const int count = 150;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - 2.0 * (i + 0.5) / count;
    const double angle = Pi * (3.0 - std::sqrt(5.0)) * i;
    const double r = std::sqrt(1.0 - z * z);
    const Point3 at{ r * std::cos(angle), r * std::sin(angle), z };
    if (z < 0.85)
    {
      atoms.push_back({ 6.5 * at, 1.7 });
    }
  }
  for (int i = 0; i < 8; ++i)
  {
    atoms.push_back({ { 10.0, -7.0 + 2.0 * i, 0.0 }, 1.7 });
    atoms.push_back({ { 10.5, -7.0 + 2.0 * i, 5.0 }, 1.7 });
  }
  return atoms;
}

/// Input of the filters.
vtkSmartPointer<vtkPolyData> MakeCrystal(const Crystal& crystal)
{
  auto atoms = MakeAtoms(crystal.Atoms);
  vtkNew<vtkDoubleArray> cell;
  cell->SetName("CellVectors");
  cell->SetNumberOfComponents(3);
  for (const Point3& vector : crystal.Cell)
  {
    cell->InsertNextTypedTuple(vector.data());
  }
  atoms->GetFieldData()->AddArray(cell);
  return atoms;
}

}

// Holes and windows of lattices: N. W. Ashcroft and N. D. Mermin, Solid State Physics, chapter 4.
TEST(PeriodicSpace, SimpleCubic)
{
  const double free = 6.0 / std::sqrt(2.0) - 1.0; // through a face
  ExpectRadii(Measure(Cubic({ { 0.0, 0.0, 0.0 } })),
    { 3.0 * std::sqrt(3.0) - 1.0, { free, free, free } }, 1e-9);
}

TEST(PeriodicSpace, BodyCentredCubic)
{
  const double free = 6.0 * 3.0 * std::sqrt(2.0) / 8.0 - 1.0; // through a triangle of neighbours
  ExpectRadii(Measure(Cubic({ { 0.0, 0.0, 0.0 }, { 0.5, 0.5, 0.5 } })),
    { 6.0 * std::sqrt(5.0) / 4.0 - 1.0, { free, free, free } }, 1e-9);
}

TEST(PeriodicSpace, FaceCentredCubic)
{
  const double free = 6.0 / std::sqrt(6.0) - 1.0;
  ExpectRadii(
    Measure(Cubic({ { 0.1, 0.2, 0.3 }, { 0.1, 0.7, 0.8 }, { 0.6, 0.2, 0.8 }, { 0.6, 0.7, 0.3 } })),
    { 3.0 - 1.0, { free, free, free } }, 1e-9);
}

// Layers of atoms that overlap: nothing passes them.
TEST(PeriodicSpace, LayersBlockOneDirection)
{
  Crystal layers{ { { 2.5, 0.0, 0.0 }, { 0.0, 2.5, 0.0 }, { 0.0, 0.0, 10.0 } },
    { { { 0.0, 0.0, 0.0 }, 1.8 } } };
  const CrystalRadii radii = Measure(layers);
  EXPECT_NEAR(radii.Included, std::sqrt(25.0 + 2.0 * 1.25 * 1.25) - 1.8, 1e-9);
  const double between = std::sqrt(25.0 + 1.25 * 1.25) - 1.8;
  ExpectRadii(radii, { radii.Included, { between, between, NAN } }, 1e-9);
}

TEST(PeriodicSpace, CopiesAndOrderChangeNothing)
{
  for (const unsigned int seed : { 1u, 2u, 3u })
  {
    const Crystal crystal = Random(9, seed);
    const CrystalRadii radii = Measure(crystal);
    Crystal moved = crystal;
    for (std::size_t i = 0; i < moved.Atoms.size(); ++i)
    {
      Point3& at = moved.Atoms[i].Center;
      at = at + static_cast<double>(i % 3) * crystal.Cell[0] - 2.0 * crystal.Cell[i % 2] +
        Point3{ 0.3, -4.0, 77.0 };
    }
    std::reverse(moved.Atoms.begin(), moved.Atoms.end());
    ExpectRadii(Measure(moved), radii, 1e-8);
    ExpectRows(Rows(FindAll(moved)), Rows(FindAll(crystal)), 1e-6);
  }
}

TEST(PeriodicSpace, DoubledCellIsTheSameCrystal)
{
  std::size_t pockets = 0;
  for (const unsigned int seed : { 1u, 2u, 3u })
  {
    const Crystal crystal = Random(9, seed);
    const Crystal twice = Repeat(crystal, { 2, 1, 1 });
    ExpectRadii(Measure(twice), Measure(crystal), 1e-8);
    ExpectRadii(Measure(Repeat(crystal, { 1, 2, 3 })), Measure(crystal), 1e-8);
    const PocketResult one = FindAll(crystal);
    const PocketResult two = FindAll(twice);
    EXPECT_NEAR(two.UnionVolume, 2.0 * one.UnionVolume, 1e-6);
    EXPECT_NEAR(two.UnionArea, 2.0 * one.UnionArea, 1e-6);
    EXPECT_NEAR(two.PocketVolume, 2.0 * one.PocketVolume, 1e-6);
    pockets += one.Pockets.size();
  }
  EXPECT_GT(pockets, 0u);
}

TEST(PeriodicSpace, RotationChangesNothing)
{
  for (const unsigned int seed : { 1u, 2u, 3u })
  {
    const Crystal crystal = Random(9, seed);
    Crystal turned = crystal;
    std::transform(turned.Cell.begin(), turned.Cell.end(), turned.Cell.begin(), TurnCrystal);
    for (Ball& atom : turned.Atoms)
    {
      atom.Center = TurnCrystal(atom.Center);
    }
    ExpectRadii(Measure(turned), Measure(crystal), 1e-8);
    ExpectRows(Rows(FindAll(turned)), Rows(FindAll(crystal)), 1e-6);
  }
}

// The same lattice by other vectors. A way along a + c needs one along a and one along c.
TEST(PeriodicSpace, DirectionsAreThoseOfTheVectors)
{
  for (const unsigned int seed : { 1u, 2u, 3u, 4u })
  {
    const Crystal crystal = Random(9, seed);
    const CrystalRadii radii = Measure(crystal);
    Crystal skewed = crystal;
    skewed.Cell[2] = crystal.Cell[0] + crystal.Cell[2];
    const CrystalRadii other = Measure(skewed);
    EXPECT_NEAR(other.Included, radii.Included, 1e-8);
    EXPECT_NEAR(other.Free[0], radii.Free[0], 1e-8);
    EXPECT_NEAR(other.Free[1], radii.Free[1], 1e-8);
    EXPECT_GE(other.Free[2], std::min(radii.Free[0], radii.Free[2]) - 1e-8);
  }
  // Between columns of atoms along c, a ball moves more easily along c than across.
  Crystal columns = Cubic({ { 0.0, 0.0, 0.0 } });
  columns.Cell[2] = { 0.0, 0.0, 1.5 };
  const double across = std::sqrt(9.0 + 0.75 * 0.75) - 1.0;
  ExpectRadii(Measure(columns),
    { std::sqrt(18.0 + 0.75 * 0.75) - 1.0, { across, across, std::sqrt(18.0) - 1.0 } }, 1e-9);
  columns.Cell[2] = { 6.0, 0.0, 1.5 };
  EXPECT_NEAR(Measure(columns).Free[2], across, 1e-9);
}

TEST(PeriodicSpace, MoleculeInALargeBox)
{
  const std::vector<Ball> cage = Cage();
  PocketOptions options;
  const PocketResult alone = FindPockets(cage, options);
  options.Cell = { { 60.0, 0.0, 0.0 }, { 5.0, 62.0, 0.0 }, { 0.0, -3.0, 64.0 } };
  const PocketResult boxed = FindPockets(cage, options);
  ASSERT_GE(alone.Pockets.size(), 1u);
  ASSERT_FALSE(alone.Pockets.front().Mouths.empty());
  ExpectRows(Rows(boxed), Rows(alone), 1e-5);
  EXPECT_NEAR(boxed.UnionVolume, alone.UnionVolume, 1e-5);
  EXPECT_NEAR(boxed.UnionArea, alone.UnionArea, 1e-5);
  for (std::size_t i = 0; i < alone.Pockets.size(); ++i)
  {
    EXPECT_NEAR(boxed.Pockets[i].Score, alone.Pockets[i].Score, 1e-5);
    EXPECT_NEAR(boxed.Pockets[i].Access, alone.Pockets[i].Access, 1e-8);
  }
}

// A pocket that crosses the faces of the cell is one piece.
TEST(PeriodicSpace, PocketsAreNotCutByTheCell)
{
  Crystal crystal{ { { 30.0, 0.0, 0.0 }, { 0.0, 31.0, 0.0 }, { 0.0, 0.0, 32.0 } }, Cage() };
  const PocketResult middle = FindAll(crystal);
  for (Ball& atom : crystal.Atoms)
  {
    atom.Center = atom.Center + Point3{ 15.0, 15.5, 16.0 };
  }
  const PocketResult corner = FindAll(crystal);
  ExpectRows(Rows(corner), Rows(middle), 1e-6);
  for (const PocketResult* result : { &middle, &corner })
  {
    for (const PocketCell& cell : result->Pockets.front().Cells)
    {
      EXPECT_LT(Distance(cell.Center, result->Pockets.front().Center), 16.0);
      for (const std::int64_t atom : cell.Atoms)
      {
        const Point3& at = result->Copies.at(static_cast<std::size_t>(atom));
        EXPECT_NEAR(Distance(at, cell.Center) - 1.7, cell.Clearance, 1e-6);
      }
    }
  }
}

TEST(PeriodicSpace, PoreProfileOfACell)
{
  vtkNew<vtkPoreProfile> filter;
  filter->SetInputData(MakeCrystal(Cubic({ { 0.0, 0.0, 0.0 } })));
  filter->SetMode(vtkPoreProfile::CellVectors);
  filter->Update();
  vtkTable* pores = filter->GetPoreTable();
  ASSERT_EQ(pores->GetNumberOfRows(), 3);
  for (int k = 0; k < 3; ++k)
  {
    EXPECT_EQ(pores->GetValueByName(k, "Direction").ToString(), std::string(1, "abc"[k]));
    EXPECT_NEAR(pores->GetValueByName(k, "Radius").ToDouble(), 6.0 / std::sqrt(2.0) - 1.0, 1e-9);
    EXPECT_NEAR(pores->GetValueByName(k, "Span").ToDouble(), 6.0, 1e-9);
    EXPECT_EQ(pores->GetValueByName(k, "Bottlenecks").ToInt(), 1);
  }
  EXPECT_NEAR(pores->GetFieldData()->GetArray("LargestIncludedRadius")->GetComponent(0, 0),
    3.0 * std::sqrt(3.0) - 1.0, 1e-9);
  EXPECT_EQ(filter->GetBottlenecks()->GetNumberOfPoints(), 3);
  EXPECT_GT(filter->GetLiningResidues()->GetNumberOfRows(), 0);
}

// The cell of a file changes nothing unless it is requested.
TEST(PeriodicSpace, OffByDefault)
{
  const Crystal crystal{ { { 22.0, 0.0, 0.0 }, { 0.0, 25.0, 0.0 }, { 0.0, 0.0, 25.0 } }, Cage() };
  vtkNew<vtkMolecularPockets> filter;
  filter->SetInputData(MakeCrystal(crystal));
  filter->Update();
  const double alone = filter->GetPocketTable()->GetValueByName(0, "Volume").ToDouble();
  EXPECT_DOUBLE_EQ(alone, FindPockets(crystal.Atoms, {}).Pockets.front().Volume);
  const auto area = [&]
  {
    return filter->GetPocketTable()->GetFieldData()->GetArray("AccessibleArea")->GetComponent(0, 0);
  };
  const double before = area();
  filter->UsePeriodicCellOn();
  filter->Update();
  EXPECT_LT(area(), before - 1.0); // copies touch
}

TEST(PeriodicSpace, CellsThatAreNone)
{
  const auto message = [](vtkPolyData* atoms)
  {
    vtkNew<vtkPoreProfile> filter;
    vtkNew<vtkTest::ErrorObserver> errors;
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->AddObserver(vtkCommand::WarningEvent, errors);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->SetInputData(atoms);
    filter->SetMode(vtkPoreProfile::CellVectors);
    filter->Update();
    return errors->GetErrorMessage() + errors->GetWarningMessage();
  };
  Crystal crystal = Cubic({ { 0.0, 0.0, 0.0 } });
  EXPECT_NE(message(MakeAtoms(crystal.Atoms)).find("no periodic cell"), std::string::npos);
  EXPECT_EQ(message(MakeCrystal(crystal)), "");
  const auto named = MakeCrystal(crystal);
  vtkNew<vtkStringArray> group;
  group->SetName("SpaceGroup");
  group->InsertNextValue("P 1");
  named->GetFieldData()->AddArray(group);
  EXPECT_EQ(message(named), "");
  group->SetValue(0, "P 21 21 21");
  named->Modified();
  EXPECT_NE(message(named).find("P 21 21 21"), std::string::npos);
  crystal.Cell[2] = crystal.Cell[0];
  EXPECT_NE(message(MakeCrystal(crystal)).find("thinner than"), std::string::npos);
  crystal.Cell[2] = { 0.0, 0.0, NAN };
  EXPECT_NE(message(MakeCrystal(crystal)).find("not finite"), std::string::npos);
  EXPECT_THROW(FindPeriodicPores(
                 {}, PeriodicCell({ { 6.0, 0.0, 0.0 }, { 0.0, 6.0, 0.0 }, { 0.0, 0.0, 6.0 } }), {}),
    std::invalid_argument);
}
