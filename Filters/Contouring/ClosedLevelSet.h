/**
 * @file ClosedLevelSet.h
 * @brief The level set of a volume in the frame of its grid, closed outside, as a field and as
 * triangles.
 */
#ifndef isthmus_ClosedLevelSet_h
#define isthmus_ClosedLevelSet_h

#include "Contouring/DelaunayIsosurface.h"
#include "Core/Geometry.h"
#include "Core/TriangleMesh.h"
#include "vtkIsthmusFiltersContouringModule.h"

#include <array>

class vtkDataArray;
class vtkImageData;

namespace isthmus
{

struct ClosedLevelSet
{
  ScalarField Field;             ///< valid as long as the image's scalars are
  Bounds3 Bounds;                ///< of the image and one layer of cells around it
  TriangleMesh Guide;            ///< by vtkFlyingEdges3D
  std::array<double, 2> Range{}; ///< of the values
};

/**
 * The level set of `scalars` (points of `image`, one component) in the frame of the grid: first
 * node at the origin, axes along the grid, lengths by spacing. Copies the image (with its layer of
 * cells) once for the guide, as double if float does not hold all its values, otherwise as float.
 * @throws std::invalid_argument when a value is not finite, the image has fewer than two nodes
 * along an axis, or it is a mask of two values, at whose corners refinement would not terminate.
 */
VTKISTHMUSFILTERSCONTOURING_EXPORT ClosedLevelSet CloseLevelSet(
  vtkImageData* image, vtkDataArray* scalars, double level, bool insideIsHigher);

/// Transforms from the frame of the grid to the world, and flips triangles if the axes of the image
/// are mirrored.
VTKISTHMUSFILTERSCONTOURING_EXPORT void ToWorld(vtkImageData* image, TriangleMesh& mesh);

}

#endif
