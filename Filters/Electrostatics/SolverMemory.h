/**
 * @file SolverMemory.h
 * @brief Whether there is memory for a solution on a grid, asked before anything of its size is
 * made.
 */
#ifndef isthmus_SolverMemory_h
#define isthmus_SolverMemory_h

#include <array>
#include <cstdint>

namespace isthmus
{

/// Throws std::runtime_error, with sizes, where the solution on so many nodes takes more memory
/// than this process can have (130 bytes a node are counted; 80 to 104 were measured).
void RequireMemory(const std::array<std::int64_t, 3>& dimensions);

}

#endif
