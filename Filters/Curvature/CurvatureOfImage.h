/**
 * @file CurvatureOfImage.h
 * @brief HessianCurvature on VTK data: image scalars in, named arrays out.
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

/// Which arrays to compute; CurvatureValid is always computed.
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
 * point data of `output`. Directions are in world axes; options.Axes is set here. Throws the
 * exceptions of HessianCurvatureAtNodes().
 */
void AddCurvatureAtNodes(vtkImageData* image, vtkDataArray* scalars, const Extent& box,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress);

/// The same at `points`, in world coordinates.
void AddCurvatureAtPoints(vtkImageData* image, vtkDataArray* scalars, vtkPoints* points,
  HessianCurvatureOptions options, const CurvatureSelection& selection, vtkDataSet* output,
  const ProgressCallback& progress);

/// The scale for `scalars` of `image`, which is this rank's part of an image of extent `whole` and
/// spacing `spacing`. A rank without scalars must also call this, with null. See
/// ChooseCurvatureScale().
CurvatureScale ChooseImageScale(vtkImageData* image, vtkDataArray* scalars, const Extent& whole,
  const double spacing[3], int accuracy, const MaximumOverRanks& combine,
  const ProgressCallback& progress);

/**
 * Two steps that fill the arrays CurvatureScale and CurvatureError, which were created on `output`
 * by AddCurvatureAtNodes(), or by AddCurvatureAtPoints() for `points`, with selection.Error. The
 * first step needs the scalars from which the curvature was computed, the second the scalars
 * smoothed at scale.NextScale. `points` is null for nodes; `box` is not used with points.
 */
void AddReferenceCurvature(vtkImageData* image, vtkDataArray* scalars, const Extent& box,
  vtkPoints* points, const HessianCurvatureOptions& options, vtkDataSet* output,
  const ProgressCallback& progress);
void AddErrors(vtkImageData* image, vtkDataArray* next, const Extent& box, vtkPoints* points,
  const HessianCurvatureOptions& options, const CurvatureSelection& selection,
  const CurvatureScale& scale, vtkDataSet* output, const ProgressCallback& progress);

/// Adds the same arrays, empty, if there are no nodes or points, so that all MPI ranks have them.
void AddNoCurvature(const CurvatureSelection& selection, vtkDataSet* output);

}

#endif
