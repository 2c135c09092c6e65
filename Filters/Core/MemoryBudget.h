/**
 * @file MemoryBudget.h
 * @brief How much memory this process can still take, asked before much is allocated.
 */
#ifndef isthmus_MemoryBudget_h
#define isthmus_MemoryBudget_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <string>

namespace isthmus
{

/// Bytes: what the machine, the control group and the process' limits leave. Infinite where none of
/// them can be asked (systems other than Linux).
VTKISTHMUSFILTERSCORE_EXPORT double AvailableMemory();

/// "1.5 GB", "320 MB".
VTKISTHMUSFILTERSCORE_EXPORT std::string MemoryText(double bytes);

}

#endif
