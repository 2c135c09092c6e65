// Arrays of any type under the names that mesh files store: written exactly, or named in a warning.

#include "MeshFileTrips.h"
#include "vtkCombinatorialMeshReader.h"
#include "vtkCombinatorialMeshWriter.h"
#include "vtkMEDITReader.h"
#include "vtkMEDITWriter.h"
#include "vtkOFFSurfaceReader.h"
#include "vtkOFFSurfaceWriter.h"
#include "vtkTetGenMeshReader.h"
#include "vtkTetGenMeshWriter.h"

#include <vtkCellData.h>
#include <vtkCommand.h>
#include <vtkDataArray.h>
#include <vtkLongLongArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkTestErrorObserver.h>
#include <vtkUnsignedLongLongArray.h>
#include <vtkUnstructuredGrid.h>

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

using Values = std::vector<double>;

vtkSmartPointer<vtkDataArray> Array(
  int type, const char* name, const Values& values, int components = 1)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()) / components);
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const auto at = static_cast<vtkIdType>(i);
    array->SetComponent(at / components, static_cast<int>(at % components), values[i]);
  }
  return array;
}

vtkDataSetAttributes* ToPolyData(vtkPointSet* mesh, bool onCells)
{
  return onCells ? static_cast<vtkDataSetAttributes*>(mesh->GetCellData()) : mesh->GetPointData();
}

/// A mesh of two cells of a kind.
vtkSmartPointer<vtkUnstructuredGrid> Mesh(int type = VTK_TETRA, int corners = 4)
{
  return RandomMesh(type, corners, 2);
}

/// An array after writing and reading, and the warning of the writer.
struct Trip
{
  vtkSmartPointer<vtkDataArray> Array;
  std::string Warning;
};

template <typename Writer, typename Reader>
Trip Written(vtkPointSet* mesh, vtkAbstractArray* array, bool onCells, const char* file)
{
  const TemporaryFile place("", file);
  ToPolyData(mesh, onCells)->AddArray(array);
  vtkNew<vtkTest::ErrorObserver> observer;
  vtkNew<Writer> writer;
  writer->AddObserver(vtkCommand::WarningEvent, observer);
  writer->SetInputData(mesh);
  writer->SetFileName(place.Path());
  EXPECT_EQ(writer->Write(), 1);
  const auto reader = OpenFile<Reader>(place.Path());
  Trip trip{ ToPolyData(reader->GetOutput(), onCells)->GetArray(array->GetName()),
    observer->GetWarningMessage() };
  ToPolyData(mesh, onCells)->RemoveArray(array->GetName());
  return trip;
}

void ExpectValues(const Trip& trip, const Values& values)
{
  EXPECT_EQ(trip.Warning, "");
  ASSERT_NE(trip.Array, nullptr);
  ASSERT_EQ(trip.Array->GetNumberOfValues(), static_cast<vtkIdType>(values.size()));
  const int components = trip.Array->GetNumberOfComponents();
  for (int i = 0; i < static_cast<int>(values.size()); ++i)
  {
    EXPECT_EQ(trip.Array->GetComponent(i / components, i % components),
      values[static_cast<std::size_t>(i)]);
  }
}

void ExpectDropped(const Trip& trip, const std::string& name, const std::string& why)
{
  EXPECT_SAYS(trip.Warning, "Array '" + name + "' of ");
  EXPECT_SAYS(trip.Warning, "is left out: ");
  EXPECT_SAYS(trip.Warning, why);
}

constexpr int types[] = { VTK_BIT, VTK_CHAR, VTK_SIGNED_CHAR, VTK_UNSIGNED_CHAR, VTK_SHORT,
  VTK_UNSIGNED_SHORT, VTK_INT, VTK_UNSIGNED_INT, VTK_LONG, VTK_UNSIGNED_LONG, VTK_LONG_LONG,
  VTK_UNSIGNED_LONG_LONG, VTK_ID_TYPE, VTK_FLOAT, VTK_DOUBLE };

/// A place for an array: on cells, its name, and how many components it has.
struct Slot
{
  bool OnCells;
  const char* Name;
  int Components;
};

