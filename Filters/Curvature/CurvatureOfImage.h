/**
 * @file CurvatureOfImage.h
 * @brief HessianCurvature on VTK's data: image scalars in, named arrays out.
 *
 * Formulas, signs, units and validity: HessianCurvature.h. Array names: vtkHessianCurvature.h.
 */
#ifndef isthmus_CurvatureOfImage_h
#define isthmus_CurvatureOfImage_h

#include "Core/ImageExtent.h"
#include "Curvature/CurvatureScale.h"
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
  bool Error = false;  ///< CurvatureScale and CurvatureError
  bool Normal = false; ///< GaussMap
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

/// The scale for `scalars` of `image`, the part that this rank has of an image of extent `whole`
/// and spacing `spacing`. A rank without scalars takes part with null. See ChooseCurvatureScale.
CurvatureScale ChooseScaleOfImage(vtkImageData* image, vtkDataArray* scalars, const Extent& whole,
  const double spacing[3], int accuracy, const MaximumOverRanks& combine,
  const ProgressCallback& progress);

/**
 * Two steps to the arrays CurvatureScale and CurvatureError, which AddCurvatureAtNodes, or
 * AddCurvatureAtPoints for `points`, made on `output` with selection.Error. The first takes the
 * scalars that the curvature was computed from, the second the scalars smoothed at scale.NextScale.
 * `box` is not used with points, which are null for nodes.
 */
void AddReferenceCurvature(vtkImageData* image, vtkDataArray* scalars, const Extent& box,
  vtkPoints* points, const HessianCurvatureOptions& options, vtkDataSet* output,
  const ProgressCallback& progress);
void AddErrors(vtkImageData* image, vtkDataArray* next, const Extent& box, vtkPoints* points,
  const HessianCurvatureOptions& options, const CurvatureSelection& selection,
  const CurvatureScale& scale, vtkDataSet* output, const ProgressCallback& progress);

/// Adds the same arrays, without a value, where there is no place: so all MPI ranks have them.
void AddNoCurvature(const CurvatureSelection& selection, vtkDataSet* output);

}

#endif
