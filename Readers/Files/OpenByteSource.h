/**
 * @file OpenByteSource.h
 * @brief Opens a plain, gzip- or bzip2-compressed file as a ByteSource.
 *
 * Compressed files are read from front to back.
 * Files of several members one after the other (bgzip, pbzip2) are one content, as gunzip and
 * bunzip2 read them. Memory: 256 KiB, plus 4 MB for bzip2 on one thread and 13 MB a thread on
 * several, however large the content.
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
/// @throws ReaderError for a missing, unreadable or empty one and for folders.
VTKISTHMUSREADERSFILES_EXPORT std::unique_ptr<ByteSource> OpenByteSource(const std::string& path);

/**
 * The same for a text: without the byte order mark of UTF-8, where there is one; and where the
 * first 64 KiB have carriage returns but no newline (old Macintosh programs), each carriage return
 * of the content is given as a newline.
 * @throws ReaderError as OpenByteSource does, and for UTF-16, which has a message of its own.
 */
VTKISTHMUSREADERSFILES_EXPORT std::unique_ptr<ByteSource> OpenTextSource(const std::string& path);

/// Whether a content that begins so is UTF-16 or UTF-32: a byte order mark, or every other byte 0.
VTKISTHMUSREADERSFILES_EXPORT bool BeginsAsUTF16(std::string_view begin);

/// All of the content, checksum checked.
/// @throws ReaderError as Read does, when it is cut, and when compressed content grows beyond 64
/// MiB and 16 times its file, which no text of numbers does, before memory is allocated for it; and
/// std::bad_alloc.
VTKISTHMUSREADERSFILES_EXPORT std::string ReadAll(
  ByteSource& source, const ProgressCallback& progress = {});

}

#endif
