#include "Electrostatics/SolverMemory.h"

#include "Core/MemoryBudget.h"

#include <stdexcept>

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
  const double available = AvailableMemory();
  if (needed > available)
  {
    throw std::runtime_error("A grid of " + size + " nodes takes about " + MemoryText(needed) +
      " of memory, and " + MemoryText(available) +
      " are available: choose a larger Spacing or a smaller Padding.");
  }
}

}
