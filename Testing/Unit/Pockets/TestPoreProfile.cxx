// Pores of known width: hyperboloids and tubes of atoms; rotated and moved; cases without a pore;
// bad input.

#include "Core/Geometry.h"
#include "vtkPoreProfile.h"

#include "BallPoints.h"
#include "Pockets/CellAccessibility.h"
#include "Pockets/EmptySpace.h"
#include "Pockets/LongTriangulation.h"
#include "Pockets/MolecularPockets.h"
#include "Pockets/PoreChannels.h"
#include "Pockets/PoreProfile.h"
#include "Pockets/PoreRadius.h"
#include "Pockets/SiteDescriptors.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSMPTools.h>
#include <vtkStringArray.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <functional>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

using namespace isthmus;
using isthmus::testing::MakeAtoms;

namespace
{

constexpr double Throat = 2.2; // of the free space, angstrom
constexpr double Radius = 1.5; // of the atoms
constexpr double Slope = 0.45;

/// Distance from the axis of the atoms' centers at height z.
double WallAt(double z)
{
  return std::sqrt((Throat + Radius) * (Throat + Radius) + Slope * Slope * z * z);
}

/// A one-sheeted hyperboloid of atoms in rings of `count`, from -12 to 12 along z, with a brim.
std::vector<Ball> Hyperboloid(int count)
{
  std::vector<Ball> atoms;
  const auto ring = [&](double r, double z, int number)
  {
    for (int i = 0; i < number; ++i)
    {
      const double angle = 2.0 * Pi * i / number;
      atoms.push_back({ { r * std::cos(angle), r * std::sin(angle), z }, Radius });
    }
  };
  for (double z = -12.0; z <= 12.0; z += 1.0)
  {
    ring(WallAt(z), z, count);
  }
  for (double r = WallAt(12.0) + 1.5; r < WallAt(12.0) + 12.0; r += 1.5)
  {
    ring(r, -12.0, 3 * count);
    ring(r, 12.0, 3 * count);
  }
  return atoms;
}

Point3 Turn(const Point3& p)
{
  const double c = std::cos(0.7);
  const double s = std::sin(0.7);
  const Point3 q{ c * p[0] - s * p[1], s * p[0] + c * p[1], p[2] };
  return { q[0] + 5.0, c * q[1] - s * q[2] - 30.0, s * q[1] + c * q[2] + 12.0 };
}

double Least(const Pore& pore)
{
  double least = HUGE_VAL;
  for (const PoreSample& sample : pore.Samples)
  {
    least = std::min(least, sample.Radius);
  }
  return least;
}

}

TEST(PoreProfile, HyperboloidHasItsThroatInTheMiddle)
{
  const auto atoms = Hyperboloid(24);
  PoreOptions options;
  options.EndRadius = 4.5;
  options.MinimumSpan = 10.0;
  const auto pores = FindPores(atoms, options);
  ASSERT_EQ(pores.size(), 1u);
  // Between rings one angstrom apart the throat is wider than at z = 0, where a ring is.
  EXPECT_NEAR(Least(pores[0]), Throat, 0.005); // planes are 0.25 apart
  for (const PoreSample& sample : pores[0].Samples)
  {
    EXPECT_LT(std::hypot(sample.Center[0], sample.Center[1]), 0.5);
  }
  ASSERT_EQ(pores[0].Bottlenecks.empty(), false);
  EXPECT_NEAR(pores[0].Samples[pores[0].Bottlenecks[0]].Center[2], 0.0, 0.2);
}

