/**
 * @file MRCError.h
 * @brief Why a map could not be read, for callers who must tell the cases apart.
 */
#ifndef isthmus_MRCError_h
#define isthmus_MRCError_h

#include <stdexcept>
#include <string>

namespace isthmus
{

enum class MRCFailure
{
  NoSuchFile,
  CannotRead, ///< no permission, a folder, an input error
  NotAMap,    ///< the content is no MRC header
  Truncated,  ///< fewer bytes than the header describes
  Damaged,    ///< contradictory content, a failed checksum
  BadRequest, ///< what was asked for is not in the file
};

/// A sentence that says what is wrong, in which file, and what can be done.
class MRCError : public std::runtime_error
{
public:
  MRCError(MRCFailure kind, const std::string& sentence)
    : std::runtime_error(sentence)
    , Kind(kind)
  {
  }

  const MRCFailure Kind;
};

}

#endif
