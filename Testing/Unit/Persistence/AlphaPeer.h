/**
 * @file AlphaPeer.h
 * @brief Bars of points by GUDHI's alpha complex, for tests.
 */
#ifndef isthmus_AlphaPeer_h
#define isthmus_AlphaPeer_h

#include "Persistence/FullereneStability.h"

#if __has_include(<gudhi/Alpha_complex_3d.h>)
#define ISTHMUS_HAS_GUDHI_ALPHA 1
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wextra"
#include <gudhi/Alpha_complex_3d.h>
#include <gudhi/Persistent_cohomology.h>
#include <gudhi/Simplex_tree.h>
#pragma GCC diagnostic pop
#else
#define ISTHMUS_HAS_GUDHI_ALPHA 0
#endif

#include <cmath>
#include <vector>

namespace isthmus::testing
{

#if ISTHMUS_HAS_GUDHI_ALPHA

/// Dimensions 1 and 2, radii instead of their squares.
inline std::vector<DistanceBar> AlphaBarsOfGudhi(const std::vector<Point3>& atoms)
{
  using Alpha = Gudhi::alpha_complex::Alpha_complex_3d<Gudhi::alpha_complex::complexity::EXACT>;
  using Tree = Gudhi::Simplex_tree<>;
  using Cohomology = Gudhi::persistent_cohomology::Persistent_cohomology<Tree,
    Gudhi::persistent_cohomology::Field_Zp>;
  std::vector<Alpha::Bare_point_3> points;
  for (const Point3& atom : atoms)
  {
    points.emplace_back(atom[0], atom[1], atom[2]);
  }
  Alpha alpha(points);
  Tree tree;
  alpha.create_complex(tree);
  Cohomology cohomology(tree, true);
  cohomology.init_coefficients(2);
  cohomology.compute_persistent_cohomology(0.0);
  std::vector<DistanceBar> bars;
  for (const int dimension : { 1, 2 })
  {
    for (const auto& bar : cohomology.intervals_in_dimension(dimension))
    {
      bars.push_back({ dimension, std::sqrt(bar.first), std::sqrt(bar.second) });
    }
  }
  return bars;
}

#endif

}

#endif
