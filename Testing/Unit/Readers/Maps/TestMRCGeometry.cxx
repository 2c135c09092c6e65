// Where nodes lie in the world: axis order, ORIGIN and NSTART, skew, oblique cells, stacks.

#include "MRCTestFile.h"
#include "MRCTestReading.h"
#include "SharedData.h"

#include <vtkDataArray.h>
#include <vtkMatrix3x3.h>

#include <gtest/gtest.h>

#include <array>

namespace
{

using namespace isthmus::testing;
using Point = std::array<double, 3>;

Point MakeWorldTransform(vtkImageData* image, int i, int j, int k)
{
  Point world{};
  image->TransformIndexToPhysicalPoint(i, j, k, world.data());
  return world;
}

void ExpectNear(const Point& found, const Point& expected, double tolerance = 1e-5)
{
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(found[i], expected[i], tolerance) << "component " << i;
  }
}

MRCTestFile Ramp(std::array<int, 3> counts, std::array<int, 3> order)
{
  MRCTestFile map(counts, 2);
  map.SetInts(17, order);
  map.SetInts(8, { 10, 20, 40 });
  map.SetFloats(11, { 20.0f, 60.0f, 160.0f }); // spacing 2, 3, 4
  return map;
}

TEST(MRCGeometry, StartIsPermutedAndOriginIsNot)
{
  // Columns run along z, rows along x, sections along y.
  MRCTestFile map = Ramp({ 3, 4, 5 }, { 3, 1, 2 });
  map.SetInts(5, { 7, 8, 9 });
  map.AddVoxels([](int c, int r, int s, int) { return 100 * c + 10 * r + s; });
  const TemporaryFile byStart(map.Bytes());
  MRCTestReading reading(byStart.Path());
  vtkImageData* image = reading.Update();
  ExpectNear(MakeWorldTransform(image, 0, 0, 0), { 8 * 2.0, 9 * 3.0, 7 * 4.0 });
  ExpectNear(MakeWorldTransform(image, 3, 4, 2), { 11 * 2.0, 13 * 3.0, 9 * 4.0 });
  EXPECT_EQ(reading.At(3, 4, 2), 234.0);
  EXPECT_EQ(image->GetExtent()[0], 0);

  map.SetFloats(50, { 0.0f, -5.5f, 0.0f });
  const TemporaryFile byOrigin(map.Bytes());
  reading->SetFileName(byOrigin.Path());
  image = reading.Update();
  ExpectNear(MakeWorldTransform(image, 0, 0, 0), { 0.0, -5.5, 0.0 });
}

TEST(MRCGeometry, OriginOfRoundingsIsNotStated)
{
  const struct
  {
    float Origin;
    double First;
  } rows[] = { { 1e-9f, 14.0 }, { -1e-5f, 14.0 }, { -1e-38f, 14.0 }, { 0.001f, 0.001 },
    { -0.5f, -0.5 } };
  for (const auto& row : rows)
  {
    MRCTestFile map = Ramp({ 3, 4, 5 }, { 1, 2, 3 });
    map.SetInts(5, { 7, 8, 9 });
    map.SetFloats(50, { row.Origin, 0.0f, 0.0f });
    map.AddVoxels([](int c, int r, int s, int) { return 100 * c + 10 * r + s; });
    const TemporaryFile file(map.Bytes());
    MRCTestReading reading(file.Path());
    EXPECT_NEAR(MakeWorldTransform(reading.Update(), 0, 0, 0)[0], row.First, 1e-6) << row.Origin;
    EXPECT_EQ(reading.Warning(), "");
  }
}

