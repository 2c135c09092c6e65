/**
 * @file NamedColumns.h
 * @brief Named arrays of points, cells, rows and field data, made and filled in one line.
 */
#ifndef isthmus_NamedColumns_h
#define isthmus_NamedColumns_h

#include "Core/ArrayMemory.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cstddef>
#include <initializer_list>
#include <iterator>
#include <string>
#include <type_traits>

namespace isthmus
{

/// A new array of this name with `count` tuples, whose values are not set.
template <typename Array>
vtkNew<Array> NamedArray(const std::string& name, std::size_t count = 0, int components = 1)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  array->SetNumberOfComponents(components);
  SizeArray(array, static_cast<vtkIdType>(count));
  return array;
}

/// The same for a type known at run time, e.g. VTK_FLOAT. `name` may be null.
inline vtkSmartPointer<vtkDataArray> ArrayOfType(
  int type, const char* name, vtkIdType count, int components = 1)
{
  auto array = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  array->SetName(name);
  array->SetNumberOfComponents(components);
  SizeArray(array, count);
  return array;
}

/// NamedArray() that belongs to `data`.
template <typename Array>
Array* AddArray(vtkFieldData* data, const std::string& name, std::size_t count, int components = 1)
{
  const vtkNew<Array> array = NamedArray<Array>(name, count, components);
  data->AddArray(array);
  return array;
}

/// A new array of one tuple that has these components.
template <typename Array, typename Values>
Array* AddTuple(vtkFieldData* data, const std::string& name, const Values& values)
{
  auto* array = AddArray<Array>(data, name, 1, static_cast<int>(std::size(values)));
  std::copy(std::begin(values), std::end(values), array->GetPointer(0));
  return array;
}

/// A new array with the values of(row) for rows 0 to `rows` - 1. Numbers are converted to the type
/// of the array.
template <typename Array, typename Of>
void AddComputedColumn(vtkFieldData* data, const std::string& name, std::size_t rows, Of&& of)
{
  auto* column = AddArray<Array>(data, name, rows);
  for (std::size_t row = 0; row < rows; ++row)
  {
    if constexpr (std::is_arithmetic_v<std::decay_t<decltype(of(row))>>)
    {
      using Value = std::decay_t<decltype(column->GetValue(0))>;
      column->SetValue(static_cast<vtkIdType>(row), static_cast<Value>(of(row)));
    }
    else
    {
      column->SetValue(static_cast<vtkIdType>(row), of(row));
    }
  }
}

/// A new array with of(item) for each item of a container.
template <typename Array, typename Items, typename Of,
  typename = std::enable_if_t<!std::is_integral_v<Items>>>
void AddComputedColumn(vtkFieldData* data, const std::string& name, const Items& items, Of&& of)
{
  auto item = items.begin();
  AddComputedColumn<Array>(data, name, items.size(), [&](std::size_t) { return of(*item++); });
}

/// A new array with these values.
template <typename Array, typename Values>
void AddColumn(vtkFieldData* data, const std::string& name, const Values& values)
{
  AddComputedColumn<Array>(data, name, values, [](const auto& value) { return value; });
}

/// The same for `{ a, b }`, and for one number or text: `{ a }`.
template <typename Array, typename Value>
void AddColumn(vtkFieldData* data, const std::string& name, std::initializer_list<Value> values)
{
  AddComputedColumn<Array>(data, name, values, [](const auto& value) { return value; });
}

}

#endif