// The exact radius is known at all heights, since it is that of the nearest ring.
TEST(PoreProfile, ErrorsBetweenPlanesAreCovered)
{
  const auto atoms = Hyperboloid(24);
  const auto exact = [&](double z)
  {
    double least = HUGE_VAL;
    for (double ring = -12.0; ring <= 12.0; ring += 1.0)
    {
      least = std::min(least, std::hypot(WallAt(ring), z - ring) - Radius);
    }
    return least;
  };
  for (const double spacing : { 0.25, 0.7, 1.3 })
  {
    PoreOptions options;
    options.EndRadius = 4.5;
    options.Spacing = spacing;
    const Pore pore = PoreAlong(atoms, { 0.0, 0.0, 0.37 }, { 0.0, 0.0, 1.0 }, options);
    ASSERT_GT(pore.Samples.size(), 5U);
    int covered = 0, close = 0, all = 0;
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < pore.Samples.size(); ++i)
    {
      const PoreSample& here = pore.Samples[i];
      double deviation = 0.0;
      for (const std::size_t k : { i - 1, i + 1 })
      {
        const PoreSample& next = pore.Samples[k];
        for (double share = 0.0; share <= 1.0; share += 0.01)
        {
          const double z = here.Center[2] + share * (next.Center[2] - here.Center[2]);
          deviation = std::max(
            deviation, std::abs(exact(z) - here.Radius - share * (next.Radius - here.Radius)));
        }
      }
      ++all;
      covered += here.RadiusError >= deviation ? 1 : 0;
      close += here.RadiusError <= 5.0 * deviation + 2e-4 ? 1 : 0;
      largest = std::max(largest, deviation);
    }
    EXPECT_GE(covered, 0.9 * all) << spacing;
    EXPECT_GE(close, 0.9 * all) << spacing;
    EXPECT_GT(largest, 1e-3) << "there is something to cover";
    const double missed = Least(pore) - Throat;
    EXPECT_GE(pore.DipBelowNarrowest(), missed) << spacing;
    EXPECT_LE(pore.DipBelowNarrowest(), 5.0 * missed + 2e-4) << spacing;
  }
}

TEST(PoreProfile, BottlenecksStateTheirErrors)
{
  vtkNew<vtkPoreProfile> filter;
  filter->SetInputData(MakeAtoms(Hyperboloid(24)));
  filter->SetMode(vtkPoreProfile::PointAndDirection);
  filter->SetPoint(0.0, 0.0, 0.5);
  filter->SetSpacing(1.0);
  filter->SetEndRadius(4.5);
  filter->Update();
  vtkTable* pores = filter->GetPoreTable();
  ASSERT_EQ(pores->GetNumberOfRows(), 1);
  const double radius = pores->GetValueByName(0, "Radius").ToDouble();
  const double error = pores->GetValueByName(0, "RadiusError").ToDouble();
  EXPECT_GT(radius, Throat + 0.01) << "no plane is at the throat";
  EXPECT_LE(radius - error, Throat);
  EXPECT_GE(radius - 2.0 * error, Throat - 0.05);
  ASSERT_GT(filter->GetBottlenecks()->GetNumberOfPoints(), 0);
  vtkDataArray* errors = filter->GetBottlenecks()->GetPointData()->GetArray("RadiusError");
  ASSERT_NE(errors, nullptr);
  EXPECT_NEAR(errors->GetComponent(0, 0), error, 1e-3);
  EXPECT_NE(filter->GetProfile()->GetColumnByName("RadiusError"), nullptr);
  EXPECT_NE(filter->GetOutput()->GetPointData()->GetArray("RadiusError"), nullptr);
}

TEST(PoreProfile, RadiusInPlanesIsTheHyperboloids)
{
  // In the plane of a ring the nearest atoms are those of the rings around: the largest ball on the
  // axis is known from a search through all atoms.
  const auto atoms = Hyperboloid(24);
  PoreOptions options;
  options.EndRadius = 4.5;
  options.Spacing = 0.5;
  const Pore pore = PoreAlong(atoms, { 0.3, -0.2, 0.0 }, { 0, 0, 2.0 }, options);
  ASSERT_GT(pore.Samples.size(), 20u);
  for (const PoreSample& sample : pore.Samples)
  {
    double expected = HUGE_VAL;
    for (const Ball& atom : atoms)
    {
      const Point3 d = atom.Center - Point3{ 0, 0, sample.Center[2] };
      expected = std::min(expected, std::sqrt(Dot(d, d)) - atom.Radius);
    }
    EXPECT_GE(sample.Radius, expected - 1e-9);
    EXPECT_LT(sample.Radius, expected + 0.02);
  }
}