/// Zeros and ones, which all types hold.
Values ZerosAndOnes(const Slot& slot)
{
  Values values(static_cast<std::size_t>((slot.OnCells ? 2 : 8) * slot.Components), 0.0);
  for (std::size_t i = 0; i < values.size(); i += 3)
  {
    values[i] = 1.0;
  }
  return values;
}

}

TEST(MeshWriterArrays, AllTypesOfNumbersAreWritten)
{
  for (const int type : types)
  {
    SCOPED_TRACE(type);
    for (const Slot& slot : { Slot{ false, "Reference", 1 }, { true, "Reference", 1 } })
    {
      const Values values = ZerosAndOnes(slot);
      ExpectValues(Written<vtkMEDITWriter, vtkMEDITReader>(
                     Mesh(), Array(type, slot.Name, values), slot.OnCells, "x.mesh"),
        values);
    }
    for (const Slot& slot :
      { Slot{ false, "Attribute", 2 }, { false, "BoundaryMarker", 1 }, { true, "Attribute", 3 } })
    {
      const Values values = ZerosAndOnes(slot);
      ExpectValues(Written<vtkTetGenMeshWriter, vtkTetGenMeshReader>(Mesh(),
                     Array(type, slot.Name, values, slot.Components), slot.OnCells, "x.ele"),
        values);
    }
    ExpectValues(Written<vtkTetGenMeshWriter, vtkTetGenMeshReader>(
                   Mesh(VTK_TRIANGLE, 3), Array(type, "BoundaryMarker", { 1, 0 }), true, "x.face"),
      { 1, 0 });
    vtkNew<vtkPolyData> surface;
    surface->SetPoints(Mesh()->GetPoints());
    const Values normals = ZerosAndOnes({ false, "Normals", 3 });
    ExpectValues(Written<vtkOFFSurfaceWriter, vtkOFFSurfaceReader>(
                   surface, Array(type, "Normals", normals, 3), false, "x.off"),
      normals);
  }
}

TEST(MeshWriterArrays, LargeIntegersKeepAllTheirDigits)
{
  constexpr long long odd = (1LL << 62) + 1;
  vtkNew<vtkLongLongArray> large;
  large->SetName("Reference");
  large->InsertNextValue(odd);
  large->InsertNextValue(std::numeric_limits<long long>::min());
  const Trip trip = Written<vtkMEDITWriter, vtkMEDITReader>(Mesh(), large, true, "x.mesh");
  EXPECT_EQ(trip.Warning, "");
  ASSERT_NE(trip.Array, nullptr);
  EXPECT_EQ(trip.Array->GetVariantValue(0).ToLongLong(), odd);
  EXPECT_EQ(trip.Array->GetVariantValue(1).ToLongLong(), std::numeric_limits<long long>::min());
  large->SetName("Attribute");
  ExpectDropped(Written<vtkTetGenMeshWriter, vtkTetGenMeshReader>(Mesh(), large, true, "x.ele"),
    "Attribute", "numbers in double precision, and tuple 0 has 4611686018427387905");
  vtkNew<vtkUnsignedLongLongArray> larger;
  larger->SetName("Reference");
  larger->InsertNextValue(5);
  larger->InsertNextValue(std::numeric_limits<unsigned long long>::max());
  ExpectDropped(Written<vtkMEDITWriter, vtkMEDITReader>(Mesh(), larger, true, "x.mesh"),
    "Reference", "whole numbers of 64 bits, and tuple 1 has 18446744073709551615");
  larger->SetName("Attribute");
  ExpectDropped(Written<vtkTetGenMeshWriter, vtkTetGenMeshReader>(Mesh(), larger, true, "x.ele"),
    "Attribute", "tuple 1 has 18446744073709551615");
}

