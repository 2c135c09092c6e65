/**
 * @file GridFixtures.h
 * @brief Small vtkUnstructuredGrids of every cell type that the topology filters accept.
 */
#ifndef isthmus_GridFixtures_h
#define isthmus_GridFixtures_h

#include "CellComplex/GridCells.h"
#include "GeneratedMeshes.h"

#include <vtkCellType.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkSmartPointer.h>
#include <vtkUnstructuredGrid.h>

#include <cmath>
#include <string>
#include <vector>

namespace isthmus::testing
{

using GridPointer = vtkSmartPointer<vtkUnstructuredGrid>;

struct GridFixture
{
  std::string Name;
  GridPointer Grid;
};

inline GridPointer EmptyGrid()
{
  auto grid = GridPointer::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  grid->SetPoints(points);
  grid->AllocateEstimate(100, 8);
  return grid;
}

/// A generated mesh in VTK's types and numbering; cells become polyhedra on request.
inline GridPointer MakeGrid(const GeneratedMesh& mesh, bool asPolyhedra = false)
{
  const int types[] = { VTK_TETRA, VTK_WEDGE, VTK_PYRAMID, VTK_HEXAHEDRON };
  GridPointer grid = EmptyGrid();
  for (const auto& point : mesh.Points)
  {
    grid->GetPoints()->InsertNextPoint(point.data());
  }
  const std::int64_t* next = mesh.CellVertices.data();
  for (const CellRun& run : mesh.Runs)
  {
    const CellType& type = mesh.Types[run.Type];
    for (std::int64_t c = 0; c < run.NumberOfCells; ++c, next += type.NumberOfVertices())
    {
      std::vector<vtkIdType> ids(next, next + type.NumberOfVertices());
      if (asPolyhedra)
      {
        std::vector<vtkIdType> stream;
        for (const std::vector<int>& face : type.Faces())
        {
          stream.push_back(static_cast<vtkIdType>(face.size()));
          for (const int vertex : face)
          {
            stream.push_back(next[vertex]);
          }
        }
        grid->InsertNextCell(
          VTK_POLYHEDRON, type.NumberOfVertices(), ids.data(), type.NumberOfFaces(), stream.data());
        continue;
      }
      if (types[run.Type] == VTK_WEDGE)
      {
        ids = { next[0], next[2], next[1], next[3], next[5], next[4] };
      }
      grid->InsertNextCell(types[run.Type], type.NumberOfVertices(), ids.data());
    }
  }
  return grid;
}

/// One prism with its points on a circle below and above, or one voxel.
inline GridPointer GridOfOne(const GridCellType& type)
{
  GridPointer grid = EmptyGrid();
  const int size = type.Type.NumberOfVertices(), half = size / 2;
  std::vector<vtkIdType> ids;
  for (int i = 0; i < size; ++i)
  {
    ids.push_back(i);
    const double angle = 2.0 * 3.14159265358979 * (i % half) / half;
    type.VTKType == VTK_VOXEL
      ? grid->GetPoints()->InsertNextPoint(i % 2, i / 2 % 2, i / 4)
      : grid->GetPoints()->InsertNextPoint(std::cos(angle), std::sin(angle), i / half);
  }
  grid->InsertNextCell(type.VTKType, size, ids.data());
  return grid;
}

inline std::vector<GridFixture> AllGridFixtures()
{
  std::vector<GridFixture> fixtures{ { "mixed", MakeGrid(MixedCells(4)) },
    { "tetrahedra", MakeGrid(Tetrahedra(2)) }, { "polyhedra", MakeGrid(MixedCells(3), true) } };
  for (const GridCellType& type : LinearCellTypes())
  {
    if (type.VTKType == VTK_VOXEL || type.Type.NumberOfVertices() > 8) // the others are in "mixed"
    {
      fixtures.push_back({ type.Type.Name(), GridOfOne(type) });
    }
  }
  return fixtures;
}

}

#endif
