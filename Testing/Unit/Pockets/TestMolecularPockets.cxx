// Real proteins turned, moved, shuffled; areas by a second method; excluded atoms; bad input.

#include "Core/Geometry.h"
#include "vtkMolecularPockets.h"

#include "Atoms/PolymerAtoms.h"
#include "BallPoints.h"
#include "Pockets/MolecularPockets.h"
#include "SharedData.h"
#include "vtkMacromoleculeReader.h"

#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedShortArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <utility>

using namespace isthmus;

namespace
{

/// The chain's heavy atoms of a file.
std::vector<Ball> MakeAtoms(const std::string& path)
{
  vtkNew<vtkMacromoleculeReader> reader;
  reader->SetFileName(path.c_str());
  reader->SetReadHetero(false);
  reader->SetReadWater(false);
  reader->Update();
  vtkPointData* data = reader->GetOutput()->GetPointData();
  std::vector<Ball> atoms;
  for (vtkIdType i = 0; i < reader->GetOutput()->GetNumberOfPoints(); ++i)
  {
    if (data->GetArray("Element")->GetComponent(i, 0) > 1)
    {
      Ball ball{ {}, data->GetArray("Radius")->GetComponent(i, 0) };
      reader->GetOutput()->GetPoint(i, ball.Center.data());
      atoms.push_back(ball);
    }
  }
  return atoms;
}

/// Accessible surface by points spread evenly over each atom's sphere (Shrake and Rupley).
double AreaByPoints(const std::vector<Ball>& atoms, double probe, int perAtom)
{
  double sum = 0.0;
  for (const Ball& atom : atoms)
  {
    std::vector<const Ball*> near;
    for (const Ball& other : atoms)
    {
      const Point3 d = other.Center - atom.Center;
      const double reach = atom.Radius + other.Radius + 2.0 * probe;
      if (&other != &atom && Dot(d, d) < reach * reach)
      {
        near.push_back(&other);
      }
    }
    int free = 0;
    const double r = atom.Radius + probe;
    for (int i = 0; i < perAtom; ++i)
    {
      const double z = 1.0 - (2.0 * i + 1.0) / perAtom;
      const double angle = Pi * (1.0 + std::sqrt(5.0)) * i;
      const double rho = std::sqrt(1.0 - z * z);
      const Point3 p = atom.Center + r * Point3{ rho * std::cos(angle), rho * std::sin(angle), z };
      free += std::none_of(near.begin(), near.end(),
        [&](const Ball* other)
        {
          const Point3 d = p - other->Center;
          return Dot(d, d) < (other->Radius + probe) * (other->Radius + probe);
        });
    }
    sum += 4.0 * Pi * r * r * free / perAtom;
  }
  return sum;
}

Point3 Turn(const Point3& p)
{
  const double c = std::cos(1.1);
  const double s = std::sin(1.1);
  const Point3 q{ c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
  return { q[0] + 50.0, c * q[1] - s * q[2] - 30.0, s * q[1] + c * q[2] + 120.0 };
}

/// Runs the filter and returns its errors and warnings.
template <typename Change>
std::string RecordErrors(vtkPolyData* input, Change change, vtkIdType& pockets)
{
  vtkNew<vtkMolecularPockets> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  for (auto* object : std::initializer_list<vtkObject*>{ filter, filter->GetExecutive() })
  {
    object->AddObserver(vtkCommand::ErrorEvent, observer);
    object->AddObserver(vtkCommand::WarningEvent, observer);
  }
  filter->SetInputData(input);
  change(filter.Get());
  filter->Update();
  pockets = filter->GetPocketTable()->GetNumberOfRows();
  return observer->GetErrorMessage() + observer->GetWarningMessage();
}

NamedAtom Make(const char* name, const char* residue, int number, bool hetero, const Point3& place)
{
  NamedAtom atom;
  atom.Name = name;
  atom.Residue = residue;
  atom.ResidueId = number;
  atom.IsHetero = hetero;
  atom.Place = place;
  atom.Element = 6;
  atom.Chain = "A";
  return atom;
}

}

TEST(MolecularPockets, AreaOfLysozymeByASecondMethod)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew.pdb");
  const std::string path = (isthmus::testing::SharedDataFolder() / "molecules/1hew.pdb").string();
  const auto atoms = MakeAtoms(path);
  const PocketResult result = FindPockets(atoms, {});
  const double area = AreaByPoints(atoms, 1.4, 2000);
  EXPECT_GT(result.UnionArea, 0.0);
  EXPECT_NEAR(result.UnionArea, area, 0.005 * area);
}

