#include "Core/ArrayMemory.h"

#include <vtkBitArray.h>
#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <new>

using namespace isthmus;

namespace
{

constexpr vtkIdType TooMany = vtkIdType{ 1 }
  << 58; // tuples of three doubles exceed any address space

TEST(ArrayMemory, ArraysOfEachKindGetTheirSize)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  SizeArray(vectors, 5);
  EXPECT_EQ(vectors->GetNumberOfTuples(), 5);
  vectors->SetTuple3(4, 1.0, 2.0, 3.0);
  vectors->InsertNextTuple3(4.0, 5.0, 6.0); // grows as VTK's own
  EXPECT_EQ(vectors->GetComponent(4, 2), 3.0);
  EXPECT_EQ(vectors->GetComponent(5, 0), 4.0);
  SizeArray(vectors, 0);
  EXPECT_EQ(vectors->GetNumberOfTuples(), 0);
  vtkNew<vtkBitArray> bits;
  SizeArray(bits, 17);
  EXPECT_EQ(bits->GetNumberOfTuples(), 17);
  vtkNew<vtkStringArray> names;
  SizeArray(names, 3);
  EXPECT_EQ(names->GetNumberOfTuples(), 3);
  vtkNew<vtkPoints> points;
  SizePoints(points, 7);
  EXPECT_EQ(points->GetNumberOfPoints(), 7);
}

TEST(ArrayMemory, WithoutMemoryThereIsAnExceptionAndTheArrayStays)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  SizeArray(vectors, 2);
  vectors->SetTuple3(1, 7.0, 8.0, 9.0);
  EXPECT_THROW(SizeArray(vectors, TooMany), std::bad_alloc);
  EXPECT_THROW(ReserveArray(vectors, TooMany), std::bad_alloc);
  ASSERT_EQ(vectors->GetNumberOfTuples(), 2);
  EXPECT_EQ(vectors->GetComponent(1, 2), 9.0);
}

TEST(ArrayMemory, ReservedCellsAreEmptyAndTakeCells)
{
  vtkNew<vtkCellArray> cells;
  ReserveCells(cells, 2, 8);
  EXPECT_EQ(cells->GetNumberOfCells(), 0);
  cells->InsertNextCell({ 0, 1, 2, 3 });
  cells->InsertNextCell({ 4, 5, 6, 7 });
  cells->InsertNextCell({ 1, 2, 3, 4 }); // one more than reserved
  ASSERT_EQ(cells->GetNumberOfCells(), 3);
  vtkNew<vtkIdList> corners;
  cells->GetCellAtId(1, corners);
  ASSERT_EQ(corners->GetNumberOfIds(), 4);
  EXPECT_EQ(corners->GetId(0), 4);
  vtkNew<vtkPoints> points;
  SizePoints(points, 8);
  vtkNew<vtkUnstructuredGrid> grid;
  grid->SetPoints(points);
  SetCellsOfType(grid, VTK_TETRA, cells);
  EXPECT_EQ(grid->GetNumberOfCells(), 3);
  EXPECT_EQ(grid->GetCellType(2), VTK_TETRA);
}

}
