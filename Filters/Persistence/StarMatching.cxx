#include "Persistence/StarMatching.h"

namespace isthmus
{
namespace
{

std::array<std::array<int, 3>, 27> MakeSteps()
{
  std::array<std::array<int, 3>, 27> steps{};
  std::size_t next[4] = { 26, 0, 6, 18 };
  for (int z = -1; z <= 1; ++z)
  {
    for (int y = -1; y <= 1; ++y)
    {
      for (int x = -1; x <= 1; ++x)
      {
        steps[next[(x != 0) + (y != 0) + (z != 0)]++] = { x, y, z };
      }
    }
  }
  return steps;
}

std::array<std::int8_t, 27> MakeDirections()
{
  std::array<std::int8_t, 27> directions{};
  const auto steps = MakeSteps();
  for (std::size_t cell = 0; cell < 27; ++cell)
  {
    directions[cell] = static_cast<std::int8_t>(
      steps[cell][0] + 1 + 3 * (steps[cell][1] + 1) + 9 * (steps[cell][2] + 1));
  }
  return directions;
}

std::array<std::uint8_t, 27> MakeCells()
{
  std::array<std::uint8_t, 27> cells{};
  const auto directions = MakeDirections();
  for (std::size_t cell = 0; cell < 27; ++cell)
  {
    cells[static_cast<unsigned char>(directions[cell])] = static_cast<std::uint8_t>(cell);
  }
  return cells;
}

/// The facets of a cell that have the node as a corner, as bits.
std::uint32_t FindFacets(std::size_t cell)
{
  const auto steps = MakeSteps();
  const auto cells = MakeCells();
  std::uint32_t facets = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    if (steps[cell][axis] != 0)
    {
      auto step = steps[cell];
      step[axis] = 0;
      facets |=
        1U << cells[static_cast<std::size_t>(step[0] + 1 + 3 * (step[1] + 1) + 9 * (step[2] + 1))];
    }
  }
  return facets;
}

std::array<std::uint32_t, 27> MakeFacets()
{
  std::array<std::uint32_t, 27> facets{};
  for (std::size_t cell = 0; cell < 27; ++cell)
  {
    facets[cell] = FindFacets(cell);
  }
  return facets;
}

const std::array<std::uint32_t, 27> Facets = MakeFacets();

std::array<std::array<std::uint8_t, 2>, 12> MakeFaceEdges()
{
  std::array<std::array<std::uint8_t, 2>, 12> edges{};
  const auto steps = MakeSteps();
  const auto cells = MakeCells();
  for (std::size_t face = 0; face < 12; ++face)
  {
    std::size_t found = 0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      std::array<int, 3> step{ 0, 0, 0 };
      step[axis] = steps[face + 6][axis];
      if (step[axis] != 0)
      {
        edges[face][found++] =
          cells[static_cast<std::size_t>(step[0] + 1 + 3 * (step[1] + 1) + 9 * (step[2] + 1))];
      }
    }
  }
  return edges;
}

/// Cells [first, last) whose facets are all among `present`.
std::uint32_t Closed(std::uint32_t present, std::size_t first, std::size_t last)
{
  std::uint32_t cells = 0;
  for (std::size_t cell = first; cell < last; ++cell)
  {
    const std::uint32_t facets = FindFacets(cell);
    cells |= (facets & present) == facets ? 1U << cell : 0U;
  }
  return cells;
}

std::array<std::uint32_t, 64> MakeFacesOfEdges()
{
  std::array<std::uint32_t, 64> faces{};
  for (std::uint32_t edges = 0; edges < 64; ++edges)
  {
    faces[edges] = Closed(edges, Star::FirstFace, Star::FirstCube);
  }
  return faces;
}

std::array<std::uint32_t, 4096> MakeCubesOfFaces()
{
  std::array<std::uint32_t, 4096> cubes{};
  for (std::uint32_t faces = 0; faces < 4096; ++faces)
  {
    cubes[faces] = Closed(faces << Star::FirstFace, Star::FirstCube, Star::Node);
  }
  return cubes;
}

bool IsOneBit(std::uint32_t bits)
{
  return bits != 0 && (bits & (bits - 1)) == 0;
}

std::uint8_t LowestBit(std::uint32_t bits)
{
  std::uint8_t at = 0;
  while ((bits >> at & 1U) == 0)
  {
    ++at;
  }
  return at;
}

/// Matches a cell with its only unmatched facet, if there is such a cell among `open`.
bool Expand(StarMatching& matching, std::uint32_t& open)
{
  for (std::size_t cell = 0; cell < Star::Node; ++cell)
  {
    const std::uint32_t facets = Facets[cell] & open;
    if ((open >> cell & 1U) != 0 && IsOneBit(facets))
    {
      const std::uint8_t facet = LowestBit(facets);
      matching.Partner[cell] = facet;
      matching.Partner[facet] = static_cast<std::uint8_t>(cell);
      open &= ~(facets | 1U << cell);
      return true;
    }
  }
  return false;
}

}

namespace Star
{
const std::array<std::array<int, 3>, 27> Steps = MakeSteps();
const std::array<std::uint8_t, 27> GetCellId = MakeCells();
const std::array<std::int8_t, 27> DirectionOf = MakeDirections();
const std::array<std::array<std::uint8_t, 2>, 12> FaceEdges = MakeFaceEdges();
const std::array<std::uint32_t, 64> FacesOfEdges = MakeFacesOfEdges();
const std::array<std::uint32_t, 4096> CubesOfFaces = MakeCubesOfFaces();
}

StarMatching MatchStar(std::uint32_t mask)
{
  StarMatching matching;
  matching.Partner.fill(Star::Absent);
  std::uint32_t open = mask | 1U << Star::Node;
  for (int cell = 0; cell <= Star::Node; ++cell)
  {
    const int sign = Star::Dimension(cell) % 2 == 0 ? 1 : -1;
    matching.EulerNumber += (open >> cell & 1U) != 0 ? sign : 0;
  }
  if ((mask & 63U) == 0)
  {
    // No lower neighbour: a minimum, alone in its star.
    matching.Partner[Star::Node] = Star::Node;
    matching.Critical = 1U << Star::Node;
    return matching;
  }
  // The node goes with the first edge; after that, edges count as having no facet.
  while (open != 0)
  {
    // Any order is optimal, as the link is a part of the surface of an octahedron.
    if (!Expand(matching, open))
    {
      const std::uint8_t cell = LowestBit(open);
      matching.Partner[cell] = cell;
      matching.Critical |= 1U << cell;
      open &= ~(1U << cell);
    }
  }
  for (std::size_t edge = 0; edge < Star::FirstFace; ++edge)
  {
    const std::uint8_t partner = matching.Partner[edge];
    const bool isFace = partner >= Star::FirstFace && partner < Star::FirstCube;
    matching.EdgesWithFaces |= isFace ? 1U << edge : 0U;
  }
  return matching;
}

}
