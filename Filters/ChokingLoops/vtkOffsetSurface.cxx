#include "vtkOffsetSurface.h"

#include "ChokingLoops/OffsetSurface.h"
#include "Core/AlgorithmGuard.h"
#include "Core/ArrayMemory.h"
#include "Core/GatherRanks.h"
#include "Core/InnerAlgorithm.h"
#include "Core/NamedColumns.h"
#include "Core/PolyDataTriangles.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <algorithm>

vtkStandardNewMacro(vtkOffsetSurface);

const std::vector<isthmus::OutputArray>& vtkOffsetSurface::OutputArrayTable()
{
  using isthmus::ArrayChoice;
  using isthmus::ArrayPlace;
  static const std::vector<isthmus::OutputArray> table{
    { 0, ArrayPlace::Points, "Normals", 3, "", ArrayChoice::None,
      "unit, outward from what the surface encloses" },
    { 0, ArrayPlace::Field, "GridSpacing", 1, "length", ArrayChoice::None,
      "of the grid on which the distance was sampled" },
  };
  return table;
}

namespace
{

/// vtkFlyingEdges3D produces floats, which cannot represent 1e40 or small differences far from the
/// origin: it works in node units, which are converted to coordinates here.
vtkSmartPointer<vtkPoints> InWorld(vtkPoints* nodes, const isthmus::DistanceGrid& grid)
{
  auto points = vtkSmartPointer<vtkPoints>::New();
  points->SetDataTypeToDouble();
  isthmus::SizePoints(points, nodes->GetNumberOfPoints());
  for (vtkIdType i = 0; i < nodes->GetNumberOfPoints(); ++i)
  {
    double p[3];
    nodes->GetPoint(i, p);
    for (std::size_t a = 0; a < 3; ++a)
    {
      p[a] = grid.Origin[a] + grid.Spacing * p[a];
    }
    points->SetPoint(i, p);
  }
  return points;
}

}

int vtkOffsetSurface::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* result = vtkPolyData::GetData(output);
  return isthmus::RunGuarded(this, output,
    [&]
    {
      const auto surface = isthmus::GatherSurface(this, vtkPolyData::GetData(input[0]));
      if (surface->GetNumberOfPoints() == 0)
      {
        return;
      }
      const isthmus::PolyDataTriangles triangles(surface);
      const isthmus::DistanceGrid grid = isthmus::OffsetDistances(triangles.View(),
        this->Parameters, isthmus::Between(isthmus::MakeProgress(this), 0.0, 0.9));
      const auto values =
        isthmus::NamedArray<vtkDoubleArray>("DistanceToSurface", grid.Values.size());
      // vtkFlyingEdges3D orients triangles towards lower values, and these must be outside.
      const double sign = this->Parameters.Side == isthmus::SideSelection::Inside ? 1.0 : -1.0;
      std::transform(grid.Values.begin(), grid.Values.end(), values->GetPointer(0),
        [sign](double value) { return sign * value; });
      vtkNew<vtkImageData> image;
      image->SetDimensions(static_cast<int>(grid.Dimensions[0]),
        static_cast<int>(grid.Dimensions[1]), static_cast<int>(grid.Dimensions[2]));
      image->GetPointData()->SetScalars(values);
      vtkNew<vtkFlyingEdges3D> contour;
      contour->SetInputData(image);
      contour->SetValue(0, sign * this->Parameters.Distance);
      contour->ComputeNormalsOn();
      contour
        ->ComputeScalarsOff(); // the distance is constant on the surface and useless as a colour
      isthmus::UpdateInner(contour);
      isthmus::Report(isthmus::MakeProgress(this), 1.0);
      result->ShallowCopy(contour->GetOutput());
      result->SetPoints(InWorld(contour->GetOutput()->GetPoints(), grid));
      isthmus::AddColumn<vtkDoubleArray>(result->GetFieldData(), "GridSpacing", { grid.Spacing });
    });
}

void vtkOffsetSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Distance: " << this->GetDistance() << "\n";
  os << indent << "Side: " << this->GetSide() << "\n";
  os << indent << "Resolution: " << this->GetResolution() << "\n";
}
