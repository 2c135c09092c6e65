// Bridges and windows of shapes known by hand, the seven-fold groups of GroEL, stable levels, bad
// input.

#include "vtkMapHandles.h"

#include "AddressSpaceLimit.h"
#include "SharedData.h"
#include "vtkMRCMapReader.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>
#include <vtkTestErrorObserver.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <string>
#include <vector>

namespace
{

constexpr double Pi = 3.14159265358979323846;
using Place = std::array<double, 3>;

template <typename Function>
vtkSmartPointer<vtkImageData> Image(int n, Function&& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetOrigin(-0.5 * (n - 1), -0.5 * (n - 1), -0.5 * (n - 1));
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    values->InsertNextValue(static_cast<float>(f(p[0], p[1], p[2])));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// `beads` Gaussians on a circle of radius 10 round z.
double Necklace(int beads, double x, double y, double z)
{
  double sum = 0.0;
  for (int i = 0; i < beads; ++i)
  {
    const double a = 2.0 * Pi * i / beads + 0.2;
    const double dx = x - 10.0 * std::cos(a);
    const double dy = y - 10.0 * std::sin(a);
    sum += std::exp(-(dx * dx + dy * dy + z * z) / 18.0);
  }
  return sum;
}

double At(vtkDataSetAttributes* data, const char* name, vtkIdType i)
{
  auto* array = data->GetArray(name);
  EXPECT_NE(array, nullptr) << name;
  return array ? array->GetComponent(i, 0) : std::nan("");
}

double Fact(vtkDataObject* output, const char* name)
{
  auto* array = output->GetFieldData()->GetArray(name);
  return array ? array->GetComponent(0, 0) : std::nan("");
}

vtkPolyData* Points(vtkMapHandles* filter, int port)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(port));
}

vtkTable* Table(vtkMapHandles* filter, int port)
{
  return vtkTable::SafeDownCast(filter->GetOutputDataObject(port));
}

}

TEST(MapHandles, NecklaceHasABridgeForEachPairOfBeads)
{
  const auto image = Image(41, [](double x, double y, double z) { return Necklace(7, x, y, z); });
  vtkNew<vtkMapHandles> filter;
  filter->SetInputData(image);
  filter->SetMinimumPersistence(0.2);
  filter->SetRange(0.001, 1.1); // the window in the middle closes below the mean
  filter->Update();
  // Seven bridges at one level: six join components, one closes the ring.
  vtkPolyData* bridges = Points(filter, 0);
  ASSERT_EQ(bridges->GetNumberOfPoints(), 7);
  int joining = 0;
  for (vtkIdType i = 0; i < 7; ++i)
  {
    joining += At(bridges->GetPointData(), "Dimension", i) == 0.0;
    const double level = At(bridges->GetPointData(), "Level", i);
    EXPECT_NEAR(level, Necklace(7, 10.0 * std::cos(Pi / 7), 10.0 * std::sin(Pi / 7), 0.0), 0.25);
    EXPECT_EQ(At(bridges->GetPointData(), "To", i), level);
    const double* p = bridges->GetPoint(i);
    EXPECT_NEAR(std::hypot(p[0], p[1]), 9.0, 1.5);
    EXPECT_NEAR(p[2], 0.0, 0.8);
  }
  EXPECT_EQ(joining, 6);
  // The ring's window is in the middle.
  vtkPolyData* windows = Points(filter, 1);
  ASSERT_EQ(windows->GetNumberOfPoints(), 1);
  EXPECT_LT(std::hypot(windows->GetPoint(0)[0], windows->GetPoint(0)[1]), 2.0);
  // Stable intervals: between events, longest first, with the features that exist in each.
  vtkTable* intervals = Table(filter, 3);
  ASSERT_GE(intervals->GetNumberOfRows(), 2);
  bool ring = false;
  bool beads = false;
  for (vtkIdType i = 0; i < intervals->GetNumberOfRows(); ++i)
  {
    const double b0 = At(intervals->GetRowData(), "Beta0", i);
    const double b1 = At(intervals->GetRowData(), "Beta1", i);
    ring = ring || (b0 == 1.0 && b1 == 1.0);
    beads = beads || (b0 == 7.0 && b1 == 0.0);
    EXPECT_TRUE(i == 0 ||
      At(intervals->GetRowData(), "Length", i) <= At(intervals->GetRowData(), "Length", i - 1));
  }
  EXPECT_TRUE(ring && beads);
  EXPECT_EQ(filter->GetStableLevel(), At(intervals->GetRowData(), "Middle", 0));
  EXPECT_EQ(Fact(bridges, "StableLevel"), filter->GetStableLevel());
}

