/**
 * @file Deprecation.h
 * @brief Deprecated methods and aliases: compilers and VTK's Python wrappers warn about them.
 *
 * Names deprecated before 1.0.0 work, with a warning, in all 1.0.x and are removed in 1.1.0;
 * CHANGELOG.md lists them. A deprecated method calls the one that replaced it:
 *
 *     ISTHMUS_DEPRECATED("1.0.0", "use SetLevel")
 *     void SetIsoValue(double level) { this->SetLevel(level); }
 *
 * C++ code that calls it gets a compiler warning, Python code a DeprecationWarning. For a renamed
 * enumerator (Python cannot warn about these):
 *
 *     INSIDE ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Inside") = Inside
 */
#ifndef isthmus_Deprecation_h
#define isthmus_Deprecation_h

/// Placed before a declaration: the version that deprecated it and what to use instead.
#if defined(VTK_WRAPPING_CXX)
#define ISTHMUS_DEPRECATED(version, instead) // generated code calls every method
#elif defined(__VTK_WRAP__)
#define ISTHMUS_DEPRECATED(version, instead) [[vtk::deprecated(instead, version)]]
#else
#define ISTHMUS_DEPRECATED(version, instead)                                                       \
  [[deprecated(instead "; deprecated in Isthmus " version ", removed in 1.1.0")]]
#endif

/// Placed after the name of an enumerator.
#if defined(VTK_WRAPPING_CXX) || defined(__VTK_WRAP__)
#define ISTHMUS_DEPRECATED_ENUMERATOR(version, instead)
#else
#define ISTHMUS_DEPRECATED_ENUMERATOR(version, instead) ISTHMUS_DEPRECATED(version, instead)
#endif

#endif
