#include "ChokingLoops/MeshLoops.h"

#include "Core/Geometry.h"
#include "Persistence/MorseValues.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Tetrahedra/TetrahedralMesher.h"

#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// All points and cells of `grid`.
/// @throws std::invalid_argument if there are none, or for a cell that is not a tetrahedron.
TetrahedralMesh ReadTetrahedra(vtkUnstructuredGrid* grid)
{
  TetrahedralMesh mesh;
  mesh.Points.resize(static_cast<std::size_t>(grid->GetNumberOfPoints()));
  for (std::size_t i = 0; i < mesh.Points.size(); ++i)
  {
    grid->GetPoint(static_cast<vtkIdType>(i), mesh.Points[i].data());
  }
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c)
  {
    if (grid->GetCellType(c) != VTK_TETRA)
    {
      throw std::invalid_argument("Cell " + std::to_string(c) +
        " of the tetrahedral mesh is not a tetrahedron: tetrahedralize the mesh first.");
    }
    vtkIdType count = 0;
    const vtkIdType* p = nullptr;
    grid->GetCellPoints(c, count, p);
    mesh.Tetrahedra.push_back({ p[0], p[1], p[2], p[3] });
  }
  if (mesh.Tetrahedra.empty())
  {
    throw std::invalid_argument("The second input has no tetrahedra: give a mesh of one side of "
                                "the surface or both, or leave it empty.");
  }
  return mesh;
}

/// Tetrahedra of both sides of a surface, small enough for about 200,000.
TetrahedralParameters MeshingParameters(const TriangleMesh& surface)
{
  constexpr double tetrahedra = 2e5;
  TetrahedralParameters parameters;
  parameters.Side = MeshedSide::Both;
  parameters.BoxMargin = 0.1;
  const Bounds3 box = ComputeBounds(surface);
  const Point3 size = box.Max - box.Min;
  const double margin = 2.0 * parameters.BoxMargin * box.Diagonal();
  parameters.TetGen.MaximumVolume =
    (size[0] + margin) * (size[1] + margin) * (size[2] + margin) / tetrahedra;
  return parameters;
}

/// The surface with its triangles split to the size of the tetrahedra: TetGen keeps the surface,
/// and next to a triangle as large as the face of a cube it would create a million tetrahedra, none
/// of them small.
TriangleMesh SplitFor(const TetrahedralParameters& parameters, const TriangleMesh& surface)
{
  double edge = std::cbrt(6.0 * std::sqrt(2.0) * parameters.TetGen.MaximumVolume);
  return FirstSamples(surface, edge);
}

std::vector<double> FunctionValues(const SurfaceView& surface, const TetrahedralMesh& mesh,
  vtkUnstructuredGrid* given, const MeshFunctionParameters& parameters,
  const ProgressCallback& progress)
{
  if (parameters.MorseFunction == MeshFunction::PointArray)
  {
    vtkDataArray* array =
      given ? given->GetPointData()->GetArray(parameters.MorseArrayName.c_str()) : nullptr;
    if (!array || array->GetNumberOfComponents() != 1)
    {
      throw std::invalid_argument("The tetrahedral mesh on the second input has no point array '" +
        parameters.MorseArrayName + "' of one component: choose one, or another Morse function.");
    }
    std::vector<double> values(mesh.Points.size());
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = array->GetTuple1(static_cast<vtkIdType>(i));
    }
    return values;
  }
  return MorseValues(surface, mesh, static_cast<MorseFunction>(parameters.MorseFunction), progress);
}

}

std::unique_ptr<ChokingLoops> AnalyseOnTetrahedra(TriangleMesh triangles,
  vtkUnstructuredGrid* given, const MeshFunctionParameters& parameters,
  const std::function<void(const std::string&)>& warn, const ProgressCallback& progress)
{
  const CleanedSurface cleaned = CleanSurface(std::move(triangles));
  if (!cleaned.Message.empty())
  {
    warn(cleaned.Message);
  }
  const TriangleMesh surface =
    given ? cleaned.Mesh : SplitFor(MeshingParameters(cleaned.Mesh), cleaned.Mesh);
  const TetrahedralMesh mesh = given
    ? ReadTetrahedra(given)
    : MeshTetrahedra(surface, MeshingParameters(cleaned.Mesh), Between(progress, 0.0, 0.4));
  const std::vector<double> values =
    FunctionValues(surface, mesh, given, parameters, Between(progress, 0.4, 0.5));
  std::optional<std::vector<double>> errors;
  if (parameters.MorseFunction != MeshFunction::PointArray)
  {
    errors.emplace();
  }
  if (errors && parameters.MorseFunction != MeshFunction::ClosestPoint)
  {
    *errors = MorseValues(surface, mesh, MorseFunction::ClosestPoint);
    std::transform(values.begin(), values.end(), errors->begin(), errors->begin(),
      [](double value, double exact) { return std::abs(value - exact); });
  }
  return std::make_unique<ChokingLoops>(surface, mesh, values, errors, Between(progress, 0.5, 1.0));
}

}
