/**
 * @file Bounds3.h
 * @brief Boxes along the axes.
 */
#ifndef isthmus_Bounds3_h
#define isthmus_Bounds3_h

#include "Core/Point3.h"

#include <algorithm>
#include <cstddef>

namespace isthmus
{

/// Axis-aligned box.
struct Bounds3
{
  Point3 Min{ 0, 0, 0 };
  Point3 Max{ 0, 0, 0 };

  double Diagonal() const { return Distance(this->Min, this->Max); }

  bool Contains(const Bounds3& other) const
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      if (other.Min[a] < this->Min[a] || other.Max[a] > this->Max[a])
      {
        return false;
      }
    }
    return true;
  }

  void Add(const Point3& p)
  {
    for (std::size_t a = 0; a < 3; ++a)
    {
      this->Min[a] = std::min(this->Min[a], p[a]);
      this->Max[a] = std::max(this->Max[a], p[a]);
    }
  }
};

}

#endif
