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

#include <vtkWrappingHints.h>

#include <ostream> // for printing: VTK's wrappers do not include them

#define ISTHMUS_PROPERTY(type, name, value)                                                        \
public:                                                                                            \
  vtkSetMacro(name, type);                                                                         \
  vtkGetMacro(name, type);                                                                         \
                                                                                                   \
protected:                                                                                         \
  type name = value

/// A property that is the member `name` of `parameters`, a struct of the algorithm that the class
/// holds. The initialiser there is the only default. An enumeration of the algorithm is an int
/// here, as in all of VTK; the algorithm checks its range with RequireChoice.
#define ISTHMUS_PARAMETER_OF(parameters, name, type)                                               \
  virtual void Set##name(type value)                                                               \
  {                                                                                                \
    using Member = decltype(this->parameters.name);                                                \
    if (this->parameters.name != static_cast<Member>(value))                                       \
    {                                                                                              \
      this->parameters.name = static_cast<Member>(value);                                          \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual type Get##name()                                                                         \
  {                                                                                                \
    return static_cast<type>(this->parameters.name);                                               \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

/// The same for a class that holds one struct, as `Parameters`.
#define ISTHMUS_PARAMETER(name, type) ISTHMUS_PARAMETER_OF(Parameters, name, type)

/// Both for a Boolean, with On and Off.
#define ISTHMUS_PARAMETER_SWITCH_OF(parameters, name)                                              \
  vtkBooleanMacro(name, bool);                                                                     \
  ISTHMUS_PARAMETER_OF(parameters, name, bool)
#define ISTHMUS_PARAMETER_SWITCH(name) ISTHMUS_PARAMETER_SWITCH_OF(Parameters, name)

/// The same for three numbers, e.g. a point.
#define ISTHMUS_PARAMETER_VECTOR3(name, type)                                                      \
  virtual void Set##name(type x, type y, type z)                                                   \
  {                                                                                                \
    auto& own = this->Parameters.name;                                                             \
    if (own[0] != x || own[1] != y || own[2] != z)                                                 \
    {                                                                                              \
      own = { x, y, z };                                                                           \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual void Set##name(const type value[3])                                                      \
  {                                                                                                \
    this->Set##name(value[0], value[1], value[2]);                                                 \
  }                                                                                                \
  virtual type* Get##name() VTK_SIZEHINT(3)                                                        \
  {                                                                                                \
    return &this->Parameters.name[0];                                                              \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

/// The same for four numbers.
#define ISTHMUS_PARAMETER_VECTOR4(name, type)                                                      \
  virtual void Set##name(type x, type y, type z, type w)                                           \
  {                                                                                                \
    auto& own = this->Parameters.name;                                                             \
    if (own[0] != x || own[1] != y || own[2] != z || own[3] != w)                                  \
    {                                                                                              \
      own = { x, y, z, w };                                                                        \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  virtual void Set##name(const type value[4])                                                      \
  {                                                                                                \
    this->Set##name(value[0], value[1], value[2], value[3]);                                       \
  }                                                                                                \
  virtual type* Get##name() VTK_SIZEHINT(4)                                                        \
  {                                                                                                \
    return &this->Parameters.name[0];                                                              \
  }                                                                                                \
  static_assert(true, "takes a semicolon")

/// A Boolean property.
#define ISTHMUS_SWITCH(name, value)                                                                \
public:                                                                                            \
  vtkBooleanMacro(name, bool);                                                                     \
  ISTHMUS_PROPERTY(bool, name, value)

/// A number that the filter chooses unless it is given: `Set##name` also switches `Automatic##name`
/// off, which is on by default. A panel has both properties and sends them in any order: its
/// command is `Set##name##Only`, and the plugin switches the other property off
/// (IsthmusInitialization.cxx).
#define ISTHMUS_AUTOMATIC_UNLESS_GIVEN(name)                                                       \
public:                                                                                            \
  virtual void Set##name(double value)                                                             \
  {                                                                                                \
    this->Set##name##Only(value);                                                                  \
    this->SetAutomatic##name(false);                                                               \
  }                                                                                                \
  virtual void Set##name##Only(double value)                                                       \
  {                                                                                                \
    if (this->name != value)                                                                       \
    {                                                                                              \
      this->name = value;                                                                          \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  vtkGetMacro(name, double);                                                                       \
                                                                                                   \
protected:                                                                                         \
  double name = 0.0;                                                                               \
  ISTHMUS_SWITCH(Automatic##name, true)

/// The same for a range, by default from 0 to 1.
#define ISTHMUS_AUTOMATIC_RANGE_UNLESS_GIVEN(name)                                                 \
public:                                                                                            \
  virtual void Set##name(double low, double high)                                                  \
  {                                                                                                \
    this->Set##name##Only(low, high);                                                              \
    this->SetAutomatic##name(false);                                                               \
  }                                                                                                \
  virtual void Set##name(const double range[2])                                                    \
  {                                                                                                \
    this->Set##name(range[0], range[1]);                                                           \
  }                                                                                                \
  virtual void Set##name##Only(double low, double high)                                            \
  {                                                                                                \
    if (this->name[0] != low || this->name[1] != high)                                             \
    {                                                                                              \
      this->name[0] = low;                                                                         \
      this->name[1] = high;                                                                        \
      this->Modified();                                                                            \
    }                                                                                              \
  }                                                                                                \
  vtkGetVector2Macro(name, double);                                                                \
                                                                                                   \
protected:                                                                                         \
  double name[2] = { 0.0, 1.0 };                                                                   \
  ISTHMUS_SWITCH(Automatic##name, true)

#endif
