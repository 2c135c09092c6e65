/**
 * @file NodeLoops.h
 * @brief Loops over the nodes of a box.
 */
#ifndef isthmus_NodeLoops_h
#define isthmus_NodeLoops_h

#include "Core/ParallelFor.h"
#include "Electrostatics/LevelFunction.h"

namespace isthmus
{

/// Calls `each(i)` for all nodes i below n, in parallel.
template <typename Each>
void ForEachNode(std::size_t n, Each&& each)
{
  ParallelFor(0, static_cast<std::int64_t>(n), 1 << 15,
    [&](std::int64_t first, std::int64_t last)
    {
      for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i)
      {
        each(i);
      }
    });
}

inline bool OnBorder(const SolverBox& box, std::int64_t node)
{
  const auto& n = box.Dimensions;
  const std::int64_t at[3] = { node % n[0], node / n[0] % n[1], node / (n[0] * n[1]) };
  for (std::size_t a = 0; a < 3; ++a)
  {
    if (at[a] == 0 || at[a] == n[a] - 1)
    {
      return true;
    }
  }
  return false;
}

}

#endif
