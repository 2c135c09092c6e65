/**
 * @file LongTriangulation.h
 * @brief The warning of the filters of pockets and pores about a triangulation that takes long.
 * Private.
 */
#ifndef isthmus_LongTriangulation_h
#define isthmus_LongTriangulation_h

#include "Core/NumberText.h"

#include <vtkObject.h>

#include <functional>

namespace isthmus
{

/// For PocketOptions::Predicted and PoreOptions::Predicted: a warning by `filter` if the
/// triangulation is expected to take 5 seconds or more. The whole analysis takes two and a half
/// times as long for molecules, and up to ten times for atoms on a cylinder, whose flat tetrahedra
/// need exact arithmetic.
inline std::function<void(double)> WarnAboutLongTriangulation(vtkObject* filter)
{
  return [filter](double seconds)
  {
    constexpr double least = 5.0;
    if (seconds >= least)
    {
      vtkWarningWithObjectMacro(filter,
        << JoinText("The triangulation of the atoms will take about ", FormatNumber(seconds, 2),
             " s, and the whole analysis two to ten times as long (longest if the atoms lie in "
             "convex position, e.g. on a cylinder). To analyse fewer atoms, abort it."));
    }
  };
}

}

#endif
