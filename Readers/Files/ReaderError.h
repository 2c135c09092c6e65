/**
 * @file ReaderError.h
 * @brief The reason why a file could not be read, for callers that must distinguish the cases.
 */
#ifndef isthmus_ReaderError_h
#define isthmus_ReaderError_h

#include <stdexcept>
#include <string>

namespace isthmus
{

enum class ReaderFailure
{
  NoSuchFile,
  CannotRead,    ///< no permission, a folder, an input error
  ForeignFormat, ///< the content is not of this kind of file
  Truncated,     ///< fewer bytes than the header describes
  Damaged,       ///< contradictory content, a failed checksum
  BadRequest,    ///< the requested part is not in the file
};

/// A message that states what is wrong, in which file, and what can be done.
class ReaderError : public std::runtime_error
{
public:
  ReaderError(ReaderFailure kind, const std::string& sentence)
    : std::runtime_error(sentence)
    , Kind(kind)
  {
  }

  const ReaderFailure Kind;
};

}

#endif
