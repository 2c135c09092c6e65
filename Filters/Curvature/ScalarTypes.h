/**
 * @file ScalarTypes.h
 * @brief The types a grid may store, for explicit instantiation of templates on them.
 */
#ifndef isthmus_ScalarTypes_h
#define isthmus_ScalarTypes_h

#include <type_traits>

/// Expands `instantiate(type)` for each type.
#define ISTHMUS_FOR_EACH_SCALAR_TYPE(instantiate)                                                  \
  instantiate(char);                                                                               \
  instantiate(signed char);                                                                        \
  instantiate(unsigned char);                                                                      \
  instantiate(short);                                                                              \
  instantiate(unsigned short);                                                                     \
  instantiate(int);                                                                                \
  instantiate(unsigned int);                                                                       \
  instantiate(long);                                                                               \
  instantiate(unsigned long);                                                                      \
  instantiate(long long);                                                                          \
  instantiate(unsigned long long);                                                                 \
  instantiate(float);                                                                              \
  instantiate(double)

namespace isthmus
{

/// Type in which results on a grid of `T` are stored: double for double, float for all others.
template <typename T>
using ResultType = std::conditional_t<std::is_same_v<T, double>, double, float>;

}

#endif
