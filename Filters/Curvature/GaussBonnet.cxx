#include "Curvature/GaussBonnet.h"

#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/NamedColumns.h"
#include "Core/ParallelFor.h"
#include "Core/PolyDataTriangles.h"

#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <vector>

namespace isthmus
{

double IntegrateGaussianCurvature(vtkPolyData* surface)
{
  vtkDataArray* gaussian = surface->GetPointData()->GetArray("GaussianCurvature");
  vtkDataArray* valid = surface->GetPointData()->GetArray("CurvatureValid");
  std::vector<double> curvature(static_cast<std::size_t>(surface->GetNumberOfPoints()), 0.0);
  constexpr std::int64_t block = 1 << 14;
  ParallelFor(0, gaussian && valid ? surface->GetNumberOfPoints() : 0, block,
    [&](std::int64_t first, std::int64_t last)
    {
      for (vtkIdType i = first; i < last; ++i)
      {
        const bool isValid = valid->GetComponent(i, 0) != 0.0;
        curvature[At(i)] = isValid ? gaussian->GetComponent(i, 0) : 0.0;
      }
    });
  const PolyDataTriangles triangles(surface);
  const SurfaceView mesh = triangles.View();
  return ParallelReduce(static_cast<std::int64_t>(mesh.Triangles.size()), block, 0.0,
    [&](double& sum, std::int64_t first, std::int64_t last)
    {
      for (std::int64_t i = first; i < last; ++i)
      {
        const Triangle& t = mesh.Triangles[At(i)];
        const Point3& a = mesh.Points[At(t[0])];
        const double area =
          0.5 * Length(Cross(mesh.Points[At(t[1])] - a, mesh.Points[At(t[2])] - a));
        sum += area * (curvature[At(t[0])] + curvature[At(t[1])] + curvature[At(t[2])]) / 3.0;
      }
    });
}

void AddGaussBonnet(double integral, vtkFieldData* fields)
{
  AddColumn<vtkDoubleArray>(fields, "GaussianCurvatureIntegral", { integral });
  AddColumn<vtkDoubleArray>(fields, "GaussBonnetEulerNumber", { integral / (2.0 * Pi) });
}

}
