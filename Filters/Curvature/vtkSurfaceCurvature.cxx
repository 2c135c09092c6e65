#include "vtkSurfaceCurvature.h"

#include "AlgorithmGuard.h"
#include "CurvatureDescriptors.h"
#include "PolyDataTriangles.h"
#include "SurfaceCurvature.h"
#include "SurfaceTypeNames.h"
#include "WholeSurface.h"

#include <vtkDoubleArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <cmath>
#include <stdexcept>
#include <string>

vtkStandardNewMacro(vtkSurfaceCurvature);

namespace
{

using isthmus::SurfaceCurvatureResult;

/// Adds a point array with `get(point)` where points are valid, 0 elsewhere.
template <typename Array, typename Get>
void AddDescriptor(vtkPolyData* output, const SurfaceCurvatureResult& result, vtkTypeBool wanted,
  const char* name, Get&& get)
{
  if (!wanted)
  {
    return;
  }
  vtkNew<Array> array;
  array->SetName(name);
  array->SetNumberOfValues(output->GetNumberOfPoints());
  for (std::size_t point = 0; point < result.Valid.size(); ++point)
  {
    using Value = typename Array::ValueType;
    array->SetValue(static_cast<vtkIdType>(point),
      result.Valid[point] ? static_cast<Value>(get(point)) : Value{ 0 });
  }
  output->GetPointData()->AddArray(array);
}

void AddVectors(
  vtkPolyData* output, vtkTypeBool wanted, const char* name, const std::vector<double>& vectors)
{
  if (!wanted || vectors.empty())
  {
    return;
  }
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(3);
  array->SetNumberOfTuples(output->GetNumberOfPoints());
  std::copy(vectors.begin(), vectors.end(), array->GetPointer(0));
  output->GetPointData()->AddArray(array);
}

void CheckTolerance(double value, const char* name)
{
  if (!(value >= 0.0) || std::isinf(value))
  {
    throw std::invalid_argument(
      std::string(name) + " is " + std::to_string(value) + ", but it is a bound: 0 or more.");
  }
}

/// What a user should know about points without curvature; empty if there is nothing.
std::string Complaints(const SurfaceCurvatureResult& result)
{
  std::string text;
  const auto add = [&](vtkIdType count, const char* what)
  {
    if (count > 0)
    {
      text += std::to_string(count) + what;
    }
  };
  add(result.IrregularPoints,
    " points have no curvature because the surface around them is not a disc, or its triangles are "
    "not wound alike. ");
  add(result.DegeneratePoints,
    " points have no curvature because a triangle at them has no area: clean or remesh the "
    "surface. ");
  add(result.AreaNotPositive,
    " points have no curvature because obtuse triangles make their Voronoi area negative: choose "
    "the mixed one (Point Area Rule; SetDualArea in C++), or remesh the surface. ");
  return text;
}

}

int vtkSurfaceCurvature::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  const auto input = isthmus::WholeSurface(vtkPolyData::GetData(inputVector[0], 0));
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return isthmus::Guarded(this, output,
    [&]()
    {
      CheckTolerance(this->FlatTolerance, "FlatTolerance");
      CheckTolerance(this->GaussianTolerance, "GaussianTolerance");
      CheckTolerance(this->MeanTolerance, "MeanTolerance");
      output->ShallowCopy(input);
      isthmus::SurfaceCurvatureOptions options;
      options.Estimate = static_cast<isthmus::CurvatureEstimate>(this->Method);
      options.Area = static_cast<isthmus::DualArea>(this->DualArea);
      options.Neighbourhood = static_cast<isthmus::CurvatureNeighbourhood>(this->Neighbourhood);
      options.Orientation = static_cast<isthmus::SurfaceOrientation>(this->Orientation);
      options.Radius = this->Radius;
      const isthmus::PolyDataTriangles triangles(input);
      const SurfaceCurvatureResult result = isthmus::CurvatureOfSurface(
        triangles.View(), options, isthmus::Between(isthmus::ProgressOf(this), 0.1, 0.9));
      this->AddArrays(result, output);
      const std::string complaints = Complaints(result);
      if (!complaints.empty())
      {
        vtkWarningMacro(<< complaints << "CurvatureValid is 0 there.");
      }
    });
}

