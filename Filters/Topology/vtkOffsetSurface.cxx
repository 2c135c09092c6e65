#include "vtkOffsetSurface.h"

#include "AlgorithmGuard.h"
#include "PolyDataMesh.h"
#include "SurfaceDistance.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFlyingEdges3D.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <stdexcept>

vtkStandardNewMacro(vtkOffsetSurface);

int vtkOffsetSurface::RequestData(
  vtkInformation*, vtkInformationVector** input, vtkInformationVector* output)
{
  auto* surface = vtkPolyData::GetData(input[0]);
  auto* result = vtkPolyData::GetData(output);
  if (surface->GetNumberOfPoints() == 0)
  {
    return 1;
  }
  return isthmus::Guarded(this, result,
    [&]
    {
      if (!(this->Distance > 0.0))
      {
        throw std::invalid_argument("The distance of the offset surface must be above 0.");
      }
      const isthmus::TriangleMesh mesh = isthmus::MeshOf(surface);
      if (mesh.Triangles.empty())
      {
        throw std::invalid_argument("The input has no triangles to keep a distance from.");
      }
      isthmus::Bounds3 box{ mesh.Points.front(), mesh.Points.front() };
      for (const isthmus::Point3& p : mesh.Points)
      {
        box.Add(p);
      }
      // Room for the offset and a cell beyond it.
      const double width =
        std::max({ box.Max[0] - box.Min[0], box.Max[1] - box.Min[1], box.Max[2] - box.Min[2] });
      const double margin = this->Distance + 2.0 * width / this->Resolution;
      for (std::size_t a = 0; a < 3; ++a)
      {
        box.Min[a] -= margin;
        box.Max[a] += margin;
      }
      const isthmus::DistanceGrid grid = isthmus::GridOfDistances(
        mesh, box, this->Resolution, isthmus::Between(isthmus::ProgressOf(this), 0.0, 0.9));
      vtkNew<vtkDoubleArray> values;
      values->SetName("DistanceToSurface");
      values->SetNumberOfValues(static_cast<vtkIdType>(grid.Values.size()));
      std::copy(grid.Values.begin(), grid.Values.end(), values->GetPointer(0));
      vtkNew<vtkImageData> image;
      image->SetDimensions(static_cast<int>(grid.Dimensions[0]),
        static_cast<int>(grid.Dimensions[1]), static_cast<int>(grid.Dimensions[2]));
      image->SetOrigin(grid.Origin.data());
      image->SetSpacing(grid.Spacing, grid.Spacing, grid.Spacing);
      image->GetPointData()->SetScalars(values);
      vtkNew<vtkFlyingEdges3D> contour;
      contour->SetInputData(image);
      contour->SetValue(0, this->Distance);
      contour->ComputeNormalsOn();
      contour->Update();
      result->ShallowCopy(contour->GetOutput());
      vtkNew<vtkDoubleArray> spacing;
      spacing->SetName("GridSpacing");
      spacing->InsertNextValue(grid.Spacing);
      result->GetFieldData()->AddArray(spacing);
    });
}

void vtkOffsetSurface::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Distance: " << this->Distance << "\n";
  os << indent << "Resolution: " << this->Resolution << "\n";
}
