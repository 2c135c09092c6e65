/**
 * @file SolverMemory.h
 * @brief Checks whether there is enough memory for a solution on a grid before anything of that
 * size is allocated.
 */
#ifndef isthmus_SolverMemory_h
#define isthmus_SolverMemory_h

#include <array>
#include <cstdint>

namespace isthmus
{

/// Throws std::runtime_error, with sizes, if the solution on this number of nodes takes more memory
/// than this process can have (assuming 130 bytes for each node; 80 to 104 were measured).
void RequireMemory(const std::array<std::int64_t, 3>& dimensions);

}

#endif
