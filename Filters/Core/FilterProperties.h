/**
 * @file FilterProperties.h
 * @brief Macros for properties that filters with different base classes share: each declares a
 * property and its member in one line.
 *
 * They are macros because VTK wraps only what a class and its first base class declare. Use them at
 * the end of the public part of a class: what follows is protected.
 */
#ifndef isthmus_FilterProperties_h
#define isthmus_FilterProperties_h

#include <ostream> // for what prints them: VTK's wrappers include none

#define ISTHMUS_PROPERTY(type, name, value)                                                        \
public:                                                                                            \
  vtkSetMacro(name, type);                                                                         \
  vtkGetMacro(name, type);                                                                         \
                                                                                                   \
protected:                                                                                         \
  type name = value

/// A Boolean property.
#define ISTHMUS_SWITCH(name, value)                                                                \
public:                                                                                            \
  vtkBooleanMacro(name, bool);                                                                     \
  ISTHMUS_PROPERTY(bool, name, value)

#endif
