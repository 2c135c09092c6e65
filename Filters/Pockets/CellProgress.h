/**
 * @file CellProgress.h
 * @brief Progress of loops over tetrahedra, triangles or edges on one thread.
 */
#ifndef isthmus_CellProgress_h
#define isthmus_CellProgress_h

#include "Core/Progress.h"

#include <cstddef>

namespace isthmus
{

/// Reports the fraction that `done` of `count` cells are, at every 4096th. @throws Cancelled
inline void ReportCells(const ProgressCallback& progress, std::size_t done, std::size_t count)
{
  if (done % 4096 == 0)
  {
    Report(progress, static_cast<double>(done) / static_cast<double>(count));
  }
}

}

#endif
