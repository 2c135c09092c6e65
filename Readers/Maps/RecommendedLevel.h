/**
 * @file RecommendedLevel.h
 * @brief The level that an entry's depositors recommend for its map, from the header beside it.
 */
#ifndef isthmus_RecommendedLevel_h
#define isthmus_RecommendedLevel_h

#include "vtkIsthmusReadersMapsModule.h"

#include <optional>
#include <string>

namespace isthmus
{

/// The level in the text of an EMDB header: the primary contour's (or the first one's) of
/// `map/contour_list/contour/level`, format 3, or `map/contourLevel`, format 1.9. Nothing where the
/// text has none that is a finite number.
VTKISTHMUSREADERSMAPS_EXPORT std::optional<double> LevelOfHeader(const std::string& xml);

/**
 * The level for the map `fileName`, whose name begins with emd_NNNN (or emd-NNNN, EMD-NNNN):
 * from `emd-NNNN.xml`, with either sign and either case, beside it or in the folder `../header` of
 * the archive. Nothing where there is no such file, or no level in it; never throws for that.
 */
VTKISTHMUSREADERSMAPS_EXPORT std::optional<double> RecommendedLevel(const std::string& fileName);

}

#endif