TEST(MolecularPockets, MouthsAreAsOpenAsTheyLook)
{
  // A hollow ball of atoms of two sizes with one hole, whose triangles are sampled point by point.
  std::vector<Ball> atoms;
  constexpr int count = 150;
  for (int i = 0; i < count; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / count;
    const double angle = Pi * (1.0 + std::sqrt(5.0)) * i;
    const double rho = std::sqrt(1.0 - z * z);
    if (z < 0.93)
    {
      atoms.push_back(
        { 8.0 * Point3{ rho * std::cos(angle), rho * std::sin(angle), z }, i % 2 ? 1.2 : 1.6 });
    }
  }
  PocketOptions options;
  options.MinimumVolume = 0.0;
  const PocketResult result = FindPockets(atoms, options);
  ASSERT_GE(result.Pockets.size(), 1u);
  double sum = 0.0;
  int covered = 0;
  for (const PocketMouth& mouth : result.Pockets[0].Mouths)
  {
    double area = 0.0;
    for (const auto& corners : mouth.Triangles)
    {
      std::array<Ball, 3> ball;
      for (std::size_t k = 0; k < 3; ++k)
      {
        ball[k] = atoms[static_cast<std::size_t>(corners[k])];
        ball[k].Radius += options.ProbeRadius;
      }
      const Point3 u = ball[1].Center - ball[0].Center, v = ball[2].Center - ball[0].Center;
      constexpr int n = 200;
      int open = 0;
      for (int i = 0; i < n * n; ++i) // centers of as many small triangles, of two kinds
      {
        const bool up = i / n + i % n < n;
        const double x = up ? i / n + 1.0 / 3.0 : n - i / n - 1.0 / 3.0;
        const double y = up ? i % n + 1.0 / 3.0 : n - i % n - 1.0 / 3.0;
        const Point3 p = ball[0].Center + (x / n) * u + (y / n) * v;
        open += std::none_of(
          ball.begin(), ball.end(), [&](const Ball& b) { return Length(p - b.Center) < b.Radius; });
      }
      area += 0.5 * Length(Cross(u, v)) * open / (n * n);
      for (std::size_t k = 0; k < 3; ++k)
      {
        const Ball& next = ball[(k + 1) % 3];
        covered += Length(ball[k].Center - next.Center) < ball[k].Radius + next.Radius;
      }
    }
    // Not exact: a disc that reaches across the opposite edge is taken for one that does not.
    EXPECT_NEAR(mouth.Area, area, 0.06 * area);
    sum += area;
  }
  vtkNew<vtkMolecularPockets> filter;
  filter->SetInputData(isthmus::testing::MakeAtoms(atoms));
  filter->SetMinimumVolume(0.0);
  filter->Update();
  vtkTable* const table = filter->GetPocketTable();
  ASSERT_EQ(table->GetNumberOfRows(), static_cast<vtkIdType>(result.Pockets.size()));
  ASSERT_GT(table->GetNumberOfColumns(), 10);
  for (vtkIdType column = 0; column < table->GetNumberOfColumns(); ++column)
  {
    EXPECT_EQ(table->GetColumn(column)->GetNumberOfTuples(), table->GetNumberOfRows())
      << table->GetColumnName(column);
  }
  EXPECT_EQ(
    table->GetValueByName(0, "Mouths").ToInt(), static_cast<int>(result.Pockets[0].Mouths.size()));
  EXPECT_NEAR(table->GetValueByName(0, "MouthArea").ToDouble(), sum, 0.06 * sum);
  EXPECT_GT(sum, 1.0);
  EXPECT_GT(covered, 2); // discs that overlap on an edge count once
}

