/**
 * @file MRCFieldData.h
 * @brief What a map's header says, as field data; the arrays are described in vtkMRCMapReader.h.
 */
#ifndef isthmus_MRCFieldData_h
#define isthmus_MRCFieldData_h

#include "Maps/MRCMap.h"

#include <string>
#include <vector>

class vtkFieldData;

namespace isthmus
{

/// What a user should know about how this map was read, apart from repairs.
std::vector<std::string> MRCNotes(const MRCMap& map);

/// Adds the header's facts, header.Repairs and the notes to `fields`.
void AddMRCFieldData(const MRCMap& map, int volumeIndex, vtkFieldData* fields);

}

#endif