TEST(PoreProfile, TwoPointsFollowTheSamePore)
{
  const auto atoms = Hyperboloid(24);
  PoreOptions options;
  const Pore pore = PoreBetween(atoms, { 0, 0, -8 }, { 0, 0, 8 }, options);
  EXPECT_NEAR(Least(pore), Throat, 1e-6);
  EXPECT_NEAR(pore.Span, 16.0, 0.6);
}

TEST(PoreProfile, DoesNotDependOnRotationOrTranslation)
{
  auto atoms = Hyperboloid(23);
  PoreOptions options;
  options.EndRadius = 4.5;
  options.MinimumSpan = 10.0;
  const auto before = FindPores(atoms, options);
  for (Ball& atom : atoms)
  {
    atom.Center = Turn(atom.Center);
  }
  const auto after = FindPores(atoms, options);
  ASSERT_EQ(before.size(), 1u);
  ASSERT_EQ(after.size(), 1u);
  EXPECT_NEAR(Least(before[0]), Least(after[0]), 1e-6);
}

TEST(PoreProfile, ClosedShellAndFewAtomsHaveNone)
{
  std::vector<Ball> shell;
  for (int i = 0; i < 400; ++i)
  {
    const double z = 1.0 - (2.0 * i + 1.0) / 400;
    const double angle = Pi * (1.0 + std::sqrt(5.0)) * i;
    const double rho = std::sqrt(1.0 - z * z);
    shell.push_back({ { 9.0 * rho * std::cos(angle), 9.0 * rho * std::sin(angle), 9.0 * z }, 1.7 });
  }
  EXPECT_TRUE(FindPores(shell, {}).empty());
  EXPECT_TRUE(FindPores({}, {}).empty());
  EXPECT_TRUE(FindPores({ { { 0, 0, 0 }, 1.0 } }, {}).empty());
  EXPECT_TRUE(FindPores({ { { 0, 0, 0 }, 1.0 }, { { 0, 0, 0 }, 1.0 } }, {}).empty());
}

// Atoms far apart, as in picometres: each search visited millions of empty bins, and Automatic took
// more than ten minutes.
TEST(PoreProfile, ClearanceAmongAtomsFarApart)
{
  std::vector<Ball> atoms;
  for (int i = 0; i < 1000; ++i)
  {
    atoms.push_back({ { 4000.0 * (i % 10), 4000.0 * (i / 10 % 10), 4000.0 * (i / 100) }, 170.0 });
  }
  atoms.push_back({ { 1e8, 0.0, 0.0 }, 170.0 }); // a stray one
  const AtomField field(atoms);
  const std::clock_t began = std::clock();
  for (int i = 0; i < 200; ++i)
  {
    const auto found = field.At({ 2000.0 + 4000.0 * (i % 9), 2000.0, 18000.0 });
    EXPECT_NEAR(found.Radius, 2000.0 * std::sqrt(3.0) - 170.0, 1e-9);
  }
  EXPECT_LT(static_cast<double>(std::clock() - began) / CLOCKS_PER_SEC, 1.0);
}

TEST(PoreProfile, TimeOfTheTriangulationIsPredictedOnce)
{
  int calls = 0;
  double predicted = 0.0;
  PoreOptions options;
  options.Predicted = [&](double seconds)
  {
    ++calls;
    predicted = seconds;
  };
  FindPores(Hyperboloid(24), options);
  EXPECT_EQ(calls, 1);
  EXPECT_GT(predicted, 0.0);
  EXPECT_LT(predicted, 30.0);
}

TEST(PoreProfile, WarnsAboutALongTriangulation)
{
  vtkNew<vtkPoreProfile> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  const auto warn = WarnAboutLongTriangulation(filter);
  warn(4.9);
  EXPECT_FALSE(observer->GetWarning());
  warn(12.0);
  EXPECT_NE(observer->GetWarningMessage().find("about 12 s"), std::string::npos);
}

