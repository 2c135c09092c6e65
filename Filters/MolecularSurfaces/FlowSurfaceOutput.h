/**
 * @file FlowSurfaceOutput.h
 * @brief Converts the result of a flow to VTK data: image, surface, table.
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

/// The arrays SignedDistance and S. Nodes that lie on the level to within a thousandth of a spacing
/// are moved away from it by that amount, so that no triangle of the surface degenerates to a
/// point.
void FillImage(const SurfaceFlowResult& result, double distance, vtkImageData* image);

/// The surface on which SignedDistance is `distance` (or S is `level`, if the result has its own
/// S), facing outwards, with normals.
void ContourImage(
  vtkImageData* image, bool ofS, double level, double distance, vtkPolyData* surface);

/// One row for each record; Energy is tension x area + pressure x volume.
void FillHistory(
  const SurfaceFlowResult& result, double tension, double pressure, vtkTable* history);

/// Half the distance over which S changes from 1 to 0, in spacings.
constexpr double HalfWidthOfS = 1.2;

}

#endif
