/**
 * @file ScalarImages.h
 * @brief Images for the tests, and functions that read tables, for the tests of
 * vtkScalarPersistence.
 */
#ifndef isthmus_ScalarImages_h
#define isthmus_ScalarImages_h

#include "CubicalPeer.h"

#include <vtkDataArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkTable.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace isthmus::testing
{

constexpr double Infinity = std::numeric_limits<double>::infinity();
constexpr double Pi = 3.14159265358979323846;

/// An image of n^3 nodes with spacing (0.5, 0.5, 0.5) round the origin, holding f(x, y, z).
template <typename Array, typename Function>
vtkSmartPointer<vtkImageData> Image(int n, Function&& f)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(3, n + 2, -5, n - 6, 0, n - 1);
  image->SetSpacing(0.5, 0.5, 0.5);
  image->SetOrigin(-0.25 * n - 1.25, -0.25 * n + 2.75, -0.25 * n + 0.25);
  vtkNew<Array> values;
  values->SetName("Field");
  values->SetNumberOfTuples(image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    values->SetComponent(i, 0, f(p[0], p[1], p[2]));
  }
  image->GetPointData()->SetScalars(values);
  return image;
}

inline double Ripple(double x, double y, double z)
{
  return std::sin(1.3 * x) * std::cos(0.9 * y) + std::sin(0.8 * y + 1.0) * std::cos(1.2 * z) +
    std::sin(z) * std::cos(0.8 * x + 0.5);
}

/// Distance from a circle of radius 4 in the plane z = 0.
inline double FromCircle(double x, double y, double z)
{
  return std::hypot(std::hypot(x, y) - 4.0, z);
}

inline VolumeView MakeView(vtkImageData* image)
{
  auto* values = vtkFloatArray::SafeDownCast(image->GetPointData()->GetScalars());
  const int* n = image->GetDimensions();
  return VolumeView(values->GetPointer(0), { n[0], n[1], n[2] });
}

inline double At(vtkTable* table, const char* column, vtkIdType row)
{
  auto* array = vtkDataArray::SafeDownCast(table->GetColumnByName(column));
  EXPECT_NE(array, nullptr) << column;
  return array ? array->GetComponent(row, 0) : std::nan("");
}

inline Bars BarsOfTable(vtkTable* table)
{
  Bars bars;
  for (vtkIdType row = 0; row < table->GetNumberOfRows(); ++row)
  {
    bars.push_back(
      { At(table, "Dimension", row), At(table, "Birth", row), At(table, "Death", row) });
  }
  std::sort(bars.begin(), bars.end());
  return bars;
}

}

#endif
