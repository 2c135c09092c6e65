// mesh_parts MAP LEVEL: tetrahedra within a level of a density map, their incidences, and the mesh
// cut in two and glued again, by the compact combinatorial map.

#include <CellComplex/Attribute.h>
#include <CellComplex/CutAndMerge.h>
#include <CellComplex/EdgeTable.h>
#include <CellComplex/GridMap.h>
#include <CellComplex/StarTable.h>
#include <CellComplex/VertexStar.h>
#include <vtkIsosurfaceStuffing.h>
#include <vtkMRCMapReader.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <utility>
#include <vector>

namespace
{

using namespace isthmus;
using Map = CompactCombinatorialMap<>;

/// Vertices - edges + faces - cells: 1 for a ball, 0 for a solid torus.
template <typename AnyMap>
std::int64_t EulerNumber(const AnyMap& map)
{
  return static_cast<std::int64_t>(map.NumberOfVertices() + map.NumberOfFaces()) -
    static_cast<std::int64_t>(map.Edges().Size() + map.NumberOfCells());
}

/// The most cells around an edge, counted cell by cell.
int LargestFan(const Map& map)
{
  Attribute<Map, Map::Edge, int> cells(map);
  for (std::uint32_t c = 0; c < map.NumberOfCells(); ++c)
  {
    for (const Map::Edge edge : map.CellEdges().Find(Map::Cell(c)))
    {
      ++cells[edge];
    }
  }
  return *std::max_element(cells.Values().begin(), cells.Values().end());
}

/// The most cells around a vertex; the list of all stars and the walk around each must agree.
std::size_t LargestStar(const Map& map)
{
  VertexStar<> star(map);
  std::size_t largest = 0;
  for (std::uint32_t v = 0; v < map.NumberOfVertices(); ++v)
  {
    const std::size_t cells = star.Gather(Map::Vertex(v)).size();
    if (map.Stars().Find(Map::Vertex(v)).size() != cells)
    {
      std::cerr << "The stars of vertex " << v << " differ.\n";
      std::exit(EXIT_FAILURE);
    }
    largest = std::max(largest, cells);
  }
  return largest;
}

/// Cuts off the first half of the cells and glues it on again, vertex by vertex.
Map CutAndGlued(const Map& map)
{
  std::vector<unsigned char> first(map.NumberOfCells(), 0);
  std::fill_n(first.begin(), first.size() / 2, static_cast<unsigned char>(1));
  std::vector<unsigned char> second(first);
  for (unsigned char& keep : second)
  {
    keep = keep ? 0 : 1;
  }
  const EditedCells one = CutOut(map, first);
  const EditedCells other = CutOut(map, second);
  std::vector<std::int64_t> inOne(map.NumberOfVertices(), -1);
  for (std::size_t v = 0; v < one.OldVertices.size(); ++v)
  {
    inOne[static_cast<std::size_t>(one.OldVertices[v])] = static_cast<std::int64_t>(v);
  }
  std::vector<std::pair<std::int64_t, std::int64_t>> same;
  for (std::size_t v = 0; v < other.OldVertices.size(); ++v)
  {
    const std::int64_t partner = inOne[static_cast<std::size_t>(other.OldVertices[v])];
    if (partner >= 0)
    {
      same.emplace_back(partner, static_cast<std::int64_t>(v));
    }
  }
  const EditedCells glued = Merge(Map(one.List()), Map(other.List()), same);
  return Map(glued.List());
}

}

int main(int argc, char* argv[])
{
  if (argc != 3)
  {
    std::cerr << "usage: mesh_parts MAP LEVEL\n";
    return EXIT_FAILURE;
  }
  vtkNew<vtkMRCMapReader> reader;
  reader->SetFileName(argv[1]);
  vtkNew<vtkIsosurfaceStuffing> tetrahedra;
  tetrahedra->SetInputConnection(reader->GetOutputPort());
  tetrahedra->SetLevel(std::atof(argv[2]));
  tetrahedra->Update();
  try
  {
    const GridCells cells(tetrahedra->GetOutput(), GridCells::Orientation::ByVolume);
    const Map map(cells.List());
    std::cout << map.NumberOfVertices() << " vertices, " << map.Edges().Size() << " edges, "
              << map.NumberOfFaces() << " faces, " << map.NumberOfCells() << " cells; at most "
              << LargestFan(map) << " cells around an edge and " << LargestStar(map)
              << " around a vertex\n";
    const Map again = CutAndGlued(map);
    if (map.NumberOfCells() == 0 || again.NumberOfCells() != map.NumberOfCells() ||
      again.NumberOfVertices() != map.NumberOfVertices() || EulerNumber(again) != EulerNumber(map))
    {
      std::cerr << "Cut and glued, the mesh is another.\n";
      return EXIT_FAILURE;
    }
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
