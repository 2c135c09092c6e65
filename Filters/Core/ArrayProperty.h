/**
 * @file ArrayProperty.h
 * @brief Macro for filters whose input arrays have names by default, as ParaView's panels set them.
 */
#ifndef isthmus_ArrayProperty_h
#define isthmus_ArrayProperty_h

/// The setter that panels of such filters call; in C++ and Python, SetInputArrayToProcess is. A
/// property of an array has five values in ParaView, the arguments of SetInputArrayToProcess. For a
/// name by default, ParaView 5.11 expects that name as the first of them as well, where versions
/// from 6.1 on expect a number unless it is declared as a string. So here the second value is the
/// number of the array, and the third is not used. `association` is one digit, or empty for points.
#define ISTHMUS_NAMED_INPUT_ARRAYS()                                                               \
  void SetNamedInputArray(                                                                         \
    const char*, const char* index, const char*, const char* association, const char* array)       \
  {                                                                                                \
    this->SetInputArrayToProcess(                                                                  \
      *index - '0', 0, 0, (association && *association) ? *association - '0' : 0, array);          \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
