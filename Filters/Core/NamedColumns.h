/**
 * @file NamedColumns.h
 * @brief Named arrays of attributes or tables, made and filled in one line.
 */
#ifndef isthmus_NamedColumns_h
#define isthmus_NamedColumns_h

#include "Core/ArrayMemory.h"

#include <vtkFieldData.h>
#include <vtkNew.h>

#include <cstddef>
#include <string>
#include <type_traits>

namespace isthmus
{

/// A new, empty array of this name.
template <typename Array>
vtkNew<Array> NamedArray(const char* name)
{
  vtkNew<Array> array;
  array->SetName(name);
  return array;
}

/// A new array of `count` tuples that belongs to `data`.
template <typename Array>
Array* AddArray(vtkFieldData* data, const std::string& name, std::size_t count)
{
  vtkNew<Array> array;
  array->SetName(name.c_str());
  SizeArray(array, static_cast<vtkIdType>(count));
  data->AddArray(array);
  return array;
}

/// A new array with these numbers.
template <typename Array, typename Numbers>
void AddColumn(vtkFieldData* data, const std::string& name, const Numbers& numbers)
{
  auto* column = AddArray<Array>(data, name, numbers.size());
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    column->SetValue(static_cast<vtkIdType>(i), numbers[i]);
  }
}

/// A new array with the values of(row) for rows 0 to `rows` - 1.
template <typename Array, typename Of>
void AddColumnOf(vtkFieldData* data, const std::string& name, std::size_t rows, Of&& of)
{
  auto* column = AddArray<Array>(data, name, rows);
  for (std::size_t row = 0; row < rows; ++row)
  {
    column->SetValue(static_cast<vtkIdType>(row), of(row));
  }
}

/// A new array with of(item) for each item.
template <typename Array, typename Items, typename Of,
  typename = std::enable_if_t<!std::is_integral_v<Items>>>
void AddColumnOf(vtkFieldData* data, const std::string& name, const Items& items, Of&& of)
{
  auto* column = AddArray<Array>(data, name, items.size());
  vtkIdType at = 0;
  for (const auto& item : items)
  {
    column->SetValue(at++, of(item));
  }
}

}

#endif
