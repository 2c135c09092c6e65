#include "Curvature/DifferentialForms.h"

#include "Core/NamedColumns.h"

#include <vtkDataArray.h>
#include <vtkDataArraySelection.h>
#include <vtkDataSet.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace isthmus
{
namespace
{

/// S v.
Point3 ApplyShapeOperator(const LocalShape& shape, const Point3& v)
{
  return shape.Maximum * Dot(shape.Direction1, v) * shape.Direction1 +
    shape.Minimum * Dot(shape.Direction2, v) * shape.Direction2;
}

/// Directions of a mesh are estimated separately from its normal, and not exactly perpendicular.
void RotateToTangentPlane(LocalShape& shape)
{
  const Point3 tangent = shape.Direction1 - Dot(shape.Direction1, shape.Normal) * shape.Normal;
  const double length = Length(tangent);
  if (length > 0.0)
  {
    shape.Direction1 = (1.0 / length) * tangent;
    shape.Direction2 = Cross(shape.Normal, shape.Direction1);
  }
}

/// Null unless it is requested.
vtkSmartPointer<vtkDataArray> NewLike(
  vtkDataArray* like, bool isWanted, const char* name, int components, vtkDataSet* output)
{
  if (!isWanted)
  {
    return nullptr;
  }
  auto array = ArrayOfType(like->GetDataType(), name, output->GetNumberOfPoints(), components);
  output->GetPointData()->AddArray(array);
  return array;
}

}

DifferentialForms ComputeForms(const LocalShape& shape)
{
  DifferentialForms forms;
  const Point3& n = shape.Normal;
  const auto largest = std::max_element(
    n.begin(), n.end(), [](double a, double b) { return std::abs(a) < std::abs(b); });
  if (*largest == 0.0)
  {
    return forms;
  }
  const auto z = static_cast<std::size_t>(largest - n.begin());
  const std::size_t x = (z + 1) % 3, y = (z + 2) % 3;
  constexpr std::array<std::array<std::size_t, 2>, 6> places{ { { 0, 0 }, { 1, 1 }, { 2, 2 },
    { 0, 1 }, { 1, 2 }, { 0, 2 } } };
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const auto [row, column] = places[i];
    forms.ShapeOperator[i] = shape.Maximum * shape.Direction1[row] * shape.Direction1[column] +
      shape.Minimum * shape.Direction2[row] * shape.Direction2[column];
  }
  Point3 u{ 0.0, 0.0, 0.0 }, v{ 0.0, 0.0, 0.0 };
  u[x] = 1.0;
  u[z] = -n[x] / n[z];
  v[y] = 1.0;
  v[z] = -n[y] / n[z];
  forms.First = { Dot(u, u), Dot(u, v), Dot(v, v) };
  forms.Second = { Dot(u, ApplyShapeOperator(shape, u)), Dot(u, ApplyShapeOperator(shape, v)),
    Dot(v, ApplyShapeOperator(shape, v)) };
  forms.AreaElement = 1.0 / std::abs(n[z]);
  return forms;
}

double NormalCurvature(const LocalShape& shape, const Point3& direction)
{
  const Point3 tangent = direction - Dot(direction, shape.Normal) * shape.Normal;
  const double square = Dot(tangent, tangent);
  return square > 1e-12 * Dot(direction, direction)
    ? Dot(tangent, ApplyShapeOperator(shape, tangent)) / square
    : 0.0;
}

DifferentialFormsSelection::DifferentialFormsSelection(
  vtkDataArraySelection* arrays, const double direction[3])
  : GaussMap(arrays->ArrayIsEnabled("GaussMap"))
  , ShapeOperator(arrays->ArrayIsEnabled("ShapeOperator"))
  , First(arrays->ArrayIsEnabled("FirstFundamentalForm"))
  , Second(arrays->ArrayIsEnabled("SecondFundamentalForm"))
  , AreaElement(arrays->ArrayIsEnabled("AreaElement"))
  , NormalCurvature(arrays->ArrayIsEnabled("NormalCurvature"))
  , Direction{ direction[0], direction[1], direction[2] }
{
}

void DifferentialFormsSelection::Check() const
{
  const double square = Dot(this->Direction, this->Direction);
  if (this->NormalCurvature && !(square > 0.0 && std::isfinite(square)))
  {
    throw std::invalid_argument("NormalCurvatureDirection is zero or not finite: set it to a "
                                "vector along which the bending of the surface is to be computed.");
  }
}

void AddDifferentialForms(const DifferentialFormsSelection& selection, vtkDataSet* output)
{
  vtkPointData* points = output->GetPointData();
  vtkDataArray* normal = points->GetArray("GaussMap");
  vtkDataArray* maximum = points->GetArray("MaximumCurvature");
  vtkDataArray* minimum = points->GetArray("MinimumCurvature");
  vtkDataArray* first = points->GetArray("PrincipalDirection1");
  vtkDataArray* second = points->GetArray("PrincipalDirection2");
  if (!normal || !maximum || !minimum || !first || !second)
  {
    return;
  }
  const auto made = [&](bool isWanted, const char* name, int components)
  { return NewLike(maximum, isWanted, name, components, output); };
  const auto shapeOperator = made(selection.ShapeOperator, "ShapeOperator", 6);
  const auto firstForm = made(selection.First, "FirstFundamentalForm", 3);
  const auto secondForm = made(selection.Second, "SecondFundamentalForm", 3);
  const auto area = made(selection.AreaElement, "AreaElement", 1);
  const auto bending = made(selection.NormalCurvature, "NormalCurvature", 1);
  const auto put = [](vtkDataArray* array, vtkIdType point, const double* values)
  {
    if (array)
    {
      array->SetTuple(point, values);
    }
  };
  for (vtkIdType i = 0; i < output->GetNumberOfPoints(); ++i)
  {
    LocalShape shape;
    normal->GetTuple(i, shape.Normal.data());
    first->GetTuple(i, shape.Direction1.data());
    second->GetTuple(i, shape.Direction2.data());
    shape.Maximum = maximum->GetTuple1(i);
    shape.Minimum = minimum->GetTuple1(i);
    RotateToTangentPlane(shape);
    if (selection.AnyForm())
    {
      const DifferentialForms forms = ComputeForms(shape);
      put(shapeOperator, i, forms.ShapeOperator.data());
      put(firstForm, i, forms.First.data());
      put(secondForm, i, forms.Second.data());
      put(area, i, &forms.AreaElement);
    }
    if (selection.NormalCurvature)
    {
      bending->SetTuple1(i, NormalCurvature(shape, selection.Direction));
    }
  }
  if (!selection.GaussMap)
  {
    points->RemoveArray("GaussMap");
  }
}

}
