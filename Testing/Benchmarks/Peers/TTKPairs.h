/**
 * @file TTKPairs.h
 * @brief Persistence pairs of any of TTK's triangulations by its Discrete Morse Sandwich
 * (P. Guillou, J. Vidal, J. Tierny, IEEE Trans. Visualization and Computer Graphics, 2023).
 *
 * For programs outside of Isthmus: it needs TTK's base layer (1.2 or newer).
 */
#ifndef isthmus_TTKPairs_h
#define isthmus_TTKPairs_h

#include "DiphaFiles.h"

#include <DiscreteMorseSandwich.h>
#include <OrderDisambiguation.h>

#include <limits>

namespace isthmus::testing
{

/// Pairs of positive persistence, by value; classes that never end die at infinity.
template <typename Triangulation>
DiphaPairs TTKPairs(Triangulation& triangulation, const std::vector<double>& values, int threads)
{
  ttk::DiscreteMorseSandwich sandwich;
  sandwich.setDebugLevel(0);
  sandwich.setThreadNumber(threads);
  sandwich.preconditionTriangulation(&triangulation);
  std::vector<ttk::SimplexId> order(values.size());
  ttk::sortVertices(order.size(), values.data(), static_cast<int*>(nullptr), order.data(), threads);
  if (sandwich.buildGradient(values.data(), 0, order.data(), triangulation) != 0)
  {
    throw std::runtime_error("TTK made no gradient.");
  }
  std::vector<ttk::DiscreteMorseSandwich::PersistencePair> found;
  sandwich.computePersistencePairs(found, order.data(), triangulation, false);
  const auto valueOf = [&](int dimension, ttk::SimplexId cell)
  {
    const ttk::SimplexId vertex =
      sandwich.getCellGreaterVertex(ttk::dcg::Cell{ dimension, cell }, triangulation);
    return values[static_cast<std::size_t>(vertex)];
  };
  DiphaPairs pairs;
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

#endif
