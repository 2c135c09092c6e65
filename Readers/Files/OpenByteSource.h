/**
 * @file OpenByteSource.h
 * @brief Opens a plain, gzip- or bzip2-compressed file as a ByteSource.
 *
 * Compressed files are read from front to back.
 * Files of several consecutive members (bgzip, pbzip2) are read as one content, as by gunzip and
 * bunzip2. Memory: 256 KiB, plus 4 MB for bzip2 on one thread and 13 MB for each thread on several,
 * regardless of the size of the content.
 */
#ifndef isthmus_OpenByteSource_h
#define isthmus_OpenByteSource_h

#include "Core/Progress.h"
#include "Files/ByteSource.h"
#include "vtkIsthmusReadersFilesModule.h" // for the export macro

#include <memory>
#include <string>
#include <string_view>

namespace isthmus
{

/// Opens a regular file.
/// @throws ReaderError if it is missing, unreadable, empty or a folder.
VTKISTHMUSREADERSFILES_EXPORT std::unique_ptr<ByteSource> OpenByteSource(const std::string& path);

/**
 * The same for text files. A byte order mark of UTF-8 is skipped. If the first 64 KiB have carriage
 * returns but no newline (old Macintosh programs), each carriage return of the content is converted
 * to a newline.
 * @throws ReaderError as OpenByteSource does, and for UTF-16, with a specific message.
 */
VTKISTHMUSREADERSFILES_EXPORT std::unique_ptr<ByteSource> OpenTextSource(const std::string& path);

/// Whether content with this beginning is UTF-16 or UTF-32: it has a byte order mark, or every
/// second byte is 0.
VTKISTHMUSREADERSFILES_EXPORT bool BeginsAsUTF16(std::string_view begin);

/// Reads the whole content and verifies its checksum.
/// @throws ReaderError as Read does, if the content is truncated, and if compressed content exceeds
/// both 64 MiB and 16 times the file size, which is implausible for a text of numbers (this is
/// checked before memory is allocated); and std::bad_alloc.
VTKISTHMUSREADERSFILES_EXPORT std::string ReadAll(
  ByteSource& source, const ProgressCallback& progress = {});

}

#endif