TEST(MapHandles, ContourAndLoopsAtTheLevelChosen)
{
  const auto image = Image(31, [](double x, double y, double z) { return Necklace(5, x, y, z); });
  vtkNew<vtkMapHandles> filter;
  filter->SetInputData(image);
  filter->SetLevel(0.2);
  vtkNew<vtkDoubleArray> recommended;
  recommended->SetName("RecommendedLevel");
  recommended->InsertNextValue(0.5);
  image->GetFieldData()->AddArray(recommended);
  filter->LoopsOn();
  filter->Update();
  vtkPolyData* contour = Points(filter, 4);
  ASSERT_GT(contour->GetNumberOfPolys(), 100);
  for (vtkIdType i = 0; i < contour->GetNumberOfPoints(); i += 17)
  {
    const double* p = contour->GetPoint(i);
    EXPECT_NEAR(Necklace(5, p[0], p[1], p[2]), 0.2, 0.02);
  }
  EXPECT_EQ(Fact(contour, "Level"), 0.2);
  EXPECT_EQ(Fact(contour, "RecommendedLevel"), 0.5);
  // A ring of five beads: one handle, at the narrowest of the five necks, one tunnel, and by
  // symmetry nothing but the other necks.
  std::array<int, 3> kinds{ 0, 0, 0 };
  for (vtkIdType i = 0; i < Points(filter, 6)->GetNumberOfPoints(); ++i)
  {
    ++kinds[static_cast<std::size_t>(At(Points(filter, 6)->GetPointData(), "Kind", i))];
  }
  EXPECT_EQ(kinds, (std::array<int, 3>{ 1, 1, 4 }));
  // Each mark of the chart is in one row.
  vtkTable* levels = Table(filter, 2);
  int marks = 0;
  for (vtkIdType i = 0; i < levels->GetNumberOfRows(); ++i)
  {
    if (!std::isnan(At(levels->GetRowData(), "RecommendedLevel", i)))
    {
      EXPECT_NEAR(At(levels->GetRowData(), "Level", i), 0.5, 0.01);
      ++marks;
    }
  }
  EXPECT_EQ(marks, 1);
}

TEST(MapHandles, SevenFoldGroupsOfGroEL)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/emd_5043.map");
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(
    (isthmus::testing::SharedDataFolder() / "maps/emd_5043.map").string().c_str());
  vtkNew<vtkMapHandles> filter;
  filter->SetInputConnection(reader->GetOutputPort());
  filter->SetMinimumPersistence(0.45);
  filter->Update();
  vtkPolyData* bridges = Points(filter, 0);
  auto* image = reader->GetOutput();
  const double* h = image->GetSpacing();
  double center[3];
  image->GetCenter(center);
  // density from, density to, number
  const double groups[5][3] = { { 5.38, 5.53, 14 }, { 3.42, 3.57, 14 }, { 2.96, 3.13, 7 },
    { 2.22, 2.31, 14 }, { 0.78, 0.965, 7 } };
  for (const auto& group : groups)
  {
    std::vector<Place> places;
    for (vtkIdType i = 0; i < bridges->GetNumberOfPoints(); ++i)
    {
      const double level = At(bridges->GetPointData(), "Level", i);
      if (level >= group[0] && level <= group[1])
      {
        const double* p = bridges->GetPoint(i);
        places.push_back({ p[0], p[1], p[2] });
      }
    }
    EXPECT_EQ(places.size(), static_cast<std::size_t>(group[2])) << group[0];
    // Turned by a seventh about y, each lies on another of the group.
    for (const Place& p : places)
    {
      const double a = 2.0 * Pi / 7.0;
      const double x = p[0] - center[0];
      const double z = p[2] - center[2];
      const Place turned{ center[0] + x * std::cos(a) - z * std::sin(a), p[1],
        center[2] + x * std::sin(a) + z * std::cos(a) };
      double nearest = std::numeric_limits<double>::infinity();
      for (const Place& q : places)
      {
        nearest =
          std::min(nearest, std::hypot(turned[0] - q[0], turned[1] - q[1], turned[2] - q[2]));
      }
      EXPECT_LT(nearest / h[0], 2.0) << group[0];
    }
  }
  // Among the longest stable intervals is the one round the authors' level, with 36 tunnels.
  vtkTable* intervals = Table(filter, 3);
  bool found = false;
  for (vtkIdType i = 0; i < std::min<vtkIdType>(3, intervals->GetNumberOfRows()); ++i)
  {
    found = found ||
      (At(intervals->GetRowData(), "From", i) < 1.5 && At(intervals->GetRowData(), "To", i) > 1.5 &&
        At(intervals->GetRowData(), "Beta1", i) == 36.0);
  }
  EXPECT_TRUE(found);
}

