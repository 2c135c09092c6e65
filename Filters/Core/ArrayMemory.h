/**
 * @file ArrayMemory.h
 * @brief Allocates memory of VTK arrays; throws std::bad_alloc if there is not enough.
 *
 * A vtkDataArray that cannot grow ends the program in builds of VTK without NDEBUG, such as
 * Debian's. These functions allocate with malloc first and pass the memory to the array.
 */
#ifndef isthmus_ArrayMemory_h
#define isthmus_ArrayMemory_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <vtkType.h>

class vtkAbstractArray;
class vtkCellArray;
class vtkPoints;
class vtkUnstructuredGrid;

namespace isthmus
{

/// Resizes `array`, whose type and number of components are set, to this number of tuples. Values
/// are not set. Arrays of strings or bits grow as VTK does.
/// @throws std::bad_alloc without memory; the array is then as it was.
VTKISTHMUSFILTERSCORE_EXPORT void SizeArray(vtkAbstractArray* array, vtkIdType tuples);

/// Reserves memory for this number of tuples, so that InsertNext... does not allocate up to that
/// number. Empties `array`.
VTKISTHMUSFILTERSCORE_EXPORT void ReserveArray(vtkAbstractArray* array, vtkIdType tuples);

/// The same as SizeArray for points, whose type must be set before.
VTKISTHMUSFILTERSCORE_EXPORT void SizePoints(vtkPoints* points, vtkIdType count);

/// Reserves memory for `count` cells with `corners` points in total, so that InsertNextCell does
/// not allocate. Empties `cells`.
VTKISTHMUSFILTERSCORE_EXPORT void ReserveCells(
  vtkCellArray* cells, vtkIdType count, vtkIdType corners);

/// Sets `cells`, all of the same type (e.g. VTK_TETRA), as the cells of `grid`.
VTKISTHMUSFILTERSCORE_EXPORT void SetCellsOfType(
  vtkUnstructuredGrid* grid, unsigned char type, vtkCellArray* cells);

}

#endif
