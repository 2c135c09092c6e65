/**
 * @file SurfaceTypeNames.h
 * @brief The names of the surface types, as a field array.
 */
#ifndef isthmus_SurfaceTypeNames_h
#define isthmus_SurfaceTypeNames_h

#include "Curvature/CurvatureDescriptors.h"

#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

namespace isthmus
{

/// Adds the field array `SurfaceTypeNames`: the name of type i is its value i.
inline void AddSurfaceTypeNames(vtkFieldData* fields)
{
  vtkNew<vtkStringArray> names;
  names->SetName("SurfaceTypeNames");
  for (unsigned char type = 0; type < NumberOfSurfaceTypes; ++type)
  {
    names->InsertNextValue(SurfaceTypeName(static_cast<SurfaceType>(type)));
  }
  fields->AddArray(names);
}

}

#endif
