// From the file of a large map to the surface of a region and to that of the whole, binned, in
// little memory: the file has holes, so that it takes no room on the disk.

#include "Core/PolyDataTriangles.h"
#include "MRCTestFile.h"
#include "PeakMemory.h"
#include "Surfaces/SurfaceTopology.h"
#include "TemporaryFile.h"
#include "vtkMRCMapReader.h"
#include "vtkMapSurface.h"
#include "vtkSurfaceMeasures.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr std::array<int, 3> Nodes{ 1024, 2048, 128 };
constexpr std::array<int, 3> Center{ 700, 1100, 60 };
constexpr int Radius = 40;

/// 256 MiB of signed chars, 0 but for a ball of 100 with a border of one node.
void WriteBall(const std::string& path)
{
  std::ofstream file(path, std::ios::binary);
  file << MRCTestFile(Nodes, 0).Bytes();
  const auto offset = [](int i, int j, int k)
  { return 1024 + i + std::streamoff{ Nodes[0] } * (j + std::streamoff{ Nodes[1] } * k); };
  for (int k = -Radius - 2; k <= Radius + 2; ++k)
  {
    for (int j = -Radius - 2; j <= Radius + 2; ++j)
    {
      std::string row;
      for (int i = -Radius - 2; i <= Radius + 2; ++i)
      {
        const double outside = std::hypot(i, j, k) - Radius;
        row += static_cast<char>(std::lround(100.0 * std::clamp(0.5 - outside, 0.0, 1.0)));
      }
      file.seekp(offset(Center[0] - Radius - 2, Center[1] + j, Center[2] + k));
      file << row;
    }
  }
  file.seekp(offset(Nodes[0] - 1, Nodes[1] - 1, Nodes[2] - 1));
  file << '\0';
}

/// Whether the surface is the ball: closed, of genus 0, its area and its center.
void ExpectBall(vtkPolyData* surface, double tolerance)
{
  const TriangleMesh mesh = ToTriangleMesh(surface);
  ASSERT_FALSE(mesh.Triangles.empty());
  EXPECT_EQ(EulerCharacteristic(mesh), 2);
  vtkNew<vtkSurfaceMeasures> measures;
  measures->SetInputData(surface);
  measures->Update();
  const double expected = 4.0 * 3.14159265358979 * Radius * Radius;
  EXPECT_NEAR(measures->GetOutput()->GetFieldData()->GetArray("Area")->GetTuple1(0) / expected, 1.0,
    tolerance);
  double bounds[6];
  surface->GetBounds(bounds);
  for (std::size_t a = 0; a < 3; ++a)
  {
    EXPECT_NEAR(0.5 * (bounds[2 * a] + bounds[2 * a + 1]), Center[a], 0.5) << a;
  }
}

}

TEST(MapsLargerThanMemory, RegionAndBinnedWhole)
{
  const TemporaryFile file("");
  WriteBall(file.Path());
  vtkNew<vtkMRCMapReader> region, whole;
  vtkNew<vtkMapSurface> detail, overview;
  region->SetFileName(file.Path());
  region->SetCropExtent(600, 799, 1000, 1199, 0, 127);
  detail->SetInputConnection(region->GetOutputPort());
  whole->SetFileName(file.Path());
  whole->SetSampleRate(4, 4, 4);
  overview->SetInputConnection(whole->GetOutputPort());
  ResetPeakMemory();
  const double before = PeakMemory();
  for (vtkMapSurface* surface : { detail.Get(), overview.Get() })
  {
    surface->SetLevel(50.0);
    surface->Update();
  }
  const double peak = PeakMemory() - before;
  ExpectBall(detail->GetOutput(), 0.01);
  ExpectBall(overview->GetOutput(), 0.02);
  // 5 MiB of the region (40 as doubles), 16 MiB of the whole, and their surfaces; the file has 256
  // MiB, which would be 1 GiB as floats.
  EXPECT_LT(peak, 100e6);
}
