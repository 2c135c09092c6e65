/**
 * @file LongTriangulation.h
 * @brief The log entry of the filters of pockets and pores about a triangulation that takes long.
 * Private.
 */
#ifndef isthmus_LongTriangulation_h
#define isthmus_LongTriangulation_h

#include "Core/NumberText.h"

#include <vtkLogger.h>

namespace isthmus
{

/// An entry in VTK's log, for PocketOptions::Predicted and PoreOptions::Predicted: a warning if the
/// triangulation is expected to take 5 seconds or more. The rest of the analysis takes 1.5 times as
/// long for molecules, and up to 15 times for atoms on a cylinder, whose flat tetrahedra need exact
/// arithmetic.
inline void LogOfLongTriangulation(double seconds)
{
  constexpr double least = 5.0;
  if (seconds >= least)
  {
    vtkLog(
      WARNING, << TextOf("The triangulation of the atoms will take about ",
                 FormatNumber(seconds, 2),
                 " s, and the whole analysis two to ten times as long (longest if the atoms lie in "
                 "convex position, e.g. on a cylinder). To analyse fewer atoms, abort it."));
  }
}

}

#endif