TEST(PoreProfile, FilterGivesLinesTablesAndTubesOnAnyNumberOfThreads)
{
  const auto data = MakeAtoms(Hyperboloid(24));
  const auto radii = [&](int threads)
  {
    std::vector<double> values;
    vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false },
      [&]()
      {
        vtkNew<vtkPoreProfile> profile;
        profile->SetInputData(data);
        profile->SetEndRadius(4.5);
        profile->SetMinimumSpan(10.0);
        profile->Update();
        auto* array = profile->GetOutput()->GetPointData()->GetArray("Radius");
        for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
        {
          values.push_back(array->GetComponent(i, 0));
        }
        EXPECT_EQ(profile->GetProfile()->GetNumberOfRows(), array->GetNumberOfTuples());
        EXPECT_EQ(profile->GetPoreTable()->GetNumberOfRows(), 1);
        EXPECT_GE(profile->GetBottlenecks()->GetNumberOfPoints(), 1);
        EXPECT_GT(profile->GetTubes()->GetNumberOfPoints(), array->GetNumberOfTuples());
      });
    return values;
  };
  const auto one = radii(1);
  ASSERT_FALSE(one.empty());
  EXPECT_EQ(one, radii(3));
}

TEST(PoreProfile, SamplesNameTheResidueOfTheirNearestAtom)
{
  // The atom that is nearest at the throat comes first, and is nearer than the others of its ring.
  std::vector<Ball> balls = Hyperboloid(24);
  std::rotate(balls.begin(), balls.begin() + 12 * 24, balls.end());
  balls[0].Radius += 0.05;
  const auto data = MakeAtoms(balls);
  vtkNew<vtkStringArray> names;
  vtkNew<vtkIntArray> numbers;
  names->SetName("ResidueName");
  numbers->SetName("ResidueId");
  for (std::size_t i = 0; i < balls.size(); ++i)
  {
    names->InsertNextValue("SER");
    numbers->InsertNextValue(static_cast<int>(i) + 100);
  }
  data->GetPointData()->AddArray(names);
  data->GetPointData()->AddArray(numbers);
  vtkNew<vtkPoreProfile> profile;
  profile->SetInputData(data);
  profile->SetEndRadius(4.5);
  profile->SetMinimumSpan(10.0);
  profile->Update();
  vtkTable* const table = profile->GetProfile();
  ASSERT_GT(table->GetNumberOfRows(), 20);
  int first = 0;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    const int atom = table->GetValueByName(row, "NearestAtom").ToInt();
    first += atom == 0 ? 1 : 0;
    EXPECT_EQ(
      table->GetValueByName(row, "NearestResidue").ToString(), "SER " + std::to_string(atom + 100));
    const double radius = table->GetValueByName(row, "Radius").ToDouble();
    EXPECT_EQ(
      table->GetValueByName(row, "WidthClass").ToInt(), radius < 1.15 ? 0 : (radius < 2.3 ? 1 : 2));
  }
  EXPECT_GE(first, 1);
}

TEST(PoreProfile, ReportsValuesOutOfRange)
{
  const auto data = MakeAtoms(Hyperboloid(24));
  const auto refuses = [&](auto&& change, const char* word)
  {
    vtkNew<vtkPoreProfile> profile;
    vtkNew<vtkTest::ErrorObserver> observer;
    profile->AddObserver(vtkCommand::ErrorEvent, observer);
    profile->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, observer);
    profile->SetInputData(data);
    change(profile.Get());
    profile->Update();
    EXPECT_NE(observer->GetErrorMessage().find(word), std::string::npos)
      << word << " not in: " << observer->GetErrorMessage();
    EXPECT_EQ(profile->GetOutput()->GetNumberOfPoints(), 0);
  };
  for (const double bad : { 0.0, -1.0, std::nan(""), HUGE_VAL })
  {
    refuses([&](vtkPoreProfile* p) { p->SetEndRadius(bad); }, "EndRadius");
    refuses([&](vtkPoreProfile* p) { p->SetSpacing(bad); }, "Spacing");
    refuses([&](vtkPoreProfile* p) { p->SetMinimumRadius(bad); }, "MinimumRadius");
    refuses([&](vtkPoreProfile* p) { p->SetMaximumOffset(bad); }, "MaximumOffset");
  }
  refuses([](vtkPoreProfile* p) { p->SetMinimumSpan(std::nan("")); }, "MinimumSpan");
  refuses([](vtkPoreProfile* p) { p->SetMode(vtkPoreProfile::TwoPoints); }, "Point1");
  refuses(
    [](vtkPoreProfile* p)
    {
      p->SetMode(vtkPoreProfile::PointAndDirection);
      p->SetDirection(0, 0, 0);
    },
    "Direction");
  refuses(
    [](vtkPoreProfile* p)
    {
      p->SetMode(vtkPoreProfile::PointAndDirection);
      p->SetPoint(std::nan(""), 0, 0);
    },
    "Point");
}

