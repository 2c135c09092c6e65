/**
 * @file PoreCourse.h
 * @brief Planes across a pore, and the largest balls in them one after the other.
 */
#ifndef isthmus_PoreCourse_h
#define isthmus_PoreCourse_h

#include "Core/Progress.h"
#include "Pockets/PlaneBall.h"

#include <cmath>

namespace isthmus
{

/// Planes to work off, and where in each the way is, as far as known.
struct Course
{
  std::vector<Plane> Planes;
  std::vector<Point3> Way;
  double Least = -HUGE_VAL; ///< the way is at least that wide
  double Enough = 0.0;      ///< radius beyond which it need not be known
  double End = 0.0;         ///< radius beyond which the pore ends
};

/// `way` at equal distances. Throws std::invalid_argument where that takes more planes than anybody
/// waits for.
std::vector<Point3> Resample(const std::vector<Point3>& way, double spacing);

/// Planes across `points`, smoothed by a Gaussian of that width (in points).
Course CourseAlong(const std::vector<Point3>& points, double width);

/// Of `p` in `plane`.
Point3 Foot(const Plane& plane, const Point3& p);

/// The balls in the planes after (`step` 1) or before (-1) the one `from`, whose ball is known, as
/// far as the pore goes.
std::vector<PlaneBall> MarchAlong(const AtomField& atoms, const Course& course, std::size_t from,
  std::int64_t step, PlaneBall ball, const ProgressCallback& progress);

}

#endif