TEST(MeshWriterArrays, WhatCannotBeWrittenIsNamedWithItsReason)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto medit = [](vtkAbstractArray* array, bool onCells = true)
  { return Written<vtkMEDITWriter, vtkMEDITReader>(Mesh(), array, onCells, "x.mesh"); };
  for (const int type : { VTK_FLOAT, VTK_DOUBLE })
  {
    ExpectDropped(medit(Array(type, "Reference", { 3, 0.5 })), "Reference",
      "whole numbers of 64 bits, and tuple 1 has 0.5");
    ExpectDropped(medit(Array(type, "Reference", { nan, 0 })), "Reference", "tuple 0 has nan");
    ExpectDropped(
      medit(Array(type, "Reference", { 0, 9223372036854775808.0 })), "Reference", "tuple 1 has 9");
    ExpectValues(medit(Array(type, "Reference", { -9223372036854775808.0, 7 })),
      { -9223372036854775808.0, 7 });
  }
  ExpectDropped(medit(Array(VTK_INT, "Reference", { 1, 2, 3, 4 }, 2)), "Reference",
    "the format holds 1 components, and it has 2");
  ExpectDropped(
    medit(Array(VTK_INT, "Reference", { 1 })), "Reference", "it has 1 tuples for 2 cells");
  ExpectDropped(medit(Array(VTK_INT, "Reference", { 1, 2 }), false), "Reference",
    "it has 2 tuples for 8 points");
  vtkNew<vtkStringArray> words;
  words->SetName("Reference");
  words->SetNumberOfValues(2);
  ExpectDropped(medit(words), "Reference", "it has no numbers");

  const auto tetgen =
    [](vtkUnstructuredGrid* mesh, vtkDataArray* array, bool onCells, const char* file)
  { return Written<vtkTetGenMeshWriter, vtkTetGenMeshReader>(mesh, array, onCells, file); };
  ExpectDropped(tetgen(Mesh(), Array(VTK_INT, "BoundaryMarker", { 1, 2 }), true, "x.ele"),
    "BoundaryMarker", "does not store it on cells of these shapes");
  ExpectDropped(
    tetgen(Mesh(VTK_TRIANGLE, 3), Array(VTK_DOUBLE, "Attribute", { 1, 2 }), true, "x.face"),
    "Attribute", "does not store it on cells of these shapes");
  const auto both = Mesh();
  const vtkIdType corners[] = { 0, 1, 2 };
  both->InsertNextCell(VTK_TRIANGLE, 3, corners);
  ExpectValues(
    tetgen(both, Array(VTK_FLOAT, "BoundaryMarker", { 0, 0, 4 }), true, "x.face"), { 4 });
  const Trip some = tetgen(both, Array(VTK_FLOAT, "BoundaryMarker", { 0.5, 0, 4 }), true, "x.face");
  EXPECT_SAYS(some.Warning, "Values of 'BoundaryMarker' of cells are dropped where");
  ASSERT_NE(some.Array, nullptr);
  EXPECT_EQ(some.Array->GetComponent(0, 0), 4.0);
  const Trip other = tetgen(both, Array(VTK_DOUBLE, "Attribute", { 0.5, nan, 4 }), true, "x.ele");
  EXPECT_SAYS(other.Warning, "Values of 'Attribute' of cells are dropped where");
  ASSERT_NE(other.Array, nullptr);
  EXPECT_TRUE(std::isnan(other.Array->GetComponent(1, 0)));

  vtkNew<vtkPolyData> surface;
  surface->SetPoints(Mesh()->GetPoints());
  Values normals(24, 0.5);
  normals[7] = nan;
  ExpectDropped(Written<vtkOFFSurfaceWriter, vtkOFFSurfaceReader>(
                  surface, Array(VTK_DOUBLE, "Normals", normals, 3), false, "x.off"),
    "Normals", "finite numbers, and tuple 2 has nan");
  ExpectDropped(Written<vtkOFFSurfaceWriter, vtkOFFSurfaceReader>(
                  surface, Array(VTK_DOUBLE, "Normals", Values(8, 0.5)), false, "x.off"),
    "Normals", "3 components, and it has 1");

  const auto volume = [](vtkDataArray* array, bool onCells)
  {
    return Written<vtkCombinatorialMeshWriter, vtkCombinatorialMeshReader>(
      Mesh(), array, onCells, "x.cmesh");
  };
  EXPECT_SAYS(
    volume(Array(VTK_INT, "Short", { 1 }), true).Warning, "for the cells are left out: 'Short'");
  EXPECT_SAYS(volume(Array(VTK_INT, "Short", { 1, 2 }), false).Warning,
    "for the points are left out: 'Short'");
}