TEST(MolecularPockets, DoNotDependOnRotationTranslationOrOrder)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew.pdb");
  const std::string path = (isthmus::testing::SharedDataFolder() / "molecules/1hew.pdb").string();
  auto atoms = MakeAtoms(path);
  const PocketResult before = FindPockets(atoms, {});
  auto shuffled = atoms;
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937(1));
  const PocketResult other = FindPockets(shuffled, {});
  for (Ball& atom : atoms)
  {
    atom.Center = Turn(atom.Center);
  }
  const PocketResult turned = FindPockets(atoms, {});
  ASSERT_GE(before.Pockets.size(), 2u);
  ASSERT_EQ(before.Pockets.size(), other.Pockets.size());
  ASSERT_EQ(before.Pockets.size(), turned.Pockets.size());
  for (std::size_t i = 0; i < before.Pockets.size(); ++i)
  {
    const Pocket& a = before.Pockets[i];
    EXPECT_EQ(a.Score, other.Pockets[i].Score); // bit by bit
    EXPECT_EQ(a.Volume, other.Pockets[i].Volume);
    EXPECT_EQ(a.Center, other.Pockets[i].Center);
    EXPECT_NEAR(a.Score, turned.Pockets[i].Score, 1e-6 * a.Score);
    EXPECT_NEAR(a.Volume, turned.Pockets[i].Volume, 1e-6 * a.Volume);
    EXPECT_NEAR(a.Area, turned.Pockets[i].Area, 1e-6 * a.Area);
    const Point3 d = Turn(a.Center) - turned.Pockets[i].Center;
    EXPECT_LT(std::sqrt(Dot(d, d)), 1e-6);
    EXPECT_EQ(a.Mouths.size(), turned.Pockets[i].Mouths.size());
  }
}

TEST(MolecularPockets, IdenticalOnAnyNumberOfThreads)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew.pdb");
  const std::string path = (isthmus::testing::SharedDataFolder() / "molecules/1hew.pdb").string();
  const auto data = isthmus::testing::MakeAtoms(MakeAtoms(path));
  const auto scores = [&](int threads)
  {
    std::vector<double> values;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        vtkNew<vtkMolecularPockets> filter;
        filter->SetInputData(data);
        filter->Update();
        for (vtkIdType row = 0; row < filter->GetPocketTable()->GetNumberOfRows(); ++row)
        {
          for (const char* name : { "Score", "CenterX", "Volume", "Area", "MouthArea" })
          {
            values.push_back(filter->GetPocketTable()->GetValueByName(row, name).ToDouble());
          }
        }
      });
    return values;
  };
  const auto one = scores(1);
  ASSERT_GE(one.size(), 10u);
  EXPECT_EQ(one, scores(2));
  EXPECT_EQ(one, scores(5));
}

