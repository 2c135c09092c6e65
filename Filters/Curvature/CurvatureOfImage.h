/**
 * @file CurvatureOfImage.h
 * @brief HessianCurvature on VTK's data: image scalars in, named arrays out.
 *
 * Formulas, signs, units and validity: HessianCurvature.h. Array names: vtkHessianCurvature.h.
 */
#ifndef isthmus_CurvatureOfImage_h
#define isthmus_CurvatureOfImage_h

#include "Core/ImageExtent.h"
#include "Curvature/HessianCurvature.h"

class vtkDataArray;
class vtkDataSet;
class vtkImageData;
class vtkPoints;

namespace isthmus
{

/// Which arrays to make; CurvatureValid is made always.
struct CurvatureSelection
{
  bool Gaussian = true;
  bool Mean = true;
  bool Maximum = true;
  bool Minimum = true;
  bool ShapeIndex = true;
  bool Curvedness = true;
  bool Direction1 = false;
  bool Direction2 = false;
  bool SurfaceType = false;
};

/**
 * Adds the curvature of `scalars` (one value for each node of `image`) at the nodes of `box` to the
 * point data of `output`. Directions come out in world axes; options.Axes is set here.
 * Throws what HessianCurvatureAtNodes throws.
 */
void AddCurvatureAtNodes(vtkImageData* image, vtkDataArray* scalars, const Extent& box,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress);

/// The same at `points`, in world coordinates.
void AddCurvatureAtPoints(vtkImageData* image, vtkDataArray* scalars, vtkPoints* points,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress);

/// Adds the same arrays, without a value, where there is no place: so all MPI ranks have them.
void AddNoCurvature(const CurvatureSelection& selection, vtkDataSet* output);

}

#endif