TEST(MRCGeometry, SpacingBelowThatOfMapsIsNoted)
{
  // The cell of one voxel of 1.5 angstrom; nanometres; a fine X-ray map.
  const struct
  {
    std::array<float, 3> Cell;
    bool Noted;
  } rows[] = { { { 0.15f, 0.15f, 0.15f }, true }, { { 20.0f, 60.0f, 1.2f }, true },
    { { 3.0f, 6.0f, 12.0f }, false } };
  for (const auto& row : rows)
  {
    MRCTestFile map = Ramp({ 3, 4, 5 }, { 1, 2, 3 });
    map.SetFloats(11, { row.Cell[0], row.Cell[1], row.Cell[2] });
    map.AddVoxels([](int c, int r, int s, int) { return 100 * c + 10 * r + s; });
    const TemporaryFile file(map.Bytes());
    MRCTestReading reading(file.Path());
    reading.Update();
    EXPECT_EQ(reading.Warning().find("may be that of one voxel") != std::string::npos, row.Noted)
      << reading.Warning();
  }
}

TEST(MRCGeometry, SkewTransformationComesOnTop)
{
  MRCTestFile map = Ramp({ 3, 4, 5 }, { 1, 2, 3 });
  map.SetInts(5, { 1, 2, 3 });
  map.SetInt(25, 1);
  // x_map = S (x_world - t), S a quarter turn about z: (x, y) -> (-y, x).
  map.SetFloats(26, { 0.0f, -1.0f, 0.0f });
  map.SetFloats(29, { 1.0f, 0.0f, 0.0f });
  map.SetFloats(32, { 0.0f, 0.0f, 1.0f });
  map.SetFloats(35, { 100.0f, 200.0f, 300.0f });
  map.AddVoxels([](int c, int, int, int) { return c; });
  const TemporaryFile file(map.Bytes());
  MRCTestReading reading(file.Path());
  vtkImageData* const image = reading.Update();
  EXPECT_EQ(reading.Warning(), "");
  // Node 0 is (2, 6, 12) in the map's frame; x_world = S^-1 x_map + t.
  ExpectNear(MakeWorldTransform(image, 0, 0, 0), { 106.0, 198.0, 312.0 });
  ExpectNear(MakeWorldTransform(image, 1, 0, 0), { 106.0, 196.0, 312.0 });
  ExpectNear(MakeWorldTransform(image, 0, 1, 1), { 109.0, 198.0, 316.0 });
}

TEST(MRCGeometry, SharedMapsOfWaterHaveTheirPublishedPlaces)
{
  const std::pair<const char*, Point> places[] = { { "h2o-elf-nstart.ccp4", { 0.6, 0.45, 0.75 } },
    { "h2o-elf-nstart-origin.mrc", { 1.2, 3.4, 5.6 } },
    { "h2o-elf-nstart-skwtrn.ccp4", { 1.8, 3.85, 6.35 } } };
  for (const auto& [name, place] : places)
  {
    ISTHMUS_NEEDS_SHARED_DATA(std::string("maps/") + name);
    MRCTestReading reading((SharedDataFolder() / "maps" / name).c_str());
    ExpectNear(MakeWorldTransform(reading.Update(), 0, 0, 0), place);
  }
}

/// Steps of the monoclinic and triclinic cells below, computed here independently from the angles.
struct Cell
{
  std::array<float, 3> Angles;
  Point StepA;
  Point StepB;
  Point StepC;
};

Cell MakeCell(float alpha, float beta, float gamma)
{
  const auto cosine = [](float angle) { return std::cos(static_cast<double>(angle) * M_PI / 180); };
  const auto sine = [](float angle) { return std::sin(static_cast<double>(angle) * M_PI / 180); };
  // c from its angles with a and b; lengths 2, 3, 4.
  const double cx = cosine(beta);
  const double cy = (cosine(alpha) - cx * cosine(gamma)) / sine(gamma);
  return { { alpha, beta, gamma }, { 2, 0, 0 }, { 3 * cosine(gamma), 3 * sine(gamma), 0 },
    { 4 * cx, 4 * cy, 4 * std::sqrt(1 - cx * cx - cy * cy) } };
}

/// A linear function of position, which trilinear interpolation reproduces.
double Linear(const Point& p)
{
  return 0.5 * p[0] - 0.25 * p[1] + 0.125 * p[2] + 3.0;
}

class ObliqueCell : public ::testing::TestWithParam<std::array<float, 3>>
{
};

