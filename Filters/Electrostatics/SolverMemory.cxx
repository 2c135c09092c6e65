#include "Electrostatics/SolverMemory.h"

#include "Core/MemoryBudget.h"

#include <string>

namespace isthmus
{

void RequireMemory(const std::array<std::int64_t, 3>& dimensions)
{
  double needed = 130.0;
  std::string size;
  for (const std::int64_t n : dimensions)
  {
    needed *= static_cast<double>(n);
    size += (size.empty() ? "" : " x ") + std::to_string(n);
  }
  MemoryBudget().Require(
    needed, "A grid of " + size + " nodes", "choose a larger Spacing or a smaller Padding");
}

}
