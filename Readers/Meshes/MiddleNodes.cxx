#include "Meshes/MiddleNodes.h"

#include <algorithm>
#include <array>
#include <vector>

namespace isthmus
{
namespace
{

/// The corners around each further node, in VTK's order.
using Surroundings = std::vector<std::vector<std::size_t>>;

struct QuadraticShape
{
  std::size_t Corners;
  Surroundings Nodes;
};

QuadraticShape Describe(CellShape shape)
{
  switch (shape)
  {
    case CellShape::QuadraticEdge:
      return { 2, { { 0, 1 } } };
    case CellShape::QuadraticTriangle:
      return { 3, { { 0, 1 }, { 1, 2 }, { 2, 0 } } };
    case CellShape::BiquadraticQuadrilateral:
      return { 4, { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 1, 2, 3 } } };
    case CellShape::QuadraticTetrahedron:
      return { 4, { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 0, 3 }, { 1, 3 }, { 2, 3 } } };
    case CellShape::BiquadraticWedge:
      return { 6,
        { { 0, 1 }, { 1, 2 }, { 2, 0 }, { 3, 4 }, { 4, 5 }, { 5, 3 }, { 0, 3 }, { 1, 4 }, { 2, 5 },
          { 0, 1, 3, 4 }, { 1, 2, 4, 5 }, { 2, 0, 5, 3 } } };
    case CellShape::TriquadraticHexahedron:
      return { 8,
        { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 }, { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 },
          { 1, 5 }, { 2, 6 }, { 3, 7 }, { 0, 3, 4, 7 }, { 1, 2, 5, 6 }, { 0, 1, 4, 5 },
          { 2, 3, 6, 7 }, { 0, 1, 2, 3 }, { 4, 5, 6, 7 }, { 0, 1, 2, 3, 4, 5, 6, 7 } } };
    default:
      return { 0, {} };
  }
}

const double* GetPoint(const CellMesh& mesh, std::int64_t place)
{
  return mesh.Coordinates.data() + 3 * mesh.Vertices[static_cast<std::size_t>(place)];
}

/// Adds the squared distance of node n to its place p for one cell to sums[n * nodes + p], in units
/// of the cell's size, so that large cells do not decide for all.
void AddDistances(
  const CellMesh& mesh, std::int64_t start, const QuadraticShape& shape, std::vector<double>& sums)
{
  const std::size_t nodes = shape.Nodes.size();
  const auto corners = static_cast<std::int64_t>(shape.Corners);
  std::vector<std::array<double, 3>> places(nodes, { 0.0, 0.0, 0.0 });
  double size = 0.0;
  for (std::size_t p = 0; p < nodes; ++p)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      for (const std::size_t corner : shape.Nodes[p])
      {
        const double x = GetPoint(mesh, start + static_cast<std::int64_t>(corner))[axis];
        places[p][axis] += x / static_cast<double>(shape.Nodes[p].size());
        size = std::max(size, std::abs(x - GetPoint(mesh, start)[axis]));
      }
    }
  }
  for (std::size_t n = 0; size > 0.0 && n < nodes; ++n)
  {
    const double* point = GetPoint(mesh, start + corners + static_cast<std::int64_t>(n));
    for (std::size_t p = 0; p < nodes; ++p)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        const double difference = (point[axis] - places[p][axis]) / size;
        sums[n * nodes + p] += difference * difference;
      }
    }
  }
}

/// The nearest place of each node; empty unless each place has one node.
std::vector<std::size_t> NearestPlaces(const std::vector<double>& sums, std::size_t nodes)
{
  std::vector<std::size_t> places(nodes);
  std::vector<bool> taken(nodes, false);
  for (std::size_t n = 0; n < nodes; ++n)
  {
    const auto row = sums.begin() + static_cast<std::ptrdiff_t>(n * nodes);
    const auto nearest = std::min_element(row, row + static_cast<std::ptrdiff_t>(nodes));
    places[n] = static_cast<std::size_t>(nearest - row);
    if (taken[places[n]])
    {
      return {};
    }
    taken[places[n]] = true;
  }
  return places;
}

}

void OrderMiddleNodes(CellMesh& mesh, std::size_t first, std::size_t last)
{
  if (first >= last)
  {
    return;
  }
  const QuadraticShape shape = Describe(mesh.Shapes[first]);
  const std::size_t nodes = shape.Nodes.size();
  std::vector<double> sums(nodes * nodes, 0.0);
  for (std::size_t cell = first; nodes > 0 && cell < last; ++cell)
  {
    AddDistances(mesh, mesh.Offsets[cell], shape, sums);
  }
  // From the sums over all cells, which share one order, so that a single distorted cell does not
  // matter.
  const std::vector<std::size_t> places = NearestPlaces(sums, nodes);
  std::vector<std::int64_t> ordered(nodes);
  for (std::size_t cell = first; !places.empty() && cell < last; ++cell)
  {
    const auto start =
      mesh.Vertices.begin() + mesh.Offsets[cell] + static_cast<std::ptrdiff_t>(shape.Corners);
    for (std::size_t n = 0; n < nodes; ++n)
    {
      ordered[places[n]] = *(start + static_cast<std::ptrdiff_t>(n));
    }
    std::copy(ordered.begin(), ordered.end(), start);
  }
}

}
