/**
 * @file LevelMeasure.h
 * @brief Area and volume of the surface that a flow's distances describe.
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

/// Of the level 0 of the distances, linear in the six tetrahedra of each cell; the volume is the
/// sum of cones from the middle of the grid. Second order in the spacing; time O(nodes in the
/// band); bitwise identical on any number of threads.
VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT LevelMeasure MeasureLevel(const FlowField& field);

}

#endif
