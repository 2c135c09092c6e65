/**
 * @file Pi.h
 * @brief A circle's circumference over its diameter; C++17 has no name for it.
 */
#ifndef isthmus_Pi_h
#define isthmus_Pi_h

namespace isthmus
{

constexpr double Pi = 3.14159265358979323846;

}

#endif
