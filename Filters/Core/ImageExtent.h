/**
 * @file ImageExtent.h
 * @brief Boxes of image nodes in VTK's extent form: pipeline requests, growing, clipping, counting,
 * covering points, cropping an image.
 */
#ifndef isthmus_ImageExtent_h
#define isthmus_ImageExtent_h

#include "vtkIsthmusFiltersCoreModule.h"

#include <array>
#include <cstdint>
#include <functional>

class vtkImageData;
class vtkInformation;
class vtkInformationIntegerVectorKey;

namespace isthmus
{

/// First and last node along x, y and z; empty if a last node is below its first.
using Extent = std::array<int, 6>;

/// The extent that `info` has for `key`, empty if there is none.
VTKISTHMUSFILTERSCORE_EXPORT Extent ReadExtent(
  vtkInformation* info, vtkInformationIntegerVectorKey* key);

/// The extent that a source which splits `all` produces for the piece in `request`, including ghost
/// layers.
VTKISTHMUSFILTERSCORE_EXPORT Extent GetPieceExtent(vtkInformation* request, const Extent& all);

/// Changes a request for an image to a request for the whole image, on each rank.
VTKISTHMUSFILTERSCORE_EXPORT void RequestAll(vtkInformation* request);

/// Requests the whole extent of the image of `input`, for any requested part of the result.
VTKISTHMUSFILTERSCORE_EXPORT void RequestWholeExtent(vtkInformation* input);

/// Sets the whole extent, origin and spacing of the image that `output` will be in the pipeline.
VTKISTHMUSFILTERSCORE_EXPORT void SetImageInformation(vtkInformation* output, vtkImageData* image);

/// The same for an image whose geometry `make` sets. If that throws, no error is reported, but an
/// empty extent is set: the execution fails in the same way, reports the error and empties its
/// outputs.
VTKISTHMUSFILTERSCORE_EXPORT void SetImageInformation(
  vtkInformation* output, const std::function<void(vtkImageData*)>& make);

/// Whether `output` is requested as the first piece or as a whole; results that cannot be split are
/// computed only then.
VTKISTHMUSFILTERSCORE_EXPORT bool IsFirstPiece(vtkInformation* output);

/// @throws std::runtime_error if the image in `info` is not the whole image, because its source
/// always splits it.
VTKISTHMUSFILTERSCORE_EXPORT void RequireWholeExtent(vtkInformation* info);

/// Whether this rank computes the result for the image in `info`. If every rank has the whole
/// image, the first rank does; blocks of composite data, which have no whole extent, are processed
/// on their own rank.
VTKISTHMUSFILTERSCORE_EXPORT bool IsProducedOnThisRank(vtkInformation* info);

VTKISTHMUSFILTERSCORE_EXPORT bool IsEmpty(const Extent& extent);

/// `extent` with `reach` more nodes to each side, kept within `whole`. An empty extent is not
/// changed.
VTKISTHMUSFILTERSCORE_EXPORT Extent GrowExtent(
  const Extent& extent, const std::array<int, 3>& reach, const Extent& whole);

/// Number of nodes of an extent, 0 if it is empty.
VTKISTHMUSFILTERSCORE_EXPORT std::int64_t NodeCount(const Extent& extent);

/// The intersection of both.
VTKISTHMUSFILTERSCORE_EXPORT Extent Intersection(const Extent& a, const Extent& b);

/// Whether no node of `inner` lies outside `outer`.
VTKISTHMUSFILTERSCORE_EXPORT bool Contains(const Extent& outer, const Extent& inner);

/// The number of layers of nodes around `inner` needed to cover `outer`.
VTKISTHMUSFILTERSCORE_EXPORT int LayersBetween(const Extent& inner, const Extent& outer);

/// The nodes of the cells that intersect `bounds` (world coordinates in VTK's order), with `reach`
/// more nodes on each side, kept within `whole`. The bounds are transformed by the image's
/// physical-to-index transform.
VTKISTHMUSFILTERSCORE_EXPORT Extent CoverBounds(vtkImageData* image, const double bounds[6],
  const std::array<int, 3>& reach, const Extent& whole);

/**
 * Crops `image` to `extent`: nodes, cells and all arrays as by vtkImageData::Crop; empty if
 * `extent` contains none of it. Linear in the number of remaining values.
 */
VTKISTHMUSFILTERSCORE_EXPORT void CropTo(vtkImageData* image, const Extent& extent);

}

#endif