TEST(PoreProfile, EveryModeChecksItsOptions)
{
  const std::vector<Ball> atoms = Hyperboloid(24);
  PoreOptions options;
  options.MaximumOffset = -1.0;
  EXPECT_THROW(FindPores(atoms, options), std::invalid_argument);
  EXPECT_THROW(PoreBetween(atoms, { 0, 0, -12 }, { 0, 0, 12 }, options), std::invalid_argument);
  EXPECT_THROW(PoreAlong(atoms, { 0, 0, 0 }, { 0, 0, 1 }, options), std::invalid_argument);
}

namespace
{

/// Atoms in convex position: many flat tetrahedra, whose values need exact arithmetic.
std::vector<Ball> Cone(int count)
{
  std::vector<Ball> atoms;
  for (int i = 0; i < count; ++i)
  {
    const double r = std::sqrt((i + 0.5) / count), angle = Pi * (1.0 + std::sqrt(5.0)) * i;
    atoms.push_back({ { 60.0 * r * std::cos(angle), 60.0 * r * std::sin(angle), 120.0 * r }, 1.7 });
  }
  return atoms;
}

/// Calls of the progress that lie between two fractions, ends excluded.
std::int64_t CallsBetween(const std::vector<double>& calls, double low, double high)
{
  return std::count_if(
    calls.begin(), calls.end(), [=](double done) { return done > low && done < high; });
}

}

/// A tube 80 wide and 120 long, one atom for 9 square angstrom: planes are 1.9 angstrom apart.
TEST(PoreProfile, AVeryWideChannelIsSampledByItsWidthAndReportsProgress)
{
  constexpr double wall = 40.0, half = 60.0;
  constexpr int around = 84, rings = 41;
  std::vector<Ball> atoms;
  for (int ring = 0; ring < rings; ++ring)
  {
    for (int i = 0; i < around; ++i)
    {
      const double angle = 2.0 * Pi * (i + 0.5 * (ring % 2)) / around;
      atoms.push_back({ { wall * std::cos(angle), wall * std::sin(angle),
                          half * (2.0 * ring / (rings - 1) - 1.0) },
        1.7 });
    }
  }
  std::vector<double> calls;
  const auto pores = FindPores(atoms, {},
    [&](double done)
    {
      calls.push_back(done);
      return true;
    });
  ASSERT_EQ(pores.size(), 1u);
  const double free = wall - 1.7;
  EXPECT_NEAR(
    pores[0].Samples[pores[0].Bottlenecks.empty() ? 0 : pores[0].Bottlenecks[0]].Radius, free, 0.1);
  EXPECT_NEAR(pores[0].Span, 2.0 * half, 12.0);
  const double spacing = PoreOptions{}.Spacing * free / PoreOptions{}.EndRadius;
  EXPECT_NEAR(static_cast<double>(pores[0].Samples.size()), pores[0].Span / spacing, 6.0);
  EXPECT_GE(CallsBetween(calls, 0.851, 0.999), 10);
  const auto cancels = [](double done) { return done < 0.9; };
  EXPECT_THROW(FindPores(atoms, {}, cancels), Cancelled);
}

