#include "vtkSurfaceCurvature.h"

#include "Core/AlgorithmGuard.h"
#include "Core/GatherRanks.h"
#include "Core/Index.h"
#include "Core/NamedColumns.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Curvature/CurvatureDescriptors.h"
#include "Curvature/DifferentialForms.h"
#include "Curvature/GaussBonnet.h"
#include "Curvature/SurfaceTypeNames.h"
#include "Surfaces/SurfaceCleaning.h"

#include <vtkDataArraySelection.h>
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

isthmus::DifferentialFormsSelection SelectForms(vtkSurfaceCurvature* filter)
{
  return { filter->GetOutputArraySelection(), filter->GetNormalCurvatureDirection() };
}

/// Adds a point array with `get(point)` where points are valid, 0 elsewhere.
template <typename Array, typename Get>
void AddDescriptor(vtkPolyData* output, const SurfaceCurvatureResult& result, bool wanted,
  const char* name, Get&& get)
{
  if (!wanted)
  {
    return;
  }
  using Value = typename Array::ValueType;
  isthmus::AddComputedColumn<Array>(output->GetPointData(), name, result.Valid.size(),
    [&](std::size_t point)
    { return result.Valid[point] ? static_cast<Value>(get(point)) : Value{ 0 }; });
}

void AddVectors(
  vtkPolyData* output, bool wanted, const char* name, const std::vector<double>& vectors)
{
  if (!wanted || vectors.empty())
  {
    return;
  }
  auto* array =
    isthmus::AddArray<vtkDoubleArray>(output->GetPointData(), name, vectors.size() / 3, 3);
  std::copy(vectors.begin(), vectors.end(), array->GetPointer(0));
}

/// Copies to every point the values of the point that represents its place.
void CopyToDuplicates(const std::vector<vtkIdType>& places, SurfaceCurvatureResult& result)
{
  const auto spread = [&places](auto& values, std::size_t components)
  {
    for (std::size_t i = 0; i < values.size(); ++i)
    {
      values[i] = values[components * isthmus::At(places[i / components]) + i % components];
    }
  };
  for (auto* values : { &result.Gaussian, &result.Mean, &result.HalfDifference, &result.Area })
  {
    spread(*values, 1);
  }
  spread(result.Valid, 1);
  spread(result.Direction1, 3);
  spread(result.Direction2, 3);
  spread(result.Normal, 3);
  spread(result.MeanNormal, 3);
}

/// Curvature with coincident points merged (SurfaceCleaning.h) where the surface is not closed and
/// regular otherwise: files with texture coordinates or normals at corners are open at every seam.
/// `places`: for each point the one that represents its position, empty if no points coincide.
SurfaceCurvatureResult CurvatureAtPlaces(const isthmus::SurfaceView& mesh,
  const isthmus::SurfaceCurvatureOptions& options, const isthmus::ProgressCallback& progress,
  std::vector<vtkIdType>& places)
{
  SurfaceCurvatureResult result = isthmus::ComputeSurfaceCurvature(mesh, options, progress);
  if (result.BoundaryPoints + result.IrregularPoints + result.DegeneratePoints == 0)
  {
    return result;
  }
  const std::vector<isthmus::Triangle> merged = isthmus::MergedCorners(mesh, &places);
  if (std::equal(merged.begin(), merged.end(), mesh.Triangles.begin(), mesh.Triangles.end()))
  {
    places.clear();
    return result;
  }
  result = isthmus::ComputeSurfaceCurvature({ mesh.Points, merged }, options, progress);
  CopyToDuplicates(places, result);
  return result;
}

/// The points' areas; points at one place share its area, so that all still sum to the surface's.
void AddAreas(
  const std::vector<vtkIdType>& places, const std::vector<double>& areas, vtkPolyData* output)
{
  std::vector<int> sharers(places.size(), 0);
  for (const vtkIdType place : places)
  {
    ++sharers[isthmus::At(place)];
  }
  isthmus::AddComputedColumn<vtkDoubleArray>(output->GetPointData(), "PointArea", areas.size(),
    [&](std::size_t i)
    { return places.empty() ? areas[i] : areas[i] / sharers[isthmus::At(places[i])]; });
}

/// Integral of the Gaussian curvature: each position counts once, with its area.
double IntegralOver(const std::vector<vtkIdType>& places, const SurfaceCurvatureResult& result)
{
  double sum = 0.0;
  for (std::size_t i = 0; i < result.Gaussian.size(); ++i)
  {
    const bool counts = result.Valid[i] != 0 && (places.empty() || isthmus::At(places[i]) == i);
    sum += counts ? result.Gaussian[i] * result.Area[i] : 0.0;
  }
  return sum;
}

/// Warning about points without curvature; empty if there are none.
std::string DescribeProblems(const SurfaceCurvatureResult& result)
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
    " points have no curvature because the surface around them is not a disc or its triangles are "
    "not oriented consistently. ");
  add(result.DegeneratePoints,
    " points have no curvature because a triangle at them has no area: clean or remesh the "
    "surface. ");
  add(result.AreaNotPositive,
    " points have no curvature because obtuse triangles make their Voronoi area negative: choose "
    "the mixed one (Point Area Rule; SetDualArea in C++), or remesh the surface. ");
  return text;
}

}

const std::vector<isthmus::OutputArray>& vtkSurfaceCurvature::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    ISTHMUS_CURVATURE_ARRAY_ROWS,
    { 0, ArrayPlace::Points, "MeanCurvatureNormal", 3, "1/length", ArrayChoice::Off,
      "H n, which points outwards where the surface is convex, whatever Orientation is; with "
      "AngleDefect from the cotangent formula, otherwise H times the mean normal of the "
      "triangles" },
    { 0, ArrayPlace::Points, "PointArea", 1, "length^2", ArrayChoice::On,
      "area assigned to each point, the weight for means over the surface" },
  };
  return table;
}