void vtkSurfaceCurvature::AddArrays(const SurfaceCurvatureResult& result, vtkPolyData* output)
{
  const auto add = [&](vtkTypeBool wanted, const char* name, auto&& get)
  { AddDescriptor<vtkDoubleArray>(output, result, wanted, name, get); };
  const auto& mean = result.Mean;
  const auto& half = result.HalfDifference;
  const auto convention = static_cast<isthmus::ShapeIndexConvention>(this->ShapeIndexConvention);
  add(this->GenerateGaussianCurvature, "GaussianCurvature",
    [&](std::size_t i) { return result.Gaussian[i]; });
  add(this->GenerateMeanCurvature, "MeanCurvature", [&](std::size_t i) { return mean[i]; });
  add(this->GenerateMaximumCurvature, "MaximumCurvature",
    [&](std::size_t i) { return mean[i] + half[i]; });
  add(this->GenerateMinimumCurvature, "MinimumCurvature",
    [&](std::size_t i) { return mean[i] - half[i]; });
  add(this->GenerateShapeIndex, "ShapeIndex",
    [&](std::size_t i) { return isthmus::ShapeIndex(mean[i], half[i], convention); });
  add(this->GenerateCurvedness, "Curvedness",
    [&](std::size_t i) { return isthmus::Curvedness(mean[i], half[i]); });
  AddVectors(output, this->GeneratePrincipalDirection1, "PrincipalDirection1", result.Direction1);
  AddVectors(output, this->GeneratePrincipalDirection2, "PrincipalDirection2", result.Direction2);
  if (this->GenerateSurfaceType)
  {
    const isthmus::SurfaceTypeTolerance tolerance{ this->FlatTolerance, this->GaussianTolerance,
      this->MeanTolerance };
    AddDescriptor<vtkUnsignedCharArray>(output, result, 1, "SurfaceType",
      [&](std::size_t i)
      {
        const double size = std::sqrt(std::abs(result.Area[i]));
        return isthmus::ClassifySurface(mean[i], half[i], size, tolerance);
      });
    isthmus::AddSurfaceTypeNames(output->GetFieldData());
  }
  if (this->GeneratePointArea)
  {
    vtkNew<vtkDoubleArray> area;
    area->SetName("PointArea");
    area->SetNumberOfValues(output->GetNumberOfPoints());
    std::copy(result.Area.begin(), result.Area.end(), area->GetPointer(0));
    output->GetPointData()->AddArray(area);
  }
  AddDescriptor<vtkUnsignedCharArray>(
    output, result, 1, "CurvatureValid", [](std::size_t) { return 1; });
  // What a view colours by, and the next filter takes, unless told otherwise.
  if (this->GenerateMeanCurvature)
  {
    output->GetPointData()->SetActiveScalars("MeanCurvature");
  }
}

void vtkSurfaceCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "DualArea: " << this->DualArea << "\n";
  os << indent << "Neighbourhood: " << this->Neighbourhood << "\n";
  os << indent << "Radius: " << this->Radius << "\n";
  os << indent << "Orientation: " << this->Orientation << "\n";
  os << indent << "ShapeIndexConvention: " << this->ShapeIndexConvention << "\n";
  os << indent << "GenerateGaussianCurvature: " << this->GenerateGaussianCurvature << "\n";
  os << indent << "GenerateMeanCurvature: " << this->GenerateMeanCurvature << "\n";
  os << indent << "GenerateMaximumCurvature: " << this->GenerateMaximumCurvature << "\n";
  os << indent << "GenerateMinimumCurvature: " << this->GenerateMinimumCurvature << "\n";
  os << indent << "GenerateShapeIndex: " << this->GenerateShapeIndex << "\n";
  os << indent << "GenerateCurvedness: " << this->GenerateCurvedness << "\n";
  os << indent << "GeneratePrincipalDirection1: " << this->GeneratePrincipalDirection1 << "\n";
  os << indent << "GeneratePrincipalDirection2: " << this->GeneratePrincipalDirection2 << "\n";
  os << indent << "GenerateSurfaceType: " << this->GenerateSurfaceType << "\n";
  os << indent << "GeneratePointArea: " << this->GeneratePointArea << "\n";
  os << indent << "FlatTolerance: " << this->FlatTolerance << "\n";
  os << indent << "GaussianTolerance: " << this->GaussianTolerance << "\n";
  os << indent << "MeanTolerance: " << this->MeanTolerance << "\n";
}