TEST(MapHandles, AxesAndShiftsOfGroELChangeNoBridge)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/emd_5043.map");
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(
    (isthmus::testing::SharedDataFolder() / "maps/emd_5043.map").string().c_str());
  reader->Update();
  // Level, then the position in nodes of the unchanged map.
  using Bridge = std::array<double, 4>;
  const auto bridgesOf = [](vtkImageData* image, const std::array<int, 3>& axis, const Place& zero)
  {
    vtkNew<vtkMapHandles> filter;
    filter->SetInputData(image);
    filter->SetMinimumPersistence(0.45);
    filter->Update();
    std::vector<Bridge> bridges;
    vtkPolyData* points = Points(filter, 0);
    for (vtkIdType i = 0; i < points->GetNumberOfPoints(); ++i)
    {
      Bridge bridge{ At(points->GetPointData(), "Level", i), 0.0, 0.0, 0.0 };
      for (std::size_t a = 0; a < 3; ++a)
      {
        const auto place = static_cast<std::size_t>(axis[a]);
        bridge[1 + place] = std::round((points->GetPoint(i)[a] - zero[a]) / image->GetSpacing()[a]);
      }
      bridges.push_back(bridge);
    }
    std::sort(bridges.begin(), bridges.end());
    return bridges;
  };
  vtkNew<vtkImageData> image;
  image->ShallowCopy(reader->GetOutput());
  image->SetOrigin(0.0, 0.0, 0.0);
  const std::vector<Bridge> bridges = bridgesOf(image, { 0, 1, 2 }, { 0.0, 0.0, 0.0 });
  EXPECT_GE(bridges.size(), 56u);
  // Shifted by whole nodes through the extent.
  vtkNew<vtkImageData> moved;
  moved->ShallowCopy(image);
  moved->SetExtent(7, 106, -3, 96, 11, 110);
  const double* h = moved->GetSpacing();
  EXPECT_EQ(bridgesOf(moved, { 0, 1, 2 }, { 7.0 * h[0], -3.0 * h[1], 11.0 * h[2] }), bridges);
  // z, x, y as x, y, z.
  vtkNew<vtkImageData> turned;
  turned->SetDimensions(100, 100, 100);
  turned->SetSpacing(h[2], h[0], h[1]);
  turned->AllocateScalars(VTK_FLOAT, 1);
  for (int k = 0; k < 100; ++k)
  {
    for (int j = 0; j < 100; ++j)
    {
      for (int i = 0; i < 100; ++i)
      {
        turned->SetScalarComponentFromDouble(
          i, j, k, 0, image->GetScalarComponentAsDouble(j, k, i, 0));
      }
    }
  }
  EXPECT_EQ(bridgesOf(turned, { 2, 0, 1 }, { 0.0, 0.0, 0.0 }), bridges);
}

