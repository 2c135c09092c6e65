/**
 * @file CheckedProduct.h
 * @brief Products of counts from files, which may exceed the range of their type.
 */
#ifndef isthmus_CheckedProduct_h
#define isthmus_CheckedProduct_h

#include <limits>

namespace isthmus
{

/// Multiplies `value` by `factor`; returns false, and leaves it unchanged, if the product is beyond
/// the type's range. @pre neither is negative.
template <typename Integer>
bool MultiplyInRange(Integer& value, Integer factor)
{
  if (factor > 0 && value > std::numeric_limits<Integer>::max() / factor)
  {
    return false;
  }
  value *= factor;
  return true;
}

}

#endif
