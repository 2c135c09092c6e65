/**
 * @file GridImages.h
 * @brief Conversions between the algorithms on grids and VTK's images and surfaces.
 */
#ifndef isthmus_GridImages_h
#define isthmus_GridImages_h

#include "Surfaces/SurfaceCrossings.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkImageData;
class vtkPolyData;

namespace isthmus
{

/// @throws std::invalid_argument for spacings that are not positive and for a single layer of
/// nodes.
GridShape GetGridShape(vtkImageData* image);

/// The surface with the coordinates of its points as lengths along the axes of the grid from its
/// first node.
vtkSmartPointer<vtkPolyData> InGridAxes(vtkPolyData* surface, vtkImageData* grid);

/// Transforms lengths along the axes of the grid from its first node to world coordinates; valid
/// while `grid` exists.
PlaceInWorld MakeWorldTransform(vtkImageData* grid);

/// Box of the points that polygons of `surface` use: minimum and maximum of x, y and z. Points that
/// no polygon uses, e.g. leftovers of other filters, do not count. @return false if there are
/// none.
bool ComputePolygonBounds(vtkPolyData* surface, double box[6]);

/// The isosurface of the image, in lengths along its axes from its first node. Scalars of any type.
vtkSmartPointer<vtkPolyData> IsosurfaceInGridAxes(
  vtkImageData* image, vtkDataArray* scalars, double level);

void AddFlags(vtkImageData* output, const char* name, const std::vector<unsigned char>& flags);

/// Adds `SignedDistance`, negative inside, as the active scalars.
void AddSignedDistance(vtkImageData* output, const std::vector<unsigned char>& inside,
  const std::vector<double>& distance);

/// Sets `output` to the crossings as vertices in world coordinates, with their arrays.
void FillCrossings(
  const std::vector<GridCrossing>& crossings, vtkImageData* grid, vtkPolyData* output);

}

#endif