TEST(MapHandles, ReportsBadInput)
{
  vtkNew<vtkMapHandles> filter;
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<vtkTest::ErrorObserver> pipeline;
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->AddObserver(vtkCommand::WarningEvent, observer);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, pipeline);
  const auto said = [&]()
  {
    observer->Clear();
    filter->Modified();
    filter->Update();
    EXPECT_EQ(Points(filter, 4)->GetNumberOfPoints() == 0, observer->GetError());
    return observer->GetErrorMessage();
  };
  const auto image = Image(21, [](double x, double y, double z) { return Necklace(5, x, y, z); });
  filter->SetInputData(image);
  EXPECT_EQ(said(), "");
  filter->SetMinimumPersistence(std::nan(""));
  EXPECT_NE(said().find("MinimumPersistence is not a number"), std::string::npos);
  filter->SetMinimumPersistence(0.5);
  filter->SetRange(2.0, 1.0);
  EXPECT_NE(said().find("Range goes from 2"), std::string::npos);
  filter->SetRange(50.0, 60.0);
  EXPECT_EQ(said(), "");
  EXPECT_NE(observer->GetWarningMessage().find("no stable level"), std::string::npos);
  EXPECT_TRUE(std::isnan(filter->GetStableLevel()));
  filter->AutomaticRangeOn();
  filter->SetLevel(std::nan(""));
  EXPECT_NE(said().find("Level is not a number"), std::string::npos);
  filter->SetLevel(0.5);
  filter->SetNumberOfLevels(0);
  EXPECT_NE(said().find("NumberOfLevels is 0"), std::string::npos);
  filter->SetNumberOfLevels(64);
  EXPECT_EQ(said(), "");
  image->GetPointData()->GetScalars()->SetComponent(22, 0, std::nan(""));
  image->GetPointData()->GetScalars()->Modified();
  EXPECT_NE(said().find("node (1, 1, 0) is not a number"), std::string::npos);
  filter->SetInputData(Image(5, [](double, double, double) { return 1.0; }));
  EXPECT_NE(said().find("same value everywhere"), std::string::npos);
  observer->Clear();
  filter->SetInputData(vtkNew<vtkImageData>());
  filter->Update();
  EXPECT_FALSE(observer->GetError());
}

namespace
{

/// Noise of standard deviation 1, correlated over a few nodes.
std::vector<float> SmoothNoise(const std::array<int, 3>& n, unsigned seed)
{
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<double> values(static_cast<std::size_t>(n[0] * n[1] * n[2]));
  std::generate(values.begin(), values.end(), [&] { return normal(random); });
  const std::array<int, 3> steps{ 1, n[0], n[0] * n[1] };
  double squares = 0.0;
  for (const int step : steps)
  {
    const auto before = values;
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      const std::size_t next = (i + static_cast<std::size_t>(step)) % values.size();
      const std::size_t last = (i + values.size() - static_cast<std::size_t>(step)) % values.size();
      values[i] = before[last] + 2.0 * before[i] + before[next];
    }
  }
  for (const double value : values)
  {
    squares += value * value;
  }
  const double deviation = std::sqrt(squares / static_cast<double>(values.size()));
  std::vector<float> result;
  for (const double value : values)
  {
    result.push_back(static_cast<float>(value / deviation));
  }
  return result;
}

/// Three balls in a row, a rod of density 1 between the first two, a gap with `gap` between the
/// others, and noise whose mean over two halves has a deviation of 0.1.
vtkSmartPointer<vtkImageData> HalfMap(double gap, unsigned seed)
{
  const std::array<int, 3> n{ 56, 20, 20 };
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n.data());
  image->SetOrigin(-27.5, -9.5, -9.5);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  const auto noise = SmoothNoise(n, seed);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double across = std::hypot(p[1], p[2]);
    double density = 0.0;
    for (const double x : { -18.0, 0.0, 18.0 })
    {
      density =
        std::max(density, 1.6 / (1.0 + std::exp(2.0 * (std::hypot(p[0] - x, across) - 6.0))));
    }
    const double rod = 1.0 / (1.0 + std::exp(2.0 * (across - 3.0)));
    density = std::max(density, std::abs(p[0] + 9.0) < 9.0 ? rod : 0.0);
    density = std::max(density, std::abs(p[0] - 9.0) < 9.0 ? gap * rod : 0.0);
    values->InsertNextValue(
      static_cast<float>(density + 0.1 * std::sqrt(2.0) * noise[static_cast<std::size_t>(i)]));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

/// The smallest p-value of bridges between two x; 2 without any.
double BestPValue(vtkPolyData* bridges, double low, double high)
{
  double best = 2.0;
  for (vtkIdType i = 0; i < bridges->GetNumberOfPoints(); ++i)
  {
    const double x = bridges->GetPoint(i)[0];
    if (x > low && x < high)
    {
      best = std::min(best, At(bridges->GetPointData(), "PValue", i));
    }
  }
  return best;
}

