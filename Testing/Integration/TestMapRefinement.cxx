// A density map with noise, interpolated to twice and four times as many nodes a side: the surface
// changes by less than a voxel, and its choking loops are those of the map as it is.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/PolyDataTriangles.h"
#include "FeatureRows.h"
#include "SharedData.h"
#include "Surfaces/HausdorffDistance.h"
#include "vtkMRCMapReader.h"
#include "vtkMapSurface.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkImageResize.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

TriangleMesh SurfaceOf(vtkImageData* map, int factor, double level)
{
  int dimensions[3];
  map->GetDimensions(dimensions);
  vtkNew<vtkImageResize> resize; // trilinear; the nodes of the map stay nodes
  resize->SetInputData(map);
  resize->SetOutputDimensions(factor * (dimensions[0] - 1) + 1, factor * (dimensions[1] - 1) + 1,
    factor * (dimensions[2] - 1) + 1);
  vtkNew<vtkMapSurface> surface;
  surface->SetInputConnection(resize->GetOutputPort());
  surface->SetLevel(level);
  surface->Update();
  return CheckedSurface(ToTriangleMesh(surface->GetOutput()), false);
}

}

TEST(MapRefinement, FeaturesStay)
{
  ISTHMUS_NEEDS_SHARED_DATA("maps/emd_5043.map");
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName((SharedDataFolder() / "maps/emd_5043.map").c_str());
  reader->Update();
  vtkImageData* map = reader->GetOutput();
  vtkNew<vtkMapSurface> automatic;
  automatic->SetInputData(map);
  automatic->Update();
  const double level =
    automatic->GetOutput()->GetFieldData()->GetArray("AutomaticLevel")->GetTuple1(0);
  vtkDataArray* values = map->GetPointData()->GetScalars();
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0.0, 0.02 * level);
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    values->SetTuple1(i, values->GetTuple1(i) + noise(random));
  }
  const TriangleMesh own = SurfaceOf(map, 1, level);
  const ChokingLoops expected{ TriangleMesh(own) };
  for (const int factor : { 2, 4 })
  {
    const TriangleMesh finer = SurfaceOf(map, factor, level);
    const ChokingLoops found{ TriangleMesh(finer) };
    ASSERT_TRUE(found.Fine());
    const double apart = HausdorffDistance(own, finer);
    FeatureComparison there, back;
    for (const SpaceSide side : { SpaceSide::Inside, SpaceSide::Outside })
    {
      // Features of a persistence of less than twice the distance may vanish.
      const auto rows = [&](const ChokingLoops& loops)
      {
        return RowsOf(loops, FeatureKind::Additional, side,
          std::max(0.05 * loops.Diagram().Reference[static_cast<std::size_t>(side)], 2.0 * apart),
          { apart, 0.01 });
      };
      ExpectCounterparts("as it is", rows(expected), rows(found), { apart, 0.01 }, there);
      ExpectCounterparts("finer", rows(found), rows(expected), { apart, 0.01 }, back);
    }
    EXPECT_GT(there.Features, 20U);
    std::printf("%zu points, %zu samples, %.3f apart: %zu and %zu features\n", finer.Points.size(),
      found.Samples().Points.size(), apart, there.Features, back.Features);
  }
}
