#include "vtkSurfaceRemesh.h"

#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/GatherRanks.h"
#include "Core/NumberText.h"
#include "Core/PolyDataTriangles.h"
#include "Core/RangeChecks.h"
#include "Remeshing/DelaunayRemesh.h"
#include "Surfaces/SurfaceCleaning.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/SurfaceDefects.h"
#include "Surfaces/SurfaceTopology.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <cmath>

vtkStandardNewMacro(vtkSurfaceRemesh);

const std::vector<isthmus::OutputArray>& vtkSurfaceRemesh::OutputArrayTable()
{
  static const std::vector<isthmus::OutputArray> table; // none: it passes those of the input
  return table;
}

namespace
{

/// Numbers of the old points at the new ones, by the corners of the triangle each lies on.
void InterpolatePointData(vtkPolyData* from, const isthmus::CleanedSurface& old,
  const std::vector<isthmus::SurfaceLocation>& locations, vtkPolyData* to)
{
  vtkPointData* source = from->GetPointData();
  vtkPointData* target = to->GetPointData();
  for (int a = 0; a < source->GetNumberOfArrays(); ++a)
  {
    vtkDataArray* array = source->GetArray(a);
    if (!array || array->GetDataType() == VTK_ID_TYPE)
    {
      continue; // ids and strings cannot be interpolated
    }
    auto result = vtk::TakeSmartPointer(array->NewInstance());
    result->SetName(array->GetName());
    result->SetNumberOfComponents(array->GetNumberOfComponents());
    result->CopyComponentNames(array);
    isthmus::SizeArray(result, static_cast<vtkIdType>(locations.size()));
    for (std::size_t i = 0; i < locations.size(); ++i)
    {
      const isthmus::Triangle& t =
        old.Mesh.Triangles[static_cast<std::size_t>(locations[i].Triangle)];
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        double value = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
        {
          const std::int64_t point = old.OriginalPoints[static_cast<std::size_t>(t[k])];
          value += locations[i].Weights[k] * array->GetComponent(point, c);
        }
        result->SetComponent(static_cast<vtkIdType>(i), c, value);
      }
    }
    const int index = target->AddArray(result);
    const int attribute = source->IsArrayAnAttribute(a);
    if (attribute >= 0)
    {
      target->SetActiveAttribute(index, attribute);
    }
  }
}

/// Points of the input that no triangle uses are not part of the surface.
void DropUnusedPoints(isthmus::RemeshedSurface& surface)
{
  std::vector<isthmus::Point3>& points = surface.Mesh.Points;
  std::vector<std::int64_t> number(points.size(), -1);
  for (const auto& triangle : surface.Mesh.Triangles)
  {
    for (const auto p : triangle)
    {
      number[static_cast<std::size_t>(p)] = 0;
    }
  }
  std::size_t count = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    if (number[i] == 0)
    {
      number[i] = static_cast<std::int64_t>(count);
      points[count] = points[i];
      surface.Locations[count] = surface.Locations[i];
      ++count;
    }
  }
  points.resize(count);
  surface.Locations.resize(count);
  for (auto& triangle : surface.Mesh.Triangles)
  {
    for (auto& p : triangle)
    {
      p = number[static_cast<std::size_t>(p)];
    }
  }
}

/// The change of the volume, or of the area of a surface with holes, if it is above a hundredth;
/// empty if not.
std::string DescribeChange(const isthmus::SurfaceView& before, const isthmus::SurfaceView& after)
{
  constexpr double large = 0.01;
  const bool isClosed = isthmus::FindDefects(before).BoundaryTriangles.empty();
  const auto measure = [isClosed](const isthmus::SurfaceView& mesh)
  { return isClosed ? isthmus::SignedVolume(mesh) : isthmus::SurfaceArea(mesh); };
  const double old = measure(before), made = measure(after);
  if (std::abs(made - old) <= large * std::abs(old))
  {
    return {};
  }
  return isthmus::JoinText("Remeshing changed the ", isClosed ? "volume" : "area",
    " of the surface from ", old, " to ", made, ", by ",
    isthmus::FormatNumber(100.0 * std::abs(made / old - 1.0), 2),
    " %: choose shorter edges or more triangles, or Method Delaunay with a smaller "
    "MaximumDistance.");
}

}

void vtkSurfaceRemesh::CheckParameters() const
{
  isthmus::RequireChoice<int>("Target", this->Target, ByNumberOfTriangles);
  isthmus::RequireAbove(
    "RelativeEdgeLength", this->RelativeEdgeLength, 0.0, isthmus::LargestLength);
  isthmus::RequireRange(
    "NumberOfTriangles", static_cast<double>(this->NumberOfTriangles), 1.0, isthmus::Unlimited);
  isthmus::RequireChoice<int>("Method", this->Method, Delaunay);
  isthmus::Check(this->Parameters);
}

int vtkSurfaceRemesh::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* after = vtkPolyData::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      this->CheckParameters();
      const auto before = isthmus::GatherSurface(this, vtkPolyData::GetData(input[0]));
      const auto progress = isthmus::MakeProgress(this);
      isthmus::CleanedSurface taken = isthmus::CleanSurface(isthmus::ToTriangleMesh(before));
      isthmus::TriangleMesh& mesh = taken.Mesh;
      if (mesh.Triangles.empty())
      {
        return;
      }
      isthmus::SurfaceCorrection correction;
      if (!isthmus::FindDefects(mesh).FlippedTriangles.empty())
      {
        mesh.Triangles = isthmus::OrientAlike(mesh, correction);
      }
      std::string message = taken.Message + (taken.Message.empty() ? "" : " ");
      message += correction.Message();
      if (!message.empty())
      {
        vtkWarningMacro(<< message);
      }
      isthmus::RemeshedSurface result;
      if (this->Target == ByNumberOfTriangles)
      {
        result = isthmus::SimplifySurface(mesh, this->NumberOfTriangles, progress);
      }
      else
      {
        isthmus::SurfaceRemeshParameters parameters = this->Parameters;
        if (this->Target == ByRelativeEdgeLength)
        {
          parameters.EdgeLength = this->RelativeEdgeLength * isthmus::MeanEdgeLength(mesh);
        }
        result = this->Method == Delaunay ? isthmus::DelaunayRemesh(mesh, parameters, progress)
                                          : isthmus::RemeshSurface(mesh, parameters, progress);
      }
      DropUnusedPoints(result);
      const std::string change = DescribeChange(mesh, result.Mesh);
      if (!change.empty())
      {
        vtkWarningMacro(<< change);
      }
      isthmus::SetMesh(result.Mesh, after);
      InterpolatePointData(before, taken, result.Locations, after);
      after->GetFieldData()->PassData(before->GetFieldData());
    });
}

void vtkSurfaceRemesh::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Target: " << this->Target << "\n";
  os << indent << "RelativeEdgeLength: " << this->RelativeEdgeLength << "\n";
  os << indent << "EdgeLength: " << this->Parameters.EdgeLength << "\n";
  os << indent << "NumberOfTriangles: " << this->NumberOfTriangles << "\n";
  os << indent << "Method: " << this->Method << "\n";
  os << indent << "MinimumAngle: " << this->Parameters.MinimumAngle << "\n";
  os << indent << "MaximumDistance: " << this->Parameters.MaximumDistance << "\n";
  os << indent << "NumberOfIterations: " << this->Parameters.NumberOfIterations << "\n";
  os << indent << "FeatureAngle: " << this->Parameters.FeatureAngle << "\n";
}
