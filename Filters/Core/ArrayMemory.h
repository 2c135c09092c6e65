/**
 * @file ArrayMemory.h
 * @brief Memory of VTK arrays, with std::bad_alloc where there is none.
 *
 * A vtkDataArray that can't grow ends the program in builds of VTK without NDEBUG, as Debian's is.
 * These functions ask malloc first and hand the memory over.
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

/// Gives `array`, which has its type and its number of components, `tuples` tuples. Values are not
/// set. Arrays of strings or bits grow as VTK does.
/// @throws std::bad_alloc without memory; the array is then as it was.
VTKISTHMUSFILTERSCORE_EXPORT void SizeArray(vtkAbstractArray* array, vtkIdType tuples);

/// Room for `tuples`, so that InsertNext... needs no memory up to there. Empties `array`.
VTKISTHMUSFILTERSCORE_EXPORT void ReserveArray(vtkAbstractArray* array, vtkIdType tuples);

/// The same as SizeArray for points; their type is set before.
VTKISTHMUSFILTERSCORE_EXPORT void SizePoints(vtkPoints* points, vtkIdType count);

/// Room for `cells` cells of `corners` points in all, so that InsertNextCell needs no memory.
/// Empties `cells`.
VTKISTHMUSFILTERSCORE_EXPORT void ReserveCells(
  vtkCellArray* cells, vtkIdType count, vtkIdType corners);

/// Makes `cells` those of `grid`, all of one type (VTK_TETRA).
VTKISTHMUSFILTERSCORE_EXPORT void SetCellsOfType(
  vtkUnstructuredGrid* grid, unsigned char type, vtkCellArray* cells);

}

#endif
