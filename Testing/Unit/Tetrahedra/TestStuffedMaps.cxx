// Isosurface stuffing of every shared map, and of surfaces offset inwards and outwards: the
// published angles, every face shared, the box filled.

#include "Contouring/LevelEstimate.h"
#include "Core/PolyDataTriangles.h"
#include "DamagedSurfaces.h"
#include "LongTests.h"
#include "SharedData.h"
#include "TetrahedralChecks.h"
#include "vtkIsosurfaceStuffing.h"
#include "vtkMRCMapReader.h"
#include "vtkMapSurface.h"
#include "vtkSurfaceToGrid.h"

#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnstructuredGrid.h>
#include <vtkVariant.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TetrahedralMesh ToTriangleMesh(vtkUnstructuredGrid* grid)
{
  TetrahedralMesh mesh;
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    grid->GetPoint(i, p.data());
    mesh.Points.push_back(p);
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType i = 0; i < grid->GetNumberOfCells(); ++i)
  {
    grid->GetCellPoints(i, ids);
    mesh.Tetrahedra.push_back({ ids->GetId(0), ids->GetId(1), ids->GetId(2), ids->GetId(3) });
  }
  mesh.Regions.assign(mesh.Tetrahedra.size(), 1);
  return mesh;
}

/// A level between the lowest and the highest value; NaN where there is none.
double ChooseLevel(vtkImageData* map)
{
  vtkDataArray* scalars = map->GetPointData()->GetScalars();
  if (!scalars || scalars->GetNumberOfComponents() != 1)
  {
    return std::nan("");
  }
  std::vector<double> values;
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    const double value = scalars->GetComponent(i, 0);
    if (!std::isfinite(value))
    {
      return std::nan("");
    }
    values.push_back(value);
  }
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  return *low < *high ? EstimateLevel(values) : std::nan("");
}

struct Totals
{
  std::size_t Maps = 0, Tetrahedra = 0;
  double Smallest = 180.0, Largest = 0.0;
};

void Stuff(vtkImageData* map, double level, int levels, Totals& seen)
{
  vtkNew<vtkIsosurfaceStuffing> filter;
  filter->SetInputData(map);
  filter->SetLevel(level);
  filter->SetGradingLevels(levels);
  constexpr vtkIdType large = 300000; // nodes; the outside of noise is millions of tetrahedra
  filter->SetSide(
    map->GetNumberOfPoints() < large ? vtkIsosurfaceStuffing::Both : vtkIsosurfaceStuffing::Inside);
  filter->Update();
  const TetrahedralMesh mesh = ToTriangleMesh(filter->GetOutput());
  ASSERT_GT(mesh.Tetrahedra.size(), 0u);
  const QualitySummary quality = MeasureQualityRange(mesh);
  EXPECT_GE(quality.SmallestAngle, 10.7);
  EXPECT_LE(quality.LargestAngle, 164.8);
  seen.Tetrahedra += mesh.Tetrahedra.size();
  seen.Smallest = std::min(seen.Smallest, quality.SmallestAngle);
  seen.Largest = std::max(seen.Largest, quality.LargestAngle);
  constexpr std::size_t few = 200000; // faces are counted in a tree
  if (mesh.Tetrahedra.size() < few)
  {
    EXPECT_EQ(CountFaces(mesh).Crowded, 0);
  }
}

}

