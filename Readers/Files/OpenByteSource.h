/**
 * @file OpenByteSource.h
 * @brief From a path to the bytes of its file.
 */
#ifndef isthmus_OpenByteSource_h
#define isthmus_OpenByteSource_h

#include "Core/Progress.h"
#include "Files/ByteSource.h"
#include "vtkIsthmusReadersFilesModule.h" // for the export macro

#include <memory>
#include <string>

namespace isthmus
{

/// Opens a regular file.
/// @throws ReaderError for a missing, unreadable or empty one and for folders.
VTKISTHMUSREADERSFILES_EXPORT std::unique_ptr<ByteSource> OpenByteSource(const std::string& path);

/// All of the content, checksum checked.
/// @throws ReaderError as Read does, when it is cut, and when compressed content grows beyond 64
/// MiB and 16 times its file, as no text of numbers does, before memory is spent on it; and
/// std::bad_alloc.
VTKISTHMUSREADERSFILES_EXPORT std::string ReadAll(
  ByteSource& source, const ProgressCallback& progress = {});

}

#endif
