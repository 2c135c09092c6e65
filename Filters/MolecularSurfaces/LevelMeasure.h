/**
 * @file LevelMeasure.h
 * @brief Area and volume of the surface given by the distances of a flow.
 */
#ifndef isthmus_LevelMeasure_h
#define isthmus_LevelMeasure_h

#include "MolecularSurfaces/FlowField.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h"

namespace isthmus
{

struct LevelMeasure
{
  double Area = 0.0;   ///< square angstrom
  double Volume = 0.0; ///< cubic angstrom

  LevelMeasure& operator+=(const LevelMeasure& other)
  {
    this->Area += other.Area;
    this->Volume += other.Volume;
    return *this;
  }
};

/// Measures the level 0 of the distances, linear in the six tetrahedra of each cell; the volume is
/// the sum of cones from the middle of the grid. It is second order in the spacing, takes O(nodes
/// in the band), and is bitwise identical on any number of threads.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT LevelMeasure MeasureLevel(const FlowField& field);

}

#endif