TEST_P(ObliqueCell, ResampledValuesMatchTheWorld)
{
  const Cell cell = MakeCell(GetParam()[0], GetParam()[1], GetParam()[2]);
  const auto place = [&cell](double i, double j, double k)
  {
    Point p{};
    for (std::size_t n = 0; n < 3; ++n)
    {
      p[n] = i * cell.StepA[n] + j * cell.StepB[n] + k * cell.StepC[n];
    }
    return p;
  };
  MRCTestFile map = Ramp({ 9, 8, 7 }, { 2, 1, 3 });
  map.SetFloats(14, cell.Angles);
  map.SetInts(5, { 1, -2, 3 });
  // Columns run along b, rows along a; the start is (-2, 1, 3) along a, b, c.
  map.AddVoxels([&](int c, int r, int s, int) { return Linear(place(r - 2, c + 1, s + 3)); });
  const TemporaryFile file(map.Bytes());
  MRCTestReading reading(file.Path());
  vtkImageData* const image = reading.Update();
  ASSERT_FALSE(reading.HasFailed()) << reading.Error();
  EXPECT_NE(reading.Warning().find("resampled"), std::string::npos);
  EXPECT_NE(reading.Text("Notes").find("resampled"), std::string::npos);
  vtkDataArray* const density = image->GetPointData()->GetArray("Density");
  vtkDataArray* const inside = image->GetPointData()->GetArray("InsideMap");
  ASSERT_NE(inside, nullptr);
  vtkIdType within = 0;
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    Point p{};
    image->GetPoint(id, p.data());
    const bool in = inside->GetComponent(id, 0) == 1.0;
    within += in;
    EXPECT_NEAR(density->GetComponent(id, 0), in ? Linear(p) : 0.0, 1e-4);
  }
  // The nodes within fill the volume of the map's cells.
  const double cells = 7 * 8 * 6 * cell.StepA[0] * cell.StepB[1] * cell.StepC[2] / 24.0;
  EXPECT_NEAR(static_cast<double>(within), cells, 0.6 * cells);
  EXPECT_GT(within, 100);
}

TEST_P(ObliqueCell, PiecesMatchTheWholeBitwise)
{
  MRCTestFile map = Ramp({ 12, 11, 10 }, { 1, 2, 3 });
  map.SetFloats(14, GetParam());
  map.AddVoxels([](int c, int r, int s, int) { return (c * 37 + r * 101 + s * 17) % 64; });
  const TemporaryFile file(map.Bytes());
  MRCTestReading whole(file.Path());
  vtkImageData* const all = whole.Update();
  const int* const size = all->GetDimensions();
  MRCTestReading part(file.Path());
  part->UpdateInformation();
  for (int piece = 0; piece < 4; ++piece)
  {
    const int first = size[2] * piece / 4;
    int extent[6] = { 2, size[0] - 3, 0, size[1] - 1, first, size[2] * (piece + 1) / 4 - 1 };
    part->UpdateExtent(extent);
    for (int k = extent[4]; k <= extent[5]; ++k)
    {
      for (int j = extent[2]; j <= extent[3]; ++j)
      {
        for (int i = extent[0]; i <= extent[1]; ++i)
        {
          ASSERT_EQ(part.At(i, j, k), whole.At(i, j, k)) << i << " " << j << " " << k;
        }
      }
    }
  }
}

TEST_P(ObliqueCell, KeptAxesAreReported)
{
  MRCTestFile map = Ramp({ 4, 3, 2 }, { 1, 2, 3 });
  map.SetFloats(14, GetParam());
  map.AddVoxels([](int c, int r, int s, int) { return c + 4 * r + 12 * s; });
  const TemporaryFile file(map.Bytes());
  MRCTestReading reading(file.Path());
  reading->SetNonOrthogonalCellToKeepCellAxes();
  vtkImageData* const image = reading.Update();
  EXPECT_NE(reading.Warning().find("distorted"), std::string::npos);
  EXPECT_EQ(image->GetDimensions()[0], 4);
  EXPECT_DOUBLE_EQ(image->GetSpacing()[2], 4.0);
  EXPECT_EQ(image->GetPointData()->GetArray("InsideMap"), nullptr);
  EXPECT_EQ(reading.At(3, 2, 1), 23.0);
}

