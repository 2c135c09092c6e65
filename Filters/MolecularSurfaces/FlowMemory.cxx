#include "MolecularSurfaces/FlowMemory.h"

#include "Core/AvailableMemory.h"
#include "MolecularSurfaces/FlowGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>
#include <stdexcept>

namespace isthmus
{
namespace
{

double Nodes(const DensityGrid& grid)
{
  const auto& n = grid.Dimensions;
  return static_cast<double>(n[0]) * static_cast<double>(n[1]) * static_cast<double>(n[2]);
}

/// The middle one of the balls' coordinates along each axis.
std::array<double, 3> Middle(const std::vector<Ball>& balls)
{
  std::array<double, 3> middle{};
  std::vector<double> places(balls.size());
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    std::transform(balls.begin(), balls.end(), places.begin(),
      [axis](const Ball& ball) { return ball.Centre[axis]; });
    const auto half = places.begin() + static_cast<std::ptrdiff_t>(places.size() / 2);
    std::nth_element(places.begin(), half, places.end());
    middle[axis] = *half;
  }
  return middle;
}

/// A sentence about the outermost atom if it is ten times as far out as nine tenths of them are.
std::string OutlierText(const std::vector<Ball>& balls)
{
  const std::array<double, 3> middle = Middle(balls);
  std::vector<double> distances(balls.size());
  std::transform(balls.begin(), balls.end(), distances.begin(),
    [&middle](const Ball& ball)
    {
      return std::hypot(
        ball.Centre[0] - middle[0], ball.Centre[1] - middle[1], ball.Centre[2] - middle[2]);
    });
  const auto farthest = std::max_element(distances.begin(), distances.end());
  const double far = *farthest;
  const auto atom = farthest - distances.begin();
  const auto most = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 9 / 10);
  std::nth_element(distances.begin(), most, distances.end());
  if (far < 10.0 * *most || balls.size() < 2)
  {
    return "";
  }
  std::ostringstream text;
  text << " Atom " << atom << " lies " << far << " from the middle of the others: is it meant?";
  return text.str();
}

}

double FlowBytes(const DensityGrid& grid)
{
  // Distance, Next, Ceiling, Floor, Pull: 4 each; Free 1, Near 1/8; an eighth of it all once more
  // for the coarser grid. The result's distances, and with S once more in the output.
  constexpr double field = (5 * 4 + 1 + 0.125) * 1.125;
  constexpr double result = 3 * 4;
  return FlowGrid::NodesFor(grid.Dimensions) * field + Nodes(grid) * result;
}

void CheckFlowMemory(const std::vector<Ball>& balls, const DensityGrid& grid)
{
  const double needed = FlowBytes(grid);
  const double available = AvailableMemory();
  // NaN or infinite sizes do not pass either; what std::size_t counts is beyond any memory.
  if (needed <= available && needed < 1e18)
  {
    return;
  }
  const auto& n = grid.Dimensions;
  std::ostringstream text;
  text << "A Spacing of " << grid.Spacing << " makes a grid of " << n[0] << " x " << n[1] << " x "
       << n[2] << " nodes, and the flow on it takes " << MemoryText(needed)
       << " of memory, of which " << MemoryText(available)
       << " are available: choose a Spacing of about "
       << 1.1 * grid.Spacing * std::cbrt(needed / std::max(available, 1e6)) << " or more."
       << OutlierText(balls);
  throw std::runtime_error(text.str());
}

}
