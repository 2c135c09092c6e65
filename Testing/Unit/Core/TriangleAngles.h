/**
 * @file TriangleAngles.h
 * @brief The smallest and the largest angle of a surface's triangles.
 */
#ifndef isthmus_TriangleAngles_h
#define isthmus_TriangleAngles_h

#include "Core/Geometry.h"
#include "Core/TriangleMesh.h"

#include <algorithm>
#include <cmath>

namespace isthmus::testing
{

/// In degrees; 0 and 180 where corners coincide.
struct TriangleAngles
{
  double Smallest = 180.0;
  double Largest = 0.0;

  explicit TriangleAngles(const TriangleMesh& mesh)
  {
    for (const Triangle& t : mesh.Triangles)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        const auto at = [&](std::size_t k)
        { return mesh.Points[static_cast<std::size_t>(t[(c + k) % 3])]; };
        const Point3 u = at(1) - at(0);
        const Point3 v = at(2) - at(0);
        const Point3 n = Cross(u, v);
        const double angle = std::atan2(std::sqrt(Dot(n, n)), Dot(u, v)) * 180.0 / Pi;
        this->Smallest = std::min(this->Smallest, angle);
        this->Largest = std::max(this->Largest, angle);
      }
    }
  }
};

}

#endif
