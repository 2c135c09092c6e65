/**
 * @file AutomaticLevel.h
 * @brief The level of a map for filters whose AutomaticLevel is on.
 */
#ifndef isthmus_AutomaticLevel_h
#define isthmus_AutomaticLevel_h

#include "vtkIsthmusFiltersContouringModule.h"
#include "vtkType.h"

class vtkDataArray;
class vtkImageData;

namespace isthmus
{

/**
 * The level that the map's depositors recommend, where the reader found it (field data
 * `RecommendedLevel`), else EstimateLevel() of its values. One policy for all filters that take a
 * map: automatic unless a level is given. The estimate is cached until the map changes.
 */
class AutomaticLevel
{
public:
  VTKISTHMUSFILTERSCONTOURING_EXPORT double Of(
    vtkImageData* image, vtkDataArray* scalars, bool insideIsHigher);

private:
  double Cached = 0.0;
  vtkDataArray* Scalars = nullptr; // compared only
  vtkMTimeType Time = 0;
  bool InsideIsHigher = true;
};

}

#endif
