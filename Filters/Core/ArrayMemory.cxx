#include "Core/ArrayMemory.h"

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkUnstructuredGrid.h>

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

namespace isthmus
{

void SizeArray(vtkAbstractArray* array, vtkIdType tuples)
{
  const auto* numbers = vtkDataArray::SafeDownCast(array);
  if (tuples <= 0 || !numbers || array->GetDataType() == VTK_BIT ||
    !array->HasStandardMemoryLayout())
  {
    array->SetNumberOfTuples(tuples);
    return;
  }
  const vtkIdType values = tuples * array->GetNumberOfComponents();
  void* memory = std::malloc(
    static_cast<std::size_t>(values) * static_cast<std::size_t>(array->GetDataTypeSize()));
  if (!memory)
  {
    throw std::bad_alloc();
  }
  array->SetVoidArray(memory, values, 0, vtkAbstractArray::VTK_DATA_ARRAY_FREE);
}

void ReserveArray(vtkAbstractArray* array, vtkIdType tuples)
{
  SizeArray(array, tuples);
  array->Reset(); // the memory stays
}

void SizePoints(vtkPoints* points, vtkIdType count)
{
  SizeArray(points->GetData(), count);
  points->Modified();
}

void ReserveCells(vtkCellArray* cells, vtkIdType count, vtkIdType corners)
{
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  ReserveArray(offsets, count + 1);
  ReserveArray(connectivity, corners);
  offsets->InsertNextValue(0);
  cells->SetData(offsets, connectivity);
}

void SetCellsOfType(vtkUnstructuredGrid* grid, unsigned char type, vtkCellArray* cells)
{
  vtkNew<vtkUnsignedCharArray> types;
  SizeArray(types, cells->GetNumberOfCells());
  std::fill_n(types->GetPointer(0), types->GetNumberOfValues(), type);
  grid->SetCells(types, cells);
}

}
