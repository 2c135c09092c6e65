/**
 * @file FlowSurfaceOutput.h
 * @brief A flow's result as VTK data: image, surface, table.
 */
#ifndef isthmus_FlowSurfaceOutput_h
#define isthmus_FlowSurfaceOutput_h

#include "MolecularSurfaces/SurfaceFlowParameters.h"

class vtkImageData;
class vtkPolyData;
class vtkTable;

namespace isthmus
{

/// Geometry of the grid, without arrays.
void SetImageGeometry(const DensityGrid& grid, vtkImageData* image);

/// The arrays SignedDistance and S. Nodes that lie on the level `distance` to a thousandth of a
/// spacing are moved off it by that much, so that no triangle of the surface is a point.
void FillImage(const SurfaceFlowResult& result, double distance, vtkImageData* image);

/// The surface on which SignedDistance is `distance` (or S is `level`, where the result has an S of
/// its own), facing outwards, with normals.
void ContourImage(
  vtkImageData* image, bool ofS, double level, double distance, vtkPolyData* surface);

/// One row a record; Energy is tension x area + pressure x volume.
void FillHistory(
  const SurfaceFlowResult& result, double tension, double pressure, vtkTable* history);

/// Half of the distance in which S goes from 1 to 0, in spacings.
constexpr double HalfWidthOfS = 1.2;

}

#endif
