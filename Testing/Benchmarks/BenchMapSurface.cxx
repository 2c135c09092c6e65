// A new level of Map Surface on a map of n^3 nodes beside vtkFlyingEdges3D alone, which neither
// closes the surface nor looks for components. Both use the same sequence of levels. Run by hand.

#include "vtkMapSurface.h"

#include <vtkFloatArray.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <benchmark/benchmark.h>

#include <cmath>

namespace
{

/// More than a hundred cells of a gyroid in a ball: about as much surface as a large assembly has.
vtkSmartPointer<vtkImageData> Gyroid(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  vtkNew<vtkFloatArray> values;
  values->SetName("Density");
  values->SetNumberOfValues(image->GetNumberOfPoints());
  const double turns = 10.0 * 3.14159265 / n;
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double x = static_cast<double>(i % n), y = static_cast<double>(i / n % n),
                 z = static_cast<double>(i / n / n);
    const double wave = std::sin(turns * x) * std::cos(turns * y) +
      std::sin(turns * y) * std::cos(turns * z) + std::sin(turns * z) * std::cos(turns * x);
    const double depth = 0.45 - std::hypot(x - n / 2, y - n / 2, z - n / 2) / n;
    values->SetValue(i, static_cast<float>(std::min(wave, 20.0 * depth)));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

double ChooseLevel(std::int64_t turn)
{
  return turn % 2 == 0 ? 0.1 : 0.2;
}

void MapSurface(benchmark::State& state)
{
  vtkNew<vtkMapSurface> filter;
  filter->SetInputData(Gyroid(static_cast<int>(state.range(0))));
  std::int64_t turn = 0;
  for (auto _ : state)
  {
    filter->SetLevel(ChooseLevel(turn++));
    filter->Update();
  }
  state.counters["triangles"] = static_cast<double>(filter->GetOutput()->GetNumberOfPolys());
}

void FlyingEdges(benchmark::State& state)
{
  vtkNew<vtkFlyingEdges3D> filter;
  filter->SetInputData(Gyroid(static_cast<int>(state.range(0))));
  std::int64_t turn = 0;
  for (auto _ : state)
  {
    filter->SetValue(0, ChooseLevel(turn++));
    filter->Update();
  }
  state.counters["triangles"] = static_cast<double>(filter->GetOutput()->GetNumberOfPolys());
}

BENCHMARK(MapSurface)->Arg(128)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(FlyingEdges)->Arg(128)->Arg(256)->Unit(benchmark::kMillisecond)->UseRealTime();

}

BENCHMARK_MAIN();
