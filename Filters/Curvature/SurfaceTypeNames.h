/**
 * @file SurfaceTypeNames.h
 * @brief The names of the surface types, as a field array.
 */
#ifndef isthmus_SurfaceTypeNames_h
#define isthmus_SurfaceTypeNames_h

#include "Core/NamedColumns.h"
#include "Curvature/CurvatureDescriptors.h"

#include <vtkStringArray.h>

namespace isthmus
{

/// Adds the field array `SurfaceTypeNames`: the name of type i is its value i.
inline void AddSurfaceTypeNames(vtkFieldData* fields)
{
  AddComputedColumn<vtkStringArray>(fields, "SurfaceTypeNames", NumberOfSurfaceTypes,
    [](std::size_t type) { return SurfaceTypeName(static_cast<SurfaceType>(type)); });
}

}

#endif
