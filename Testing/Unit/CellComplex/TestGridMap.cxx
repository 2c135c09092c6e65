// The map of every shared volume mesh and of VTK grids of each cell type.

#include "CellComplex/GridMap.h"

#include "GridFixtures.h"
#include "IncidenceCheck.h"
#include "SharedData.h"
#include "VolumeMeshFiles.h"

#include <vtkIdList.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>
#include <string>

namespace
{

using namespace isthmus;
using namespace isthmus::testing;

/// The neighbour that VTK finds across each face of each cell, if there is one.
template <typename Map>
void CheckAgainstVTK(const Map& map, const GridCells& cells, vtkUnstructuredGrid* grid)
{
  grid->BuildLinks();
  vtkNew<vtkIdList> face, found;
  for (std::size_t c = 0; c < map.NumberOfCells(); ++c)
  {
    for (const auto half : map.HalfFaces(typename Map::Cell(static_cast<std::uint32_t>(c))))
    {
      face->Reset();
      for (const auto dart : map.Darts(half))
      {
        face->InsertNextId(static_cast<vtkIdType>(map.StartVertex(dart).Value));
      }
      grid->GetCellNeighbors(cells.GridId(c), face, found);
      std::set<vtkIdType> volumes;
      for (const vtkIdType id : *found)
      {
        if (grid->GetCell(id)->GetCellDimension() == 3)
        {
          volumes.insert(id);
        }
      }
      const auto across = map.Across(half);
      std::set<vtkIdType> ours;
      if (!map.IsOutside(across))
      {
        ours.insert(cells.GridId(map.GetCell(across).Value));
      }
      ASSERT_EQ(ours, volumes) << "cell " << cells.GridId(c);
    }
  }
}

/// The expected facts of one file.
struct SharedMesh
{
  const char* File;
  std::int64_t Cells;
  std::int64_t Euler;
  bool Pinched = false;
};

class SharedVolumes : public ::testing::TestWithParam<SharedMesh>
{
};

std::string FileAsName(const ::testing::TestParamInfo<SharedMesh>& test)
{
  std::string name = test.param.File;
  std::replace_if(
    name.begin(), name.end(), [](unsigned char c) { return !std::isalnum(c); }, '_');
  return name;
}

}

TEST_P(SharedVolumes, AgreesWithBruteForceAndVTK)
{
  const std::string file = std::string("volumes/") + GetParam().File;
  ISTHMUS_NEEDS_SHARED_DATA(file);
  const auto grid = ReadVolumeMesh(SharedDataFolder() / file);
  WithMap(grid, {},
    [&](const auto& map, const GridCells& cells)
    {
      EXPECT_EQ(static_cast<std::int64_t>(map.NumberOfCells()), GetParam().Cells);
      EXPECT_EQ(EulerNumber(map), GetParam().Euler);
      CheckEverything(map, cells.List());
      CheckAgainstVTK(map, cells, grid);
      const BruteForce truth(cells.List());
      const bool pinched = truth.IsPinched();
      EXPECT_EQ(pinched, GetParam().Pinched);
      if (!pinched) // then the boundary is a closed surface with twice the Euler number
      {
        EXPECT_EQ(truth.BoundaryEuler(), 2 * GetParam().Euler);
      }
    });
}

// Numbers of cells as PROVENANCE.md counts them, Euler numbers of the volumes by counting.
INSTANTIATE_TEST_SUITE_P(All, SharedVolumes,
  ::testing::Values(SharedMesh{ "AngularSector.vtk", 7776, 7 },
    SharedMesh{ "NonManifold.ovm", 2, 1 }, SharedMesh{ "beam-wedge.vtk", 8, 1 },
    SharedMesh{ "bunny.mesh", 34055, 1 }, SharedMesh{ "bunny_gmsh41.msh", 19379, 1 },
    SharedMesh{ "car.msh", 11843, 2 }, SharedMesh{ "cube_hexahedron_3.ovm", 512, 1 },
    SharedMesh{ "cube_pyramids_3.ovm", 896, 1 }, SharedMesh{ "cube_voronoi_3.ovm", 299, 1 },
    SharedMesh{ "eight_voronoi.hedra", 2162, -2 },
    SharedMesh{ "emd_5043_8ang.vol", 5203, -35, true }, SharedMesh{ "escher.vtk", 42, 1 },
    SharedMesh{ "fichera-mixed.mesh", 14, 1 }, SharedMesh{ "fichera.vtk", 7, 1 },
    SharedMesh{ "hand.msh", 29998, 1 }, SharedMesh{ "mesh_vtk51.vtk", 1000, 1 },
    SharedMesh{ "notch_stress_fixed.vtk", 2192, 1 }, SharedMesh{ "octopus-low.mesh", 1140, 1 },
    SharedMesh{ "rockerarm_hex.mesh", 10600, 0 }, SharedMesh{ "tetgen_one_tet10.ele", 1, 1 },
    SharedMesh{ "tetraMesh.vtk", 160, 1 }, SharedMesh{ "tinyzoo-3d.mesh", 4, 1 }),
  FileAsName);

TEST(GridMap, TakesEveryLinearType)
{
  for (const GridFixture& fixture : AllGridFixtures())
  {
    WithMap(fixture.Grid.Get(), {},
      [&](const auto& map, const GridCells& cells)
      {
        EXPECT_EQ(cells.Remark(), "") << fixture.Name;
        EXPECT_EQ(cells.NumberOfCells(), fixture.Grid->GetNumberOfCells()) << fixture.Name;
        EXPECT_EQ(EulerNumber(map), 1) << fixture.Name;
        CheckEverything(map, cells.List());
        CheckAgainstVTK(map, cells, fixture.Grid);
      });
  }
}

TEST(GridMap, TurnedCellsAreTurnedBack)
{
  for (const GridFixture& fixture : AllGridFixtures())
  {
    if (fixture.Name == "polyhedra")
    {
      continue;
    }
    // Every second cell inside out.
    vtkNew<vtkIdList> ids;
    GridPointer turned = EmptyGrid();
    turned->SetPoints(fixture.Grid->GetPoints());
    for (vtkIdType c = 0; c < fixture.Grid->GetNumberOfCells(); ++c)
    {
      fixture.Grid->GetCellPoints(c, ids);
      for (const GridCellType& type : LinearCellTypes())
      {
        if (type.VTKType == fixture.Grid->GetCellType(c))
        {
          std::vector<vtkIdType> order;
          for (const int vertex : type.TurnedOut)
          {
            order.push_back(ids->GetId(c % 2 ? static_cast<int>(order.size()) : vertex));
          }
          turned->InsertNextCell(type.VTKType, static_cast<vtkIdType>(order.size()), order.data());
        }
      }
    }
    std::vector<std::int64_t> expected, found;
    const auto vertices = [](std::vector<std::int64_t>& list)
    {
      return [&list](const auto&, const GridCells& cells)
      {
        const CellList all = cells.List();
        list.assign(all.CellVertices.begin(), all.CellVertices.end());
      };
    };
    WithMap(fixture.Grid.Get(), {}, vertices(expected));
    WithMap(turned.Get(), {}, vertices(found));
    EXPECT_EQ(found, expected) << fixture.Name;
  }
}
