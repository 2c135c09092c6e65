// libFuzzer target: the bytes as a filter, its properties and a small surface. The output has
// finite points, or is empty with an error message.
//
// Byte 0 chooses the filter, 1 to 8 its properties, 9 the shape (1 in 2: a sphere that the other
// bytes damage, as they do with points and corners; else all of it from the bytes).

#include "FuzzInput.h"
#include "vtkChokingLoops.h"
#include "vtkMeshQualityReport.h"
#include "vtkOffsetSurface.h"
#include "vtkSurfaceCurvature.h"
#include "vtkSurfaceMeasures.h"
#include "vtkSurfaceRemesh.h"
#include "vtkSurfaceToGrid.h"
#include "vtkTetrahedralMesher.h"

#include "SurfaceModels.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCommand.h>
#include <vtkExecutive.h>
#include <vtkNew.h>
#include <vtkPointSet.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <limits>

using namespace isthmus::testing;

namespace
{

constexpr std::size_t HeadBytes = 10;
constexpr std::size_t MostPoints = 200;

/// Unusual numbers for properties and coordinates.
const double Odd[] = { 0.0, -1.0, 1e-300, 1e-38, 1e-12, 1e-3, 0.3, 2.0, 1e3, 1e9, 1e20, 1e38, 1e150,
  1e300, std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN() };

/// Values that legitimately request millions of triangles or nodes take minutes under sanitizers
/// and are excluded; values that must be refused are kept.
double LimitLength(double length, double least)
{
  return length > 1e-6 && length < least ? least : length;
}

struct Bytes
{
  const uint8_t* Next;
  const uint8_t* End;

  uint8_t Take() { return this->Next < this->End ? *this->Next++ : 0; }
  /// An unusual number one time in four, otherwise a multiple of 1/32.
  double Number()
  {
    const uint8_t byte = this->Take();
    return byte % 4 == 0 ? Odd[byte / 16] : (byte - 128) / 32.0;
  }
};

vtkSmartPointer<vtkPolyData> MakeSurface(Bytes bytes, bool damagedSphere)
{
  Model model;
  if (damagedSphere)
  {
    model = Icosphere(2, 1.0);
    while (bytes.Next < bytes.End)
    {
      const uint8_t what = bytes.Take();
      if (what % 2 == 0)
      {
        model.Points[bytes.Take() % model.Points.size()][what / 2 % 3] = bytes.Number();
      }
      else
      {
        auto& triangle = model.Triangles[bytes.Take() % model.Triangles.size()];
        triangle[what / 2 % 3] =
          static_cast<vtkIdType>(bytes.Take() % (model.Points.size() + 2)) - 1;
      }
    }
    return ToPolyData(model);
  }
  const std::size_t points = bytes.Take() % MostPoints;
  for (std::size_t i = 0; i < points; ++i)
  {
    const double x = bytes.Number(), y = bytes.Number(), z = bytes.Number();
    model.AddPoint(x, y, z);
  }
  while (bytes.Next + 2 < bytes.End)
  {
    const vtkIdType a = bytes.Take(), b = bytes.Take(), c = bytes.Take();
    model.Triangles.push_back({ a - 1, b - 1, c - 1 });
  }
  return ToPolyData(model);
}

vtkSmartPointer<vtkAlgorithm> MakeFilter(Bytes& bytes)
{
  const uint8_t kind = bytes.Take() % 9;
  if (kind == 0)
  {
    auto filter = vtkSmartPointer<vtkOffsetSurface>::New();
    filter->SetDistance(bytes.Number());
    filter->SetSide(bytes.Take() % 3);
    filter->SetResolution(bytes.Take() % 32);
    return filter;
  }
  if (kind == 1 || kind == 2)
  {
    auto filter = vtkSmartPointer<vtkSurfaceRemesh>::New();
    filter->SetTarget(bytes.Take() % 3);
    filter->SetRelativeEdgeLength(LimitLength(bytes.Number(), 0.2));
    filter->SetEdgeLength(LimitLength(std::abs(bytes.Number()), 0.1));
    filter->SetNumberOfTriangles(bytes.Take());
    filter->SetFeatureAngle(bytes.Number());
    return filter;
  }
  if (kind == 3)
  {
    auto filter = vtkSmartPointer<vtkSurfaceToGrid>::New();
    const double spacing = bytes.Number();
    filter->SetSpacing(LimitLength(spacing, 0.05));
    filter->SetPadding(bytes.Take() % 8);
    const double band = bytes.Number();
    filter->SetBandWidth(spacing > 0.2 ? band : std::min(band, 3.0));
    return filter;
  }
  if (kind == 4)
  {
    auto filter = vtkSmartPointer<vtkTetrahedralMesher>::New();
    filter->SetLibrary(vtkTetrahedralMesher::CGAL);
    filter->SetRepair(bytes.Take() % 2);
    filter->SetSide(bytes.Take() % 3);
    filter->SetFacetSize(0.5 + std::abs(bytes.Number()));
    filter->SetCellSize(0.5 + std::abs(bytes.Number()));
    return filter;
  }
  if (kind == 5)
  {
    auto filter = vtkSmartPointer<vtkChokingLoops>::New();
    filter->SetSampleSpacing(0.2 + std::abs(bytes.Number()));
    filter->SetCapHoles(bytes.Take() % 2);
    filter->SetAllowSelfIntersections(bytes.Take() % 2);
    return filter;
  }
  if (kind == 6)
  {
    auto filter = vtkSmartPointer<vtkSurfaceCurvature>::New();
    filter->SetMethod(bytes.Take() % 2);
    filter->SetRadius(bytes.Number());
    return filter;
  }
  if (kind == 7)
  {
    return vtkSmartPointer<vtkSurfaceMeasures>::New();
  }
  return vtkSmartPointer<vtkMeshQualityReport>::New();
}

void CheckPoints(vtkDataObject* data)
{
  auto* points = vtkPointSet::SafeDownCast(data);
  for (vtkIdType i = 0; points && i < points->GetNumberOfPoints(); ++i)
  {
    for (int a = 0; a < 3; ++a)
    {
      if (!std::isfinite(points->GetPoint(i)[a]))
      {
        std::abort();
      }
    }
  }
}

}

extern "C" int LLVMFuzzerInitialize(int*, char***)
{
  isthmus::testing::OneThreadAndSilence();
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  if (size < HeadBytes + 4)
  {
    return 0;
  }
  Bytes head{ data, data + HeadBytes };
  const auto filter = MakeFilter(head);
  const auto surface = MakeSurface({ data + HeadBytes, data + size }, data[HeadBytes - 1] % 2 == 0);
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* number, void*) { ++*static_cast<int*>(number); });
  filter->AddObserver(vtkCommand::ErrorEvent, count);
  filter->SetInputDataObject(surface);
  filter->Update();
  // Filters that pass on their input must leave its points unchanged.
  const bool passes = filter->IsA("vtkSurfaceMeasures") || filter->IsA("vtkSurfaceCurvature") ||
    filter->IsA("vtkMeshQualityReport");
  vtkDataObject* output = filter->GetOutputDataObject(0);
  if (errors > 0 && output->GetNumberOfElements(vtkDataObject::POINT) > 0)
  {
    std::abort(); // an error and a result
  }
  if (errors == 0 && !passes)
  {
    CheckPoints(output);
  }
  return 0;
}
