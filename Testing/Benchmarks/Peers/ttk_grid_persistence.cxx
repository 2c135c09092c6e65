// Persistence of a grid by TTK's Discrete Morse Sandwich (P. Guillou, J. Vidal, J. Tierny, IEEE
// Trans. Visualization and Computer Graphics, 2023) on TTK's implicit triangulation of the grid,
// one thread: ttk_grid_persistence IN.complex OUT.diagram, both in DIPHA's format (DiphaFiles.h).
//
// Built outside of the tree by build.sh beside this file; no part of Isthmus.

#include "DiphaFiles.h"

#include <DiscreteMorseSandwich.h>
#include <ImplicitPreconditions.h>
#include <OrderDisambiguation.h>

#include <exception>
#include <iostream>
#include <limits>
#include <vector>

namespace
{

using Grid = ttk::ImplicitWithPreconditions;

isthmus::testing::DiphaPairs PairsOf(const isthmus::testing::DiphaImage& image)
{
  Grid grid;
  grid.setDebugLevel(0);
  grid.setInputGrid(0.0F, 0.0F, 0.0F, 1.0F, 1.0F, 1.0F,
    static_cast<ttk::SimplexId>(image.Dimensions[0]),
    static_cast<ttk::SimplexId>(image.Dimensions[1]),
    static_cast<ttk::SimplexId>(image.Dimensions[2]));
  grid.preconditionVerticesAndCells();
  ttk::DiscreteMorseSandwich sandwich;
  sandwich.setDebugLevel(0);
  sandwich.setThreadNumber(1);
  sandwich.preconditionTriangulation(&grid);
  std::vector<ttk::SimplexId> order(image.Values.size());
  ttk::sortVertices(order.size(), image.Values.data(), static_cast<int*>(nullptr), order.data(), 1);
  if (sandwich.buildGradient(image.Values.data(), 0, order.data(), grid) != 0)
  {
    throw std::runtime_error("TTK made no gradient.");
  }
  std::vector<ttk::DiscreteMorseSandwich::PersistencePair> found;
  sandwich.computePersistencePairs(found, order.data(), grid, false);
  const auto valueOf = [&](int dimension, ttk::SimplexId cell)
  {
    const ttk::SimplexId vertex =
      sandwich.getCellGreaterVertex(ttk::dcg::Cell{ dimension, cell }, grid);
    return image.Values[static_cast<std::size_t>(vertex)];
  };
  isthmus::testing::DiphaPairs pairs;
  for (const auto& pair : found)
  {
    const double birth = valueOf(pair.type, pair.birth);
    const double death =
      pair.death < 0 ? std::numeric_limits<double>::infinity() : valueOf(pair.type + 1, pair.death);
    if (birth != death)
    {
      pairs.push_back({ pair.type, birth, death });
    }
  }
  return pairs;
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
      words[2], PairsOf(isthmus::testing::ReadDiphaImage(words[1])));
    return 0;
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << "\n";
    return 1;
  }
}
