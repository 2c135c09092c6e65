// Persistence of a grid by TTK's Discrete Morse Sandwich on TTK's implicit triangulation of the
// grid, one thread: ttk_grid_persistence IN.complex OUT.diagram, both in DIPHA's format
// (DiphaFiles.h).
//
// Not part of Isthmus: it needs TTK's base layer.

#include "TTKPairs.h"

#include <ImplicitPreconditions.h>

#include <exception>
#include <iostream>

namespace
{

using Grid = ttk::ImplicitWithPreconditions;

isthmus::testing::DiphaPairs ComputePairs(const isthmus::testing::DiphaImage& image)
{
  Grid grid;
  grid.setDebugLevel(0);
  grid.setInputGrid(0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F,
    static_cast<ttk::SimplexId>(image.Dimensions[0]),
    static_cast<ttk::SimplexId>(image.Dimensions[1]),
    static_cast<ttk::SimplexId>(image.Dimensions[2]));
  grid.preconditionVerticesAndCells();
  return isthmus::testing::TTKPairs(grid, image.Values, 1);
}

}

int main(int count, char** words)
{
  try
  {
    if (count != 3)
    {
      throw std::runtime_error("usage: ttk_grid_persistence IN.complex OUT.diagram");
    }
    isthmus::testing::WriteDiphaPairs(
      words[2], ComputePairs(isthmus::testing::ReadDiphaImage(words[1])));
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
