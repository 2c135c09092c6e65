/**
 * @file TriangulationCells.h
 * @brief Converts a CGAL triangulation to the tetrahedra of a CellFiltration.
 */
#ifndef isthmus_TriangulationCells_h
#define isthmus_TriangulationCells_h

#include "Persistence/CellFiltration.h"

#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/property_map.h>
#include <CGAL/spatial_sort.h>

#include <numeric>
#include <vector>

namespace isthmus
{

/// Positions of points along a space-filling curve, so that each is near the preceding one. O(n log
/// n).
template <typename Kernel>
std::vector<std::size_t> SpatialOrder(const std::vector<typename Kernel::Point_3>& points)
{
  using Map = typename CGAL::Pointer_property_map<typename Kernel::Point_3>::const_type;
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  if (points.empty())
  {
    return order; // CGAL's map would take the address of the first
  }
  CGAL::spatial_sort(order.begin(), order.end(),
    CGAL::Spatial_sort_traits_adapter_3<Kernel, Map>(CGAL::make_property_map(points)));
  return order;
}

/**
 * The finite cells, numbered in the order of the triangulation, with their neighbours. O(n).
 *
 * @pre `info()` of each vertex is the point's id. The `info()` of the cells, a TetrahedronId, is
 * set.
 * @throws Cancelled.
 */
template <typename Triangulation>
void ImportCells(
  const Triangulation& triangulation, CellFiltration& f, const ProgressCallback& progress)
{
  constexpr std::size_t reportEvery = 1 << 18;
  for (auto c = triangulation.all_cells_begin(); c != triangulation.all_cells_end(); ++c)
  {
    c->info() = TetrahedronId::None();
  }
  std::size_t count = 0;
  for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c)
  {
    c->info() = TetrahedronId::At(count++);
  }
  f.Tetrahedra.resize(count);
  f.Neighbours.resize(count);
  for (auto c = triangulation.finite_cells_begin(); c != triangulation.finite_cells_end(); ++c)
  {
    const TetrahedronId cell = c->info();
    if (cell.Index() % reportEvery == 0)
    {
      Report(progress, static_cast<double>(cell.Index()) / static_cast<double>(count));
    }
    for (int k = 0; k < 4; ++k)
    {
      f.Tetrahedra[cell][static_cast<std::size_t>(k)] = c->vertex(k)->info();
      f.Neighbours[cell][static_cast<std::size_t>(k)] = c->neighbor(k)->info();
    }
  }
}

}

#endif
