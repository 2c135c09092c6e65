/**
 * @file Ball.h
 * @brief An atom as the molecular filters use it.
 */
#ifndef isthmus_Ball_h
#define isthmus_Ball_h

#include <array>

namespace isthmus
{

/// Lengths in one unit, angstrom for molecules.
struct Ball
{
  std::array<double, 3> Centre;
  double Radius;
};

}

#endif
