/**
 * @file FieldImage.h
 * @brief Images that sample a function, and common queries of them.
 */
#ifndef isthmus_FieldImage_h
#define isthmus_FieldImage_h

#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>

#include <array>

namespace isthmus::testing
{

struct Lattice
{
  std::array<int, 3> Dimensions{ 1, 1, 1 };
  std::array<double, 3> Origin{ 0.0, 0.0, 0.0 };
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 9> Direction{ 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
};

/// n x n x n nodes from -half to half on each axis.
inline Lattice CenteredCube(int n, double half)
{
  const double h = 2.0 * half / (n - 1);
  Lattice lattice;
  lattice.Dimensions = { n, n, n };
  lattice.Origin = { -half, -half, -half };
  lattice.Spacing = { h, h, h };
  return lattice;
}

/// `f(x, y, z)` at each node in world coordinates, as scalars "Field" of the given VTK type.
template <typename F>
vtkSmartPointer<vtkImageData> SampledImage(const Lattice& lattice, F&& f, int type = VTK_DOUBLE)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(lattice.Dimensions.data());
  image->SetOrigin(lattice.Origin.data());
  image->SetSpacing(lattice.Spacing.data());
  image->SetDirectionMatrix(lattice.Direction.data());
  image->AllocateScalars(type, 1);
  vtkDataArray* scalars = image->GetPointData()->GetScalars();
  scalars->SetName("Field");
  for (vtkIdType id = 0; id < image->GetNumberOfPoints(); ++id)
  {
    const double* p = image->GetPoint(id);
    scalars->SetComponent(id, 0, f(p[0], p[1], p[2]));
  }
  return image;
}

/// A point array of a data set by name; null where there is none.
inline vtkDataArray* PointArray(vtkDataObject* data, const char* name)
{
  return vtkDataSet::SafeDownCast(data)->GetPointData()->GetArray(name);
}

}

#endif