INSTANTIATE_TEST_SUITE_P(Angles, ObliqueCell,
  ::testing::Values(std::array<float, 3>{ 90, 110, 90 }, std::array<float, 3>{ 90, 90, 120 },
    std::array<float, 3>{ 70, 80, 100 }, std::array<float, 3>{ 110, 65, 75 }));

TEST(ObliqueCellLimits, AFlatCellIsRefusedWithAdvice)
{
  MRCTestFile map = Ramp({ 40, 40, 40 }, { 1, 2, 3 });
  map.SetFloats(11, { 1.0f, 1.0f, 40000.0f });
  map.SetFloats(14, { 90.0f, 5.0f, 90.0f });
  map.AddVoxels([](int c, int, int, int) { return c; });
  const TemporaryFile file(map.Bytes());
  MRCTestReading reading(file.Path());
  reading.Update();
  EXPECT_TRUE(reading.HasFailed());
  EXPECT_NE(reading.Error().find("KeepCellAxes"), std::string::npos) << reading.Error();
}

TEST(MRCStacks, ImagesAndVolumes)
{
  struct Case
  {
    const char* Name;
    int SpaceGroup;
    int Mz;
    const char* Kind;
    int Items;
  };
  const Case cases[] = { { "a.mrc", 0, 6, "none", 1 }, { "a.mrc", 1, 6, "none", 1 },
    { "a.mrc", 0, 1, "images", 6 }, { "a.mrcs", 0, 6, "images", 6 },
    { "a.mrcs.gz", 1, 6, "images", 6 }, { "a.st", 0, 6, "images", 6 }, { "a.st", 1, 6, "none", 1 },
    { "a.rec", 0, 6, "none", 1 }, { "a.mrc", 401, 2, "volumes", 3 },
    { "a.mrcs", 401, 3, "volumes", 2 }, { "a.mrc", 401, 4, "none", 1 } };
  for (const Case& stack : cases)
  {
    MRCTestFile map({ 3, 2, 6 }, 2);
    map.SetInt(23, stack.SpaceGroup);
    map.SetInt(10, stack.Mz);
    map.AddVoxels([](int, int, int s, int) { return s; });
    const TemporaryFile file(map.Bytes(), stack.Name);
    MRCTestReading reading(file.Path());
    vtkImageData* image = reading.Update();
    const bool volumes = std::string(stack.Kind) == "volumes";
    EXPECT_EQ(reading.Text("StackType"), stack.Kind) << stack.Name << " " << stack.SpaceGroup;
    EXPECT_EQ(reading.Number("NumberOfVolumes"), stack.Items) << stack.Name;
    EXPECT_EQ(image->GetDimensions()[2], volumes ? stack.Mz : 6);
    EXPECT_EQ(reading.Count("Repairs"), stack.Mz == 4 ? 1 : 0);
    reading->SetVolumeIndex(stack.Items - 1);
    image = reading.Update();
    const int each = 6 / stack.Items;
    EXPECT_EQ(image->GetDimensions()[2], each);
    EXPECT_EQ(reading.At(0, 0, 0), 6 - each);
    EXPECT_EQ(reading.At(2, 1, each - 1), 5);
  }
}

TEST(MRCTransforms, AreReportedAsTransforms)
{
  MRCTestFile map({ 3, 2, 2 }, 4);
  map.AddVoxels([](int c, int, int, int k) { return c + 10 * k; });
  const TemporaryFile file(map.Bytes());
  MRCTestReading reading(file.Path());
  reading.Update();
  EXPECT_NE(reading.Text("Notes").find("Hermitian"), std::string::npos);
  EXPECT_EQ(reading.At(2, 0, 0, 1), 12.0);
}

}