TEST(MolecularPockets, TheVolumeIsAThresholdOfKeptPockets)
{
  ISTHMUS_NEEDS_SHARED_DATA("molecules/1hew.pdb");
  const std::string path = (isthmus::testing::SharedDataFolder() / "molecules/1hew.pdb").string();
  const auto data = isthmus::testing::MakeAtoms(MakeAtoms(path));
  vtkNew<vtkMolecularPockets> kept;
  kept->SetInputData(data);
  const auto scores = [](vtkMolecularPockets* filter, double least, bool sites)
  {
    filter->SetMinimumVolume(least);
    filter->SetFindSites(sites);
    filter->Update();
    std::vector<double> values;
    for (vtkIdType row = 0; row < filter->GetPocketTable()->GetNumberOfRows(); ++row)
    {
      for (const char* name : { "Rank", "Score", "CenterX", "Volume" })
      {
        values.push_back(filter->GetPocketTable()->GetValueByName(row, name).ToDouble());
      }
    }
    return values;
  };
  std::size_t count = 0;
  for (const double least : { 10.0, 100.0, 0.0, 30.0 })
  {
    vtkNew<vtkMolecularPockets> fresh;
    fresh->SetInputData(data);
    const std::vector<double> values = scores(kept, least, false);
    EXPECT_EQ(values, scores(fresh, least, false)) << least;
    EXPECT_NE(values.size(), count) << least;
    count = values.size();
  }
  vtkNew<vtkMolecularPockets> fresh;
  fresh->SetInputData(data);
  EXPECT_EQ(scores(kept, 10.0, true), scores(fresh, 10.0, true));
  const vtkIdType atoms = kept->GetLiningAtoms()->GetNumberOfPoints();
  kept->SetShownPocket(1);
  kept->Update();
  EXPECT_LT(kept->GetLiningAtoms()->GetNumberOfPoints(), atoms);
}

TEST(MolecularPockets, NoAtomsFewOrFlatOnesHaveNoPockets)
{
  std::vector<Ball> flat;
  for (int i = 0; i < 100; ++i)
  {
    flat.push_back({ { 1.5 * (i % 10), 1.5 * (i / 10), 3.0 }, 1.7 });
  }
  const std::vector<Ball> one{ { { 1, 2, 3 }, 1.7 } };
  const std::vector<Ball> coinciding(5, one[0]);
  const std::vector<Ball> none;
  for (const std::vector<Ball>* atoms : { &std::as_const(flat), &one, &coinciding, &none })
  {
    vtkIdType pockets = -1;
    const std::string said = RecordErrors(
      isthmus::testing::MakeAtoms(*atoms), [](vtkMolecularPockets*) {}, pockets);
    EXPECT_EQ(said.empty(), atoms != &coinciding) << said;
    EXPECT_EQ(pockets, 0);
  }
  vtkNew<vtkPolyData> empty;
  vtkIdType pockets = -1;
  EXPECT_EQ(RecordErrors(
              empty, [](vtkMolecularPockets*) {}, pockets),
    "");
}

TEST(MolecularPockets, CoincidentAndZeroRadiusAtomsHaveNoEffect)
{
  std::mt19937 random(8);
  std::uniform_real_distribution<double> place(-9.0, 9.0);
  std::vector<Ball> atoms;
  for (int i = 0; i < 400; ++i)
  {
    const Point3 p{ place(random), place(random), place(random) };
    atoms.push_back({ p, 1.6 });
  }
  const PocketResult before = FindPockets(atoms, {});
  auto more = atoms;
  more.insert(more.end(), atoms.begin(), atoms.begin() + 50);
  for (int i = 0; i < 50; ++i)
  {
    more.push_back({ atoms[static_cast<std::size_t>(i)].Center, 0.0 });
  }
  const PocketResult after = FindPockets(more, {});
  ASSERT_EQ(before.Pockets.size(), after.Pockets.size());
  EXPECT_NEAR(before.UnionArea, after.UnionArea, 1e-8 * before.UnionArea);
  EXPECT_NEAR(before.PocketVolume, after.PocketVolume, 1e-6);
}

