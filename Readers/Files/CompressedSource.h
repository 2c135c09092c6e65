/**
 * @file CompressedSource.h
 * @brief gzip and bzip2 files as byte sources that are read from front to back.
 *
 * Files of several members one after the other (bgzip, pbzip2) are one content, as gunzip and
 * bunzip2 read them. Memory: 256 KiB, plus 4 MB for bzip2 on one thread and 13 MB a thread on
 * several, however large the content.
 */
#ifndef isthmus_CompressedSource_h
#define isthmus_CompressedSource_h

#include "Files/ByteSource.h"
#include "Files/PlainFile.h"

#include <memory>

namespace isthmus
{

/// @throws std::bad_alloc; what they return throws ReaderError as ByteSource says.
std::unique_ptr<ByteSource> OpenGzip(PlainFile file);
std::unique_ptr<ByteSource> OpenBzip2(PlainFile file);

}

#endif
