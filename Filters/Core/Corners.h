/**
 * @file Corners.h
 * @brief A triangle and a tetrahedron by the ids of their corners: VTK's ids, everywhere.
 */
#ifndef isthmus_Corners_h
#define isthmus_Corners_h

#include <vtkType.h>

#include <array>

namespace isthmus
{

using Triangle = std::array<vtkIdType, 3>;
using Tetrahedron = std::array<vtkIdType, 4>;

}

#endif