/// In the steps that take longest, values of tetrahedra and triangles and the widest paths:
/// fractions of the pores' 0.3 and of the pockets' 0.4.
TEST(PoreProfile, ProgressMovesAndStopsInTheLoopsOverCells)
{
  const auto atoms = Cone(4000);
  for (const bool isPore : { false, true })
  {
    SCOPED_TRACE(isPore ? "pores" : "pockets");
    const auto run = [&](const ProgressCallback& progress)
    {
      return isPore ? FindPores(atoms, {}, progress).size()
                    : FindPockets(atoms, {}, progress).Pockets.size();
    };
    const double whole = isPore ? 0.3 : 0.4;
    std::vector<double> calls;
    run(
      [&](double done)
      {
        calls.push_back(done);
        return true;
      });
    EXPECT_TRUE(std::is_sorted(calls.begin(), calls.end()));
    EXPECT_GE(CallsBetween(calls, 0.701 * whole, 0.799 * whole), 2);
    EXPECT_GE(CallsBetween(calls, 0.801 * whole, 0.899 * whole), 2);
    EXPECT_GE(CallsBetween(calls, 0.901 * whole, 0.969 * whole), 2);
    EXPECT_GE(CallsBetween(calls, 1.001 * whole, isPore ? 0.349 : 0.499), 2);
    double last = 0.0;
    const auto stop = [&](double done)
    {
      last = done;
      return done < 0.701 * whole;
    };
    EXPECT_THROW(run(stop), Cancelled);
    EXPECT_LT(last, 0.799 * whole);
  }
}

namespace
{

/// Atoms anywhere in a cube of the same density: about seven tetrahedra for each.
std::vector<Ball> AtomsInACube(int count)
{
  std::mt19937 random(8);
  const double half = 1.85 * std::cbrt(count);
  std::uniform_real_distribution<double> place(-half, half);
  std::vector<Ball> atoms;
  for (int i = 0; i < count; ++i)
  {
    const double x = place(random), y = place(random), z = place(random);
    atoms.push_back({ { x, y, z }, 1.7 });
  }
  return atoms;
}

/// Enlarged as in Molecular Pockets and Pore Profile.
RegularFiltration BuildFiltration(const std::vector<Ball>& atoms)
{
  std::vector<Point3> centers;
  for (const Ball& atom : atoms)
  {
    centers.push_back(atom.Center);
  }
  return MakeRegularFiltration(centers, std::vector<double>(atoms.size(), 1.7 + 1.4));
}

using Analysis = std::function<void(const ProgressCallback&)>;

/// Reports of a run between two fractions, ends included.
std::int64_t ReportsBetween(double low, double high, const Analysis& run)
{
  std::int64_t reports = 0;
  double last = 0.0;
  run(
    [&](double done)
    {
      EXPECT_GE(done, last);
      last = done;
      reports += done >= low - 1e-9 && done <= high + 1e-9 ? 1 : 0;
      return true;
    });
  return reports;
}

/// Reports of a loop over that number of cells: one at every 4096th.
std::int64_t ComputeReports(std::size_t cells)
{
  return static_cast<std::int64_t>((cells + 4095) / 4096);
}

/// The report at which a run is aborted is the last.
void ExpectToStopAtEachReport(const Analysis& run)
{
  bool isAborted = true;
  for (int stop = 1; isAborted; ++stop)
  {
    int reports = 0;
    isAborted = false;
    try
    {
      run([&](double) { return ++reports < stop; });
    }
    catch (const Cancelled&)
    {
      isAborted = true;
    }
    EXPECT_EQ(isAborted, reports >= stop);
    EXPECT_LE(reports, stop);
  }
}

}

// So few atoms that each loop reports once.
TEST(PoreProfile, AnAbortIsNoticedInEachLoopOverCells)
{
  const auto atoms = AtomsInACube(24);
  PocketOptions options;
  const Analysis pockets = [&](const ProgressCallback& progress)
  { FindPockets(atoms, options, progress); };
  // Crevices; volumes of cells and of the union, shares of the hull, edges, triangles; burial,
  // lining, mouths. The others are reports at the ends of steps.
  EXPECT_EQ(ReportsBetween(0.8, 1.0, pockets), 9 + 4);
  ExpectToStopAtEachReport(pockets);

  std::vector<SiteAtom> siteAtoms(atoms.size());
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    siteAtoms[i].Place = atoms[i].Center;
  }
  options.SiteAtoms = &siteAtoms;
  // Their crevices; atoms around, cells around, probabilities.
  EXPECT_EQ(ReportsBetween(0.8, 1.0, pockets), 9 + 4 + 4);
  ExpectToStopAtEachReport(pockets);

  ExpectToStopAtEachReport(
    [&](const ProgressCallback& progress) { FindPores(atoms, {}, progress); });
  ExpectToStopAtEachReport(
    [&](const ProgressCallback& progress) {
      PoreBetween(atoms, { -6.0, -6.0, -6.0 }, { 6.0, 6.0, 6.0 }, {}, progress);
    });
}

