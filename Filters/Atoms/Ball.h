/**
 * @file Ball.h
 * @brief The representation of an atom in the molecular filters.
 */
#ifndef isthmus_Ball_h
#define isthmus_Ball_h

#include <array>

namespace isthmus
{

/// All lengths are in the same unit, angstrom for molecules.
struct Ball
{
  std::array<double, 3> Center;
  double Radius;
};

}

#endif
