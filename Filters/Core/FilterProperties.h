/**
 * @file FilterProperties.h
 * @brief For properties that filters of different bases share: declared in one line, with the
 * member.
 *
 * Macros, since VTK wraps for Python and for panels what a class and its first base declare. They
 * stand in a class at the end of its public part: what follows is protected.
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

/// A property that is on or off.
#define ISTHMUS_SWITCH(name, value)                                                                \
public:                                                                                            \
  vtkBooleanMacro(name, bool);                                                                     \
  ISTHMUS_PROPERTY(bool, name, value)

#endif