vtkSurfaceCurvature::vtkSurfaceCurvature()
  : OutputArrays(this, OutputArrayTable())
{
}

int vtkSurfaceCurvature::RequestData(
  vtkInformation*, vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  vtkPolyData* output = vtkPolyData::GetData(outputVector, 0);
  return isthmus::RunGuarded(this, outputVector,
    [&]()
    {
      const auto input = isthmus::GatherSurface(this, vtkPolyData::GetData(inputVector[0], 0));
      isthmus::Check(this->Parameters);
      this->OutputArrays.Check();
      SelectForms(this).Check();
      output->ShallowCopy(input);
      isthmus::SurfaceCurvatureOptions options = this->Parameters;
      options.Normals = this->OutputArrays.Has("MeanCurvatureNormal") || SelectForms(this).Any();
      const isthmus::PolyDataTriangles triangles(input);
      std::vector<vtkIdType> places;
      const SurfaceCurvatureResult result = CurvatureAtPlaces(
        triangles.View(), options, isthmus::Between(isthmus::MakeProgress(this), 0.1, 0.9), places);
      this->AddArrays(result, output);
      isthmus::AddGaussBonnet(IntegralOver(places, result), output->GetFieldData());
      if (this->OutputArrays.Has("PointArea"))
      {
        AddAreas(places, result.Area, output);
      }
      const std::string complaints = DescribeProblems(result);
      if (!complaints.empty())
      {
        vtkWarningMacro(<< isthmus::JoinText(complaints, "CurvatureValid is 0 there."));
      }
    });
}

void vtkSurfaceCurvature::AddArrays(const SurfaceCurvatureResult& result, vtkPolyData* output)
{
  const auto add = [&](const char* name, auto&& get)
  { AddDescriptor<vtkDoubleArray>(output, result, this->OutputArrays.Has(name), name, get); };
  const auto addVectors = [&](const char* name, const std::vector<double>& vectors)
  { AddVectors(output, this->OutputArrays.Has(name), name, vectors); };
  const auto& mean = result.Mean;
  const auto& half = result.HalfDifference;
  add("GaussianCurvature", [&](std::size_t i) { return result.Gaussian[i]; });
  add("MeanCurvature", [&](std::size_t i) { return mean[i]; });
  add("MaximumCurvature", [&](std::size_t i) { return mean[i] + half[i]; });
  add("MinimumCurvature", [&](std::size_t i) { return mean[i] - half[i]; });
  add("ShapeIndex",
    [&](std::size_t i)
    { return isthmus::ShapeIndex(mean[i], half[i], this->Parameters.ShapeIndexConvention); });
  add("Curvedness", [&](std::size_t i) { return isthmus::Curvedness(mean[i], half[i]); });
  addVectors("PrincipalDirection1", result.Direction1);
  addVectors("PrincipalDirection2", result.Direction2);
  addVectors("MeanCurvatureNormal", result.MeanNormal);
  addVectors("GaussMap", result.Normal);
  if (const auto selection = SelectForms(this); selection.Any())
  {
    vtkNew<vtkPolyData> made; // from arrays that need not all be requested
    made->ShallowCopy(output);
    const auto put = [&](const char* name, double sign)
    {
      AddDescriptor<vtkDoubleArray>(
        made, result, true, name, [&](std::size_t i) { return mean[i] + sign * half[i]; });
    };
    put("MaximumCurvature", 1.0);
    put("MinimumCurvature", -1.0);
    AddVectors(made, true, "PrincipalDirection1", result.Direction1);
    AddVectors(made, true, "PrincipalDirection2", result.Direction2);
    AddVectors(made, true, "GaussMap", result.Normal);
    isthmus::AddDifferentialForms(selection, made);
    for (const char* name : { "ShapeOperator", "FirstFundamentalForm", "SecondFundamentalForm",
           "AreaElement", "NormalCurvature" })
    {
      if (vtkDataArray* array = made->GetPointData()->GetArray(name))
      {
        output->GetPointData()->AddArray(array);
      }
    }
  }
  if (this->OutputArrays.Has("SurfaceType"))
  {
    AddDescriptor<vtkUnsignedCharArray>(output, result, 1, "SurfaceType",
      [&](std::size_t i)
      {
        const double size = std::sqrt(std::abs(result.Area[i]));
        return isthmus::ClassifySurface(mean[i], half[i], size, this->Parameters);
      });
    isthmus::AddSurfaceTypeNames(output->GetFieldData());
  }
  AddDescriptor<vtkUnsignedCharArray>(
    output, result, 1, "CurvatureValid", [](std::size_t) { return 1; });
  // The default array for colours and for the next filter.
  if (this->OutputArrays.Has("MeanCurvature"))
  {
    output->GetPointData()->SetActiveScalars("MeanCurvature");
  }
}

void vtkSurfaceCurvature::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Method: " << this->GetMethod() << "\n";
  os << indent << "DualArea: " << this->GetDualArea() << "\n";
  os << indent << "Neighbourhood: " << this->GetNeighbourhood() << "\n";
  os << indent << "Radius: " << this->Parameters.Radius << "\n";
  os << indent << "Orientation: " << this->GetOrientation() << "\n";
  os << indent << "ShapeIndexConvention: " << this->GetShapeIndexConvention() << "\n";
  this->PrintCurvatureProperties(os, indent);
  this->OutputArrays.Print(os, indent);
}
