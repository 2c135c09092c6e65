/**
 * @file RecommendedLevel.h
 * @brief The level that the depositors of an entry recommend for its map, from the header file
 * beside the map.
 */
#ifndef isthmus_RecommendedLevel_h
#define isthmus_RecommendedLevel_h

#include "vtkIsthmusReadersMapsModule.h"

#include <optional>
#include <string>

namespace isthmus
{

/// The level in the text of an EMDB header: that of the primary (or the first) contour in
/// map/contour_list/contour/level, format 3, or map/contourLevel, format 1.9. Empty if the text has
/// no level that is a finite number.
std::optional<double> LevelOfHeader(const std::string& xml);

/**
 * The level for the map `fileName`, whose name begins with emd_NNNN (or emd-NNNN, EMD-NNNN):
 * from emd-NNNN.xml, with a hyphen or an underscore and in upper or lower case, beside the map or
 * in the folder ../header of the archive. Empty if there is no such file, or no level in it; this
 * does not throw.
 */
VTKISTHMUSREADERSMAPS_EXPORT std::optional<double> RecommendedLevel(const std::string& fileName);

}

#endif
