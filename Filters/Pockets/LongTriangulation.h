/**
 * @file LongTriangulation.h
 * @brief What the filters of pockets and pores report about a triangulation that takes long.
 * Private.
 */
#ifndef isthmus_LongTriangulation_h
#define isthmus_LongTriangulation_h

#include "Core/NumberText.h"

#include <vtkLogger.h>

namespace isthmus
{

/// An entry in VTK's log, for PocketOptions::Predicted and PoreOptions::Predicted: a warning where
/// the triangulation is going to take 5 seconds or more. What follows takes 1.5 times as long for
/// molecules, and up to 15 times for atoms on a cylinder, whose flat tetrahedra need exact
/// arithmetic.
inline void LogOfLongTriangulation(double seconds)
{
  constexpr double least = 5.0;
  if (seconds >= least)
  {
    vtkLog(WARNING, << TextOf("The triangulation of the atoms will take about ",
                      FormatNumber(seconds, 2),
                      " s, the whole analysis from two to ten times as long: most where the atoms "
                      "lie in convex position, as on a cylinder. Abort it to choose fewer atoms."));
  }
}

}

#endif
