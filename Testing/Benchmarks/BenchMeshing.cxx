// The meshers compared with their alternatives: tetrahedra per second and memory by number, the
// Delaunay isosurface beside vtkFlyingEdges3D, remeshing and quality. Run by hand;
// --benchmark_filter=10000000 for the largest (some minutes and 5 GB).

#include "Contouring/ClosedLevelSet.h"
#include "Contouring/DelaunayIsosurface.h"
#include "Core/PolyDataTriangles.h"
#include "Remeshing/SurfaceRemesh.h"
#include "Tetrahedra/MeshQuality.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSphereSource.h>

#include <benchmark/benchmark.h>

#include <sys/resource.h>

using namespace isthmus;

namespace
{

TriangleMesh Sphere(int resolution)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution / 2);
  source->Update();
  return ToTriangleMesh(source->GetOutput());
}

/// Largest memory of this process, or of its children, so far, in MB.
double PeakMB(int whose)
{
  rusage usage{};
  getrusage(whose, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

/// A sphere of radius 0.5 in about state.range(0) tetrahedra.
void Fill(benchmark::State& state, TetrahedralLibrary library)
{
  const TriangleMesh surface = Sphere(64);
  const auto wanted = static_cast<double>(state.range(0));
  TetrahedralParameters parameters;
  parameters.Library = library;
  parameters.TetGen.PreserveSurface = false;
  // By trial, a mesh has about twice as many tetrahedra as the bound on volume alone would give.
  parameters.TetGen.MaximumVolume = 2.0 * 0.5236 / wanted;
  parameters.TetGen.Limits = { 540.0, std::uint64_t{ 6 } << 30 };
  parameters.CGAL.CellSize = 1.25 * std::cbrt(0.5236 / wanted) * 2.0;
  parameters.CGAL.FacetSize = parameters.CGAL.CellSize;
  std::size_t count = 0;
  for (auto _ : state)
  {
    count = MeshTetrahedra(surface, parameters).Tetrahedra.size();
  }
  state.counters["tetrahedra"] = static_cast<double>(count);
  state.counters["MB"] = PeakMB(RUSAGE_SELF);
  state.counters["child_MB"] = PeakMB(RUSAGE_CHILDREN);
}

/// A gyroid-like density on n^3 nodes.
vtkSmartPointer<vtkImageData> Density(int n)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  vtkNew<vtkFloatArray> values;
  values->SetNumberOfValues(image->GetNumberOfPoints());
  const double w = 12.0 / n;
  vtkIdType id = 0;
  for (int k = 0; k < n; ++k)
  {
    for (int j = 0; j < n; ++j)
    {
      for (int i = 0; i < n; ++i)
      {
        values->SetValue(id++,
          static_cast<float>(std::sin(w * i) * std::cos(w * j) + std::sin(w * j) * std::cos(w * k) +
            std::sin(w * k) * std::cos(w * i)));
      }
    }
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

void FlyingEdges(benchmark::State& state)
{
  const auto image = Density(static_cast<int>(state.range(0)));
  std::size_t triangles = 0;
  for (auto _ : state)
  {
    triangles =
      CloseLevelSet(image, image->GetPointData()->GetScalars(), 0.3, true).Guide.Triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void Delaunay(benchmark::State& state)
{
  const auto image = Density(static_cast<int>(state.range(0)));
  const auto set = CloseLevelSet(image, image->GetPointData()->GetScalars(), 0.3, true);
  DelaunayIsosurfaceParameters parameters;
  parameters.Level = 0.3;
  parameters.Radius = 1.5;
  parameters.Distance = 0.25;
  std::size_t triangles = 0;
  for (auto _ : state)
  {
    triangles =
      DelaunayIsosurface(set.Field, set.Bounds, set.Guide, parameters).Surface.Triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void Remesh(benchmark::State& state)
{
  const TriangleMesh surface = Sphere(static_cast<int>(state.range(0)));
  SurfaceRemeshParameters parameters;
  parameters.EdgeLength = MeanEdgeLength(surface);
  std::size_t triangles = 0;
  for (auto _ : state)
  {
    triangles = RemeshSurface(surface, parameters).Mesh.Triangles.size();
  }
  state.counters["triangles"] = static_cast<double>(triangles);
}

void Quality(benchmark::State& state)
{
  TetrahedralParameters parameters;
  parameters.TetGen.PreserveSurface = false;
  parameters.TetGen.MaximumVolume = 1e-6;
  const TetrahedralMesh mesh = MeshTetrahedra(Sphere(64), parameters);
  std::vector<CellAngles> cells;
  for (auto _ : state)
  {
    benchmark::DoNotOptimize(MeasureQuality(mesh.Points, mesh.Tetrahedra, 36, cells));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.Tetrahedra.size()));
}

}

BENCHMARK_CAPTURE(Fill, TetGen, TetrahedralLibrary::TetGen)
  ->Arg(100'000)
  ->Arg(1'000'000)
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1);
BENCHMARK_CAPTURE(Fill, CGAL, TetrahedralLibrary::CGAL)
  ->Arg(100'000)
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1);
BENCHMARK_CAPTURE(Fill, Tetra10M, TetrahedralLibrary::TetGen)
  ->Arg(10'000'000)
  ->Unit(benchmark::kMillisecond)
  ->Iterations(1);
BENCHMARK(FlyingEdges)->Arg(100)->Unit(benchmark::kMillisecond);
BENCHMARK(Delaunay)->Arg(100)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(Remesh)->Arg(200)->Unit(benchmark::kMillisecond)->Iterations(1);
BENCHMARK(Quality)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
