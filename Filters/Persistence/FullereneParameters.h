/**
 * @file FullereneParameters.h
 * @brief What the stability of molecules is asked for and what it gives.
 */
#ifndef isthmus_FullereneParameters_h
#define isthmus_FullereneParameters_h

#include "Core/TriangleMesh.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

/// A class of the growing balls: dimension 1 (a ring) or 2 (a cage), from distance to distance.
struct DistanceBar
{
  int Dimension = 1;
  double Birth = 0.0;
  double Death = 0.0;

  double Length() const { return this->Death - this->Birth; }
};

/// How the distance from the atoms is put on a grid. Lengths in the unit of the points.
struct GridDistanceParameters
{
  double Spacing = 0.2;      ///< of the nodes
  double Theta = 2.0;        ///< distances beyond are not looked at
  bool FastMarching = false; ///< as in the thesis, first order; else the exact distance
};

/// One row of the table.
struct FullereneStability
{
  std::int64_t Atoms = 0;
  std::int64_t Bars = 0;         ///< of dimension 1, at least FilterDelta long
  double Integral = 0.0;         ///< of beta_1 over distance: sum of the lengths of all bars
  double FilteredIntegral = 0.0; ///< of those at least FilterDelta long
  double Cavity = 0.0;           ///< length of the longest bar of dimension 2
  double BoxLength = 0.0;        ///< longest side of the box round the atoms
  double EnergyProxy = 0.0;      ///< -FilteredIntegral / Atoms
};

}

#endif
