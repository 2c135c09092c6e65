/**
 * @file SystemMemory.h
 * @brief How much memory the operating system has; one source for each system.
 */
#ifndef isthmus_SystemMemory_h
#define isthmus_SystemMemory_h

namespace isthmus
{

/// Bytes of the machine's memory; infinite where the system does not say.
double TotalMemory();

/// Bytes of memory that processes may still take, within the limits of the machine and of a control
/// group; infinite where the system does not say.
double FreeMemory();

/// Bytes that this process may add to its address space (ulimit -v); infinite without a limit.
double AddressSpaceLeft();

}

#endif