vtkSmartPointer<vtkMapHandles> MakeBootstrap(unsigned seed, int resamples)
{
  auto filter = vtkSmartPointer<vtkMapHandles>::New();
  filter->SetInputData(HalfMap(0.5, 2 * seed));
  filter->SetOtherHalfData(HalfMap(0.5, 2 * seed + 1));
  filter->SetLevel(0.5);
  filter->SetMinimumPersistence(0.3);
  filter->SetNumberOfResamples(resamples);
  return filter;
}

}

TEST(MapHandles, BootstrapSeparatesABridgeFromNoise)
{
  int noiseBridges = 0, wrong = 0;
  for (unsigned seed = 1; seed <= 12; ++seed)
  {
    const auto filter = MakeBootstrap(seed, 40);
    filter->Update();
    const double rod = BestPValue(Points(filter, 0), -15.0, -3.0);
    const double gap = BestPValue(Points(filter, 0), 3.0, 15.0);
    EXPECT_LT(rod, 0.05) << "seed " << seed;
    noiseBridges += gap < 1.0 ? 1 : 0;
    wrong += gap < 0.05 ? 1 : 0;
  }
  EXPECT_GE(noiseBridges, 4); // otherwise nothing was tested
  EXPECT_LE(wrong, 1);
}

/// Means and resamples were of type float.
TEST(MapHandles, HalfMapsOfWideIntegersAreNotRounded)
{
  const auto bridges = [](bool whole)
  {
    const auto half = [&](unsigned seed)
    {
      auto image = HalfMap(0.5, seed);
      vtkDataArray* const from = image->GetPointData()->GetScalars();
      vtkSmartPointer<vtkDataArray> to;
      to.TakeReference(vtkDataArray::CreateDataArray(whole ? VTK_INT : VTK_DOUBLE));
      to->SetNumberOfTuples(from->GetNumberOfTuples());
      for (vtkIdType n = 0; n < from->GetNumberOfTuples(); ++n)
      {
        to->SetComponent(n, 0, 1e9 + std::round(100.0 * from->GetComponent(n, 0)));
      }
      image->GetPointData()->SetScalars(to);
      return image;
    };
    auto filter = vtkSmartPointer<vtkMapHandles>::New();
    filter->SetInputData(half(2));
    filter->SetOtherHalfData(half(3));
    filter->SetLevel(1e9 + 50.25);
    filter->SetMinimumPersistence(0.3);
    filter->SetNumberOfResamples(20);
    filter->Update();
    return filter;
  };
  const auto found = bridges(true), expected = bridges(false);
  ASSERT_GT(Points(expected, 0)->GetNumberOfPoints(), 0);
  ASSERT_EQ(Points(found, 0)->GetNumberOfPoints(), Points(expected, 0)->GetNumberOfPoints());
  EXPECT_LT(BestPValue(Points(expected, 0), -15.0, -3.0), 0.1); // the rod
  EXPECT_EQ(
    BestPValue(Points(found, 0), -15.0, -3.0), BestPValue(Points(expected, 0), -15.0, -3.0));
  EXPECT_EQ(Points(found, 4)->GetNumberOfPoints(), Points(expected, 4)->GetNumberOfPoints());
}

TEST(MapHandles, BootstrapIsReproducible)
{
  std::vector<double> first;
  for (const int seed : { 1, 1, 7 })
  {
    const auto filter = MakeBootstrap(3, 10);
    filter->SetSeed(seed);
    filter->Update();
    std::vector<double> values;
    for (const int port : { 0, 1 })
    {
      vtkPolyData* handles = Points(filter, port);
      for (vtkIdType i = 0; i < handles->GetNumberOfPoints(); ++i)
      {
        const double support = At(handles->GetPointData(), "BootstrapSupport", i);
        EXPECT_TRUE(support >= 0.0 && support <= 1.0);
        values.push_back(support);
        values.push_back(At(handles->GetPointData(), "PValue", i));
        if (At(handles->GetPointData(), "IsThere", i) == 0.0)
        {
          EXPECT_EQ(values.back(), 1.0);
        }
      }
    }
    ASSERT_FALSE(values.empty());
    if (first.empty())
    {
      first = values;
    }
    EXPECT_EQ(values == first, seed == 1);
  }
}

