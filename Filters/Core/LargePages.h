/**
 * @file LargePages.h
 * @brief Memory of whole volumes in pages of 2 MiB instead of 4 KiB, where the system provides
 * them.
 */
#ifndef isthmus_LargePages_h
#define isthmus_LargePages_h

#include "vtkIsthmusFiltersCoreModule.h" // for the export macro

#include <cstddef>

namespace isthmus
{

/**
 * Requests large pages for the `bytes` at `data`, which must be newly allocated and will all be
 * written. This is only a hint: below 8 MiB, on systems other than Linux and where large pages are
 * switched off, nothing happens. Values are never changed.
 */
VTKISTHMUSFILTERSCORE_EXPORT void AdviseLargePages(void* data, std::size_t bytes);

/// The same for all values of a new vtkDataArray.
template <typename Array>
void AdviseLargePages(Array* array)
{
  AdviseLargePages(array->GetVoidPointer(0),
    static_cast<std::size_t>(array->GetNumberOfValues()) *
      static_cast<std::size_t>(array->GetDataTypeSize()));
}

}

#endif
