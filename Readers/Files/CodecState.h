/**
 * @file CodecState.h
 * @brief How a decoder of compressed bytes stands.
 */
#ifndef isthmus_CodecState_h
#define isthmus_CodecState_h

namespace isthmus
{

/// How a codec stands after Step(), which moves its arguments past what it has used and written.
enum class CodecState
{
  Running,
  MemberEnd,
  Damaged
};

}

#endif
