// The offset of a surface against vtkImplicitModeller and flying edges on the same grid.

#include "ChokingSurfaces.h"
#include "vtkOffsetSurface.h"

#include <vtkImplicitModeller.h>

#include <benchmark/benchmark.h>

#include <chrono>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Distance = 0.1; // just before the buckyball's struts are choked

vtkIdType ByUs(vtkPolyData* surface, int cells)
{
  vtkNew<vtkOffsetSurface> offset;
  offset->SetInputData(surface);
  offset->SetDistance(Distance);
  offset->SetResolution(cells);
  offset->Update();
  return offset->GetOutput()->GetNumberOfCells();
}

/// Triangle by triangle within the required distance: the faster of its two modes here.
vtkIdType ByVTK(vtkPolyData* surface, int cells)
{
  double box[6];
  surface->GetBounds(box);
  const double width = std::max({ box[1] - box[0], box[3] - box[2], box[5] - box[4] });
  const double margin = Distance + 2.0 * (width + 2.0 * Distance) / (cells - 4);
  vtkNew<vtkImplicitModeller> model;
  model->SetInputData(surface);
  model->SetSampleDimensions(cells + 1, cells + 1, cells + 1);
  model->SetModelBounds(box[0] - margin, box[1] + margin, box[2] - margin, box[3] + margin,
    box[4] - margin, box[5] + margin);
  model->AdjustBoundsOff();
  model->CappingOff();
  const double whole = width + 2.0 * margin;
  model->SetMaximumDistance((Distance + 2.0 * whole / cells) / whole);
  model->SetProcessModeToPerCell();
  vtkNew<vtkFlyingEdges3D> contour;
  contour->SetInputConnection(model->GetOutputPort());
  contour->SetValue(0, Distance);
  contour->Update();
  return contour->GetOutput()->GetNumberOfCells();
}

void BM_OffsetOfSoccerball(benchmark::State& state)
{
  using Clock = std::chrono::steady_clock;
  vtkNew<vtkPolyData> surface;
  SetMesh(ReadSurface("soccerball.obj"), surface);
  const auto cells = static_cast<int>(state.range(0));
  std::chrono::duration<double> ours{ 0 };
  std::chrono::duration<double> vtk{ 0 };
  for (auto _ : state)
  {
    const auto start = Clock::now();
    state.counters["triangles"] = static_cast<double>(ByUs(surface, cells));
    const auto middle = Clock::now();
    state.PauseTiming();
    state.counters["vtk_triangles"] = static_cast<double>(ByVTK(surface, cells));
    state.ResumeTiming();
    ours += middle - start;
    vtk += Clock::now() - middle;
  }
  const auto runs = static_cast<double>(state.iterations());
  state.counters["vtk_s"] = vtk.count() / runs;
  state.counters["ours_s"] = ours.count() / runs;
  state.counters["ours/vtk"] = ours / vtk;
}
BENCHMARK(BM_OffsetOfSoccerball)
  ->Arg(64)
  ->Arg(128)
  ->Arg(256)
  ->Unit(benchmark::kMillisecond)
  ->UseRealTime()
  ->Iterations(1);

}

BENCHMARK_MAIN();
