/**
 * @file ArrayProperty.h
 * @brief Macro for the setter of an input array that has a name by default, as ParaView's panels
 * call it.
 */
#ifndef isthmus_ArrayProperty_h
#define isthmus_ArrayProperty_h

/// `Set##name`: array `index` of those that the filter processes. A property of an array has five
/// values in ParaView, the arguments of SetInputArrayToProcess. Where it has a default name,
/// ParaView 5.11 expects that name as the first value as well, which from 6.1 on must be a number
/// unless it is declared as a string. `association` is one digit, or empty for points. In C++ and
/// Python use SetInputArrayToProcess.
#define ISTHMUS_ARRAY_PROPERTY(name, index)                                                        \
  void Set##name(                                                                                  \
    const char*, const char*, const char*, const char* association, const char* array)             \
  {                                                                                                \
    this->SetInputArrayToProcess(                                                                  \
      index, 0, 0, (association && *association) ? *association - '0' : 0, array);                 \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

#endif