/// Acceptance 1, "all shared maps": the small ones each time, the others in turns.
TEST(StuffedMaps, AnglesStayWithinTheBoundsOnAllSharedMaps)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps");
  const LongCases others("StuffedMaps", 10);
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(SharedDataFolder() / "maps"))
  {
    if (entry.is_regular_file())
    {
      files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  Totals seen;
  std::size_t index = 0, left = 0;
  for (const auto& file : files)
  {
    constexpr std::uintmax_t small = 70000;
    if (!others.Has(index++) && std::filesystem::file_size(file) > small)
    {
      continue;
    }
    SCOPED_TRACE(file.filename().string());
    vtkNew<vtkMRCMapReader> reader;
    vtkNew<vtkTest::ErrorObserver> quiet; // some are broken on purpose
    for (vtkObject* teller :
      { static_cast<vtkObject*>(reader), static_cast<vtkObject*>(reader->GetExecutive()) })
    {
      teller->AddObserver(vtkCommand::ErrorEvent, quiet);
      teller->AddObserver(vtkCommand::WarningEvent, quiet);
    }
    reader->SetFileName(file.c_str());
    reader->Update();
    const int* n = reader->GetOutput()->GetDimensions();
    const double level =
      std::min({ n[0], n[1], n[2] }) > 1 ? ChooseLevel(reader->GetOutput()) : std::nan("");
    if (!std::isfinite(level))
    {
      ++left;
      continue;
    }
    ++seen.Maps;
    Stuff(reader->GetOutput(), level, static_cast<int>(index % 3), seen);
  }
  std::printf("%zu maps (%zu others are not volumes of finite, different numbers), %zu tetrahedra: "
              "angles %.2f to %.2f\n",
    seen.Maps, left, seen.Tetrahedra, seen.Smallest, seen.Largest);
  EXPECT_GE(seen.Maps, 8u);
  others.ReportCases(seen.Maps + left, files.size());
}

/// Acceptance 1, "offset surfaces": levels of the signed distance to primitives, a spacing and a
/// half inside to three outside, where fronts of the distance meet in kinks.
TEST(StuffedMaps, AnglesStayWithinTheBoundsOnOffsetSurfaces)
{
  Totals seen;
  for (unsigned seed = 1; seed <= 5; ++seed)
  {
    SCOPED_TRACE(seed);
    Chance chance(seed);
    const TriangleMesh mesh = SoundSurface(chance);
    vtkNew<vtkPolyData> surface;
    SetMesh(mesh, surface);
    const double h = ComputeBounds(mesh).Diagonal() / 24.0;
    vtkNew<vtkSurfaceToGrid> grid;
    grid->SetInputData(surface);
    grid->SetSpacing(h);
    grid->SetPadding(5);
    grid->Update();
    vtkImageData* const image = grid->GetOutput();
    image->GetPointData()->SetActiveScalars("SignedDistance");
    for (const double offset : { -1.5, 0.7, 3.0 })
    {
      vtkNew<vtkIsosurfaceStuffing> filter;
      filter->SetInputData(image);
      filter->SetLevel(offset * h);
      filter->InsideIsHigherOff();
      filter->SetGradingLevels(static_cast<int>(seed % 3));
      filter->Update();
      const TetrahedralMesh tetrahedra = ToTriangleMesh(filter->GetOutput());
      ASSERT_GT(tetrahedra.Tetrahedra.size(), 0u);
      const QualitySummary quality = MeasureQualityRange(tetrahedra);
      EXPECT_GE(quality.SmallestAngle, 10.7);
      EXPECT_LE(quality.LargestAngle, 164.8);
      EXPECT_EQ(CountFaces(tetrahedra).Crowded, 0);
      seen.Tetrahedra += tetrahedra.Tetrahedra.size();
      seen.Smallest = std::min(seen.Smallest, quality.SmallestAngle);
      seen.Largest = std::max(seen.Largest, quality.LargestAngle);
    }
  }
  std::printf(
    "%zu tetrahedra: angles %.2f to %.2f\n", seen.Tetrahedra, seen.Smallest, seen.Largest);
}

/// As of the filters of Contouring (TestMapSurface.cxx).
TEST(StuffedMaps, AutomaticLevelIsThatOfMapSurface)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(24, 20, 20);
  vtkNew<vtkDoubleArray> values;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    Point3 p;
    image->GetPoint(i, p.data());
    const Point3 fromCenter = p - Point3{ 11.0, 9.5, 9.5 };
    values->InsertNextValue(49.5 + 50.5 * std::tanh(6.0 - std::sqrt(Dot(fromCenter, fromCenter))));
  }
  image->GetPointData()->SetScalars(values);
  const auto levels = [&image](const std::string& expectedSource)
  {
    vtkNew<vtkMapSurface> surface;
    vtkNew<vtkIsosurfaceStuffing> stuffing;
    surface->SetInputData(image);
    surface->InsideIsHigherOff();
    surface->Update();
    stuffing->SetInputData(image);
    stuffing->InsideIsHigherOff();
    stuffing->Update();
    EXPECT_GT(stuffing->GetOutput()->GetNumberOfCells(), 0);
    vtkFieldData* const found = stuffing->GetOutput()->GetFieldData();
    EXPECT_EQ(
      found->GetAbstractArray("LevelSource")->GetVariantValue(0).ToString(), expectedSource);
    return std::array<double, 2>{
      surface->GetOutput()->GetFieldData()->GetArray("Level")->GetTuple1(0),
      found->GetArray("Level")->GetTuple1(0)
    };
  };
  values->SetName("Density");
  const auto [estimated, stuffed] = levels("estimated from the values");
  EXPECT_NE(estimated, 0.0);
  EXPECT_EQ(stuffed, estimated);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetValue(i, 20.0 - values->GetValue(i));
  }
  values->SetName("SignedDistance");
  values->Modified();
  EXPECT_EQ(levels("zero of a signed distance"), (std::array<double, 2>{ 0.0, 0.0 }));
}
