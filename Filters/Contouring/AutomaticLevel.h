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
 * The level that the map's depositors recommend, if the reader found it (field data
 * RecommendedLevel), otherwise EstimateLevel() of its values. The same policy applies to all
 * filters whose input is a map: automatic unless a level is given.
 *
 * A recommended level is returned unchanged, even if it is not finite. The estimate is cached until
 * the image or its scalars are modified or replaced. Cost: one sample of at most 2^20 values.
 * @throws std::invalid_argument if no value is finite.
 */
class AutomaticLevel
{
public:
  VTKISTHMUSFILTERSCONTOURING_EXPORT double Of(
    vtkImageData* image, vtkDataArray* scalars, bool insideIsHigher);

private:
  double Cached = 0.0;
  vtkDataArray* Scalars = nullptr; // only compared, never dereferenced
  vtkMTimeType Time = 0;
  bool InsideIsHigher = true;
};

}

#endif