TEST(MolecularPockets, ReportsValuesOutOfRange)
{
  std::vector<Ball> atoms{ { { 0, 0, 0 }, 1.7 }, { { 5, 0, 0 }, 1.7 }, { { 0, 5, 0 }, 1.7 },
    { { 0, 0, 5 }, 1.7 }, { { 5, 5, 5 }, 1.7 } };
  const auto expect = [&](const char* word, auto change)
  {
    vtkIdType pockets = -1;
    const std::string said = RecordErrors(isthmus::testing::MakeAtoms(atoms), change, pockets);
    EXPECT_NE(said.find(word), std::string::npos) << word << " not in: " << said;
    EXPECT_EQ(pockets, 0);
  };
  for (const double bad : { -1.0, std::nan(""), HUGE_VAL })
  {
    expect("InnerRadius", [&](vtkMolecularPockets* f) { f->SetInnerRadius(bad); });
    expect("OuterRadius", [&](vtkMolecularPockets* f) { f->SetOuterRadius(bad); });
    expect("ProbeRadius", [&](vtkMolecularPockets* f) { f->SetProbeRadius(bad); });
    expect("BurialRadius", [&](vtkMolecularPockets* f) { f->SetBurialRadius(bad); });
    expect("MinimumVolume", [&](vtkMolecularPockets* f) { f->SetMinimumVolume(bad); });
  }
  expect("OuterRadius", [](vtkMolecularPockets* f) { f->SetOuterRadius(1.0); });
  expect("array", [](vtkMolecularPockets* f) { f->SetInputArrayToProcess(0, 0, 0, 0, "None"); });
  atoms[2].Radius = -0.5;
  expect("radius", [](vtkMolecularPockets*) {});
  atoms[2].Radius = std::nan("");
  expect("no radius", [](vtkMolecularPockets*) {}); // a warning; the four others have no pocket
  atoms[2].Radius = 1.7;
  for (const double bad : { std::nan(""), HUGE_VAL, 1e300 })
  {
    atoms[1].Center[2] = bad;
    expect("coordinate", [](vtkMolecularPockets*) {});
  }
}

TEST(PolymerAtoms, ChainsAreRecognisedUnderAnyName)
{
  // Ala, a modified residue linked to it, a cap, a free amino acid, heme, water, an ion.
  const std::vector<NamedAtom> atoms{ Make("N", "ALA", 1, false, { 0, 0, 0 }),
    Make("CA", "ALA", 1, false, { 1.5, 0, 0 }), Make("C", "ALA", 1, false, { 2.5, 1, 0 }),
    Make("N", "SEP", 2, true, { 3.8, 1, 0 }), Make("C", "SEP", 2, true, { 5.5, 1, 0 }),
    Make("N", "NH2", 3, true, { 6.8, 1, 0 }), Make("N", "GLU", 9, true, { 20, 0, 0 }),
    Make("CA", "GLU", 9, true, { 21.5, 0, 0 }), Make("FE", "HEM", 10, true, { 30, 0, 0 }),
    Make("NA", "HEM", 10, true, { 32, 0, 0 }), Make("O", "HOH", 11, true, { 40, 0, 0 }),
    Make("ZN", "ZN", 12, true, { 50, 0, 0 }) };
  const PolymerChoice choice = ChoosePolymer(atoms, {});
  EXPECT_EQ(choice.Kept, (std::vector<std::size_t>{ 0, 1, 2, 3, 4, 5 }));
  EXPECT_EQ(choice.Notes.size(), 4u);
  PolymerOptions heme;
  heme.ProstheticGroups = true;
  heme.Residues = { "GLU" };
  EXPECT_EQ(ChoosePolymer(atoms, heme).Kept.size(), 10u);
}

TEST(PolymerAtoms, AlternateLocationsHydrogensAndNoNames)
{
  auto atoms = std::vector<NamedAtom>{ Make("CB", "SER", 1, false, { 0, 0, 0 }),
    Make("OG", "SER", 1, false, { 1, 0, 0 }), Make("OG", "SER", 1, false, { 0, 1, 0 }),
    Make("HG", "SER", 1, false, { 0, 2, 0 }) };
  atoms[1].AltLoc = "A";
  atoms[1].Occupancy = 0.4;
  atoms[2].AltLoc = "B";
  atoms[2].Occupancy = 0.6;
  atoms[3].Element = 1;
  EXPECT_EQ(ChoosePolymer(atoms, {}).Kept, (std::vector<std::size_t>{ 0, 2 }));
  const std::vector<NamedAtom> nameless(7);
  EXPECT_EQ(ChoosePolymer(nameless, {}).Kept.size(), 7u);
}