TEST(PoreProfile, LoopsOverCellsReportAtEvery4096th)
{
  const auto atoms = AtomsInACube(2500);
  RegularFiltration f = BuildFiltration(atoms);
  const CellFiltration& c = f.Complex;
  const std::int64_t cells = ComputeReports(c.Tetrahedra.size());
  const std::int64_t triangles = ComputeReports(c.TriangleCount());
  ASSERT_GE(cells, 3);

  PocketOptions options;
  options.InnerRadius = 2.0; // half of the cells are cores, half crevices
  options.OuterRadius = 9.0;
  options.MinimumVolume = 0.0;
  std::size_t inPockets = 0;
  const Analysis pockets = [&](const ProgressCallback& progress)
  {
    inPockets = 0;
    for (const Pocket& pocket : FindPockets(atoms, options, progress).Pockets)
    {
      inPockets += pocket.Cells.size();
    }
  };
  // Including the reports at the ends of steps. In parallel loops, such as those before and
  // between, reports depend on the time.
  const std::int64_t measures = 2 * cells + ComputeReports(c.Edges.size()) + triangles;
  const std::int64_t before = ReportsBetween(0.8, 0.85, pockets);
  EXPECT_EQ(before, 1 + ComputeReports(inPockets) + cells + measures + 1);
  EXPECT_EQ(ReportsBetween(0.92, 1.0, pockets), 1 + cells + triangles + 2);

  const auto faces = FacesOfCells(c);
  CellAccessibility access;
  EXPECT_EQ(
    ReportsBetween(0.0, 1.0,
      [&](const ProgressCallback& progress) { access = FindAccess(f, faces, 1.4, progress); }),
    cells);
  PoreOptions pores;
  const Analysis path = [&](const ProgressCallback& progress) {
    PathBetween(f, faces, access, { -24.0, -24.0, -24.0 }, { 24.0, 24.0, 24.0 }, pores, progress);
  };
  pores.MaximumOffset = 100.0;
  EXPECT_GE(ReportsBetween(0.0, 1.0, path), 2);
  const Analysis channels = [&](const ProgressCallback& progress)
  { FindChannels(f, access, 1.4, pores, progress); };
  pores.MinimumRadius = 100.0; // none
  const std::int64_t none = ReportsBetween(0.9, 1.0, channels);
  EXPECT_EQ(none, triangles);
  pores.MinimumRadius = 1.0; // one more report for each possible one
  EXPECT_GT(ReportsBetween(0.9, 1.0, channels), none);
}

// The event at which the run is aborted is the last.
TEST(PoreProfile, AnAbortLeavesAnEmptyOutput)
{
  const auto atoms = MakeAtoms(AtomsInACube(24));
  bool isAborted = true;
  for (int stop = 1; isAborted; ++stop)
  {
    SCOPED_TRACE(stop);
    vtkNew<vtkPoreProfile> filter;
    filter->SetInputData(atoms);
    struct WatchState
    {
      int Stop, Events;
    } watched{ stop, 0 };
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(&watched);
    watch->SetCallback(
      [](vtkObject* caller, unsigned long, void* client, void*)
      {
        auto* const running = static_cast<vtkAlgorithm*>(caller);
        auto* const seen = static_cast<WatchState*>(client);
        if (running->GetProgress() > 0.0 && running->GetProgress() < 1.0 &&
          ++seen->Events >= seen->Stop)
        {
          running->SetAbortExecute(1);
        }
      });
    filter->AddObserver(vtkCommand::ProgressEvent, watch);
    filter->Update();
    isAborted = watched.Events >= stop;
    EXPECT_LE(watched.Events, stop);
    for (int port = 0; isAborted && port < filter->GetNumberOfOutputPorts(); ++port)
    {
      vtkDataObject* const output = filter->GetOutputDataObject(port);
      EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::POINT), 0) << port;
      EXPECT_EQ(output->GetNumberOfElements(vtkDataObject::ROW), 0) << port;
    }
  }
}
