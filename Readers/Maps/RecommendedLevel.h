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

/// Which map of an entry a file name stands for.
struct EntryMap
{
  std::string Entry;   ///< NNNN of emd_NNNN; empty: the name is not that of a map of an entry
  std::string Element; ///< of its description in the header: map, half_map, additional_map
  int Number = 0;      ///< from 1, of half maps and additional maps
};

/// The map of the file `name`: emd_NNNN.map, emd_NNNN_half_map_1.map, emd_NNNN_additional_1.map,
/// with a hyphen or an underscore, and the ending of a map. Any other name, a mask's for example,
/// is not that of such a map.
EntryMap ParseEntryMap(const std::string& name);

/// The contour level that the text of an EMDB header states for one map of the entry and no other:
/// the primary (or the first) contour in contour_list/contour/level, format 3, or contourLevel,
/// format 1.9. Empty if that map has no level that is a finite number.
std::optional<double> HeaderLevel(const std::string& xml, const EntryMap& map);

/**
 * The level for the map `fileName` by ParseEntryMap() and HeaderLevel(), from emd-NNNN.xml, with a
 * hyphen or an underscore and in upper or lower case, beside the map or in the folder ../header of
 * the archive. Empty if there is no such file, or no level of this map in it; this does not throw.
 */
VTKISTHMUSREADERSMAPS_EXPORT std::optional<double> RecommendedLevel(const std::string& fileName);

}

#endif