TEST(MapHandles, HalfMapsThatDoNotFit)
{
  vtkNew<vtkMapHandles> one;
  one->SetInputData(HalfMap(0.5, 1));
  one->Update();
  EXPECT_EQ(Points(one, 0)->GetPointData()->GetArray("PValue"), nullptr);
  const auto moved = HalfMap(0.5, 2);
  moved->SetOrigin(-27.0, -9.5, -9.5);
  const std::array<vtkSmartPointer<vtkImageData>, 2> others{ HalfMap(0.5, 1), moved };
  const std::array<std::string, 2> words{ "are equal", "do not have the same nodes" };
  for (std::size_t i = 0; i < 2; ++i)
  {
    vtkNew<vtkMapHandles> filter;
    vtkNew<vtkTest::ErrorObserver> errors;
    filter->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
    filter->SetInputData(HalfMap(0.5, 1));
    filter->SetOtherHalfData(others[i]);
    filter->Update();
    EXPECT_NE(errors->GetErrorMessage().find(words[i]), std::string::npos)
      << errors->GetErrorMessage();
    EXPECT_EQ(Points(filter, 0)->GetNumberOfPoints(), 0);
  }
}

TEST(MapHandles, RefusesHalfMapsThatDoNotFitIntoMemory)
{
  const auto half = [](double sign)
  {
    return Image(128,
      [sign](double x, double y, double z)
      { return Necklace(5, x, y, z) + sign * 0.05 * std::sin(0.4 * x); });
  };
  vtkNew<vtkMapHandles> filter;
  vtkNew<vtkTest::ErrorObserver> errors;
  filter->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->GetExecutive()->AddObserver(vtkCommand::ErrorEvent, errors);
  filter->SetInputData(half(1.0));
  filter->SetOtherHalfData(half(-1.0));
  {
    const isthmus::testing::AddressSpaceLimit limit(48); // the persistence of one needs 10 MiB
    filter->Update();
  }
  const std::string said = errors->GetErrorMessage();
  for (const char* words : { "The persistence of 128 x 128 x 128 values needs about 8",
         " MiB are available: ", "crop", "SampleRate" })
  {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
  EXPECT_EQ(Points(filter, 0)->GetNumberOfPoints(), 0);
}

TEST(MapHandles, WarnsAboutUnrelatedHalfMaps)
{
  const auto correlationOf = [](vtkImageData* one, vtkImageData* other, std::string& said)
  {
    vtkNew<vtkMapHandles> filter;
    vtkNew<vtkTest::ErrorObserver> messages;
    filter->AddObserver(vtkCommand::WarningEvent, messages);
    filter->SetInputData(one);
    filter->SetOtherHalfData(other);
    filter->SetLevel(0.5);
    filter->SetNumberOfResamples(2);
    filter->Update();
    said = messages->GetWarning() ? messages->GetWarningMessage() : std::string();
    vtkDataArray* found = Points(filter, 0)->GetFieldData()->GetArray("HalfMapCorrelation");
    return found ? found->GetTuple1(0) : -2.0;
  };
  std::string said;
  const auto one = HalfMap(0.5, 1), other = HalfMap(0.5, 2);
  EXPECT_GT(correlationOf(one, other, said), 0.9);
  EXPECT_EQ(said, "");
  // The same noise alone, around another mean: a common offset is not a common signal.
  const std::array<vtkSmartPointer<vtkImageData>, 2> noises{ HalfMap(0.5, 3), HalfMap(0.5, 4) };
  for (std::size_t i = 0; i < 2; ++i)
  {
    const auto noise = SmoothNoise({ 56, 20, 20 }, static_cast<unsigned>(3 + i));
    vtkDataArray* values = noises[i]->GetPointData()->GetScalars();
    for (vtkIdType node = 0; node < values->GetNumberOfTuples(); ++node)
    {
      values->SetTuple1(node, 5.0 + noise[static_cast<std::size_t>(node)]);
    }
  }
  const double correlation = correlationOf(noises[0], noises[1], said);
  EXPECT_NEAR(correlation, 0.0, 0.1);
  EXPECT_NE(said.find("do not share a signal"), std::string::npos) << said;
  // Outside of a mask both are 0, inside they have a mean: that is not a common signal either.
  for (vtkIdType node = 0; node < noises[0]->GetNumberOfPoints(); ++node)
  {
    if (node % 56 < 28)
    {
      noises[0]->GetPointData()->GetScalars()->SetTuple1(node, 0.0);
      noises[1]->GetPointData()->GetScalars()->SetTuple1(node, 0.0);
    }
  }
  EXPECT_NEAR(correlationOf(noises[0], noises[1], said), 0.0, 0.15);
}
