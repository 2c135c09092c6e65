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

/// First and last node on x, y and z; empty where a last is below its first.
using Extent = std::array<int, 6>;

/// The extent that `info` holds under `key`, empty where there is none.
VTKISTHMUSFILTERSCORE_EXPORT Extent ExtentOf(
  vtkInformation* info, vtkInformationIntegerVectorKey* key);

/// What a source that splits `all` makes for the piece that `request` asks for, ghost layers
/// included.
VTKISTHMUSFILTERSCORE_EXPORT Extent PieceOf(vtkInformation* request, const Extent& all);

/// Makes a request for an image one for all of it, on each rank.
VTKISTHMUSFILTERSCORE_EXPORT void RequestAll(vtkInformation* request);

/// Asks the image of `input` for its whole extent, whatever part is wanted of the result.
VTKISTHMUSFILTERSCORE_EXPORT void RequestWholeExtent(vtkInformation* input);

/// Tells the pipeline the whole extent, origin and spacing of the image that `output` will be.
VTKISTHMUSFILTERSCORE_EXPORT void SetImageInformation(vtkInformation* output, vtkImageData* image);

/// The same for an image whose geometry `make` sets. Nothing is said where that throws, but an
/// empty extent told: the execution meets it again, and empties its outputs along with the
/// sentence.
VTKISTHMUSFILTERSCORE_EXPORT void SetImageInformation(
  vtkInformation* output, const std::function<void(vtkImageData*)>& make);

/// Whether `output` is asked for as the first piece, or whole: where what cannot be split is made.
VTKISTHMUSFILTERSCORE_EXPORT bool IsFirstPiece(vtkInformation* output);

/// @throws std::runtime_error where the image that `info` holds is not all that there is: a source
/// that splits it whatever is asked for.
VTKISTHMUSFILTERSCORE_EXPORT void RequireWholeExtent(vtkInformation* info);

/// Whether this rank makes the result of the image in `info`. Of one that every rank has whole, the
/// first does; blocks of composite data, which have no whole extent of their own, are made where
/// they are.
VTKISTHMUSFILTERSCORE_EXPORT bool IsMadeHere(vtkInformation* info);

VTKISTHMUSFILTERSCORE_EXPORT bool IsEmpty(const Extent& extent);

/// `extent` with `reach` more nodes to each side, kept within `whole`. An empty one stays as it is.
VTKISTHMUSFILTERSCORE_EXPORT Extent Grown(
  const Extent& extent, const std::array<int, 3>& reach, const Extent& whole);

/// Nodes of an extent, 0 if it is empty.
VTKISTHMUSFILTERSCORE_EXPORT std::int64_t NodeCount(const Extent& extent);

/// The nodes that are in both.
VTKISTHMUSFILTERSCORE_EXPORT Extent Intersection(const Extent& a, const Extent& b);

/// Whether no node of `inner` lies outside `outer`.
VTKISTHMUSFILTERSCORE_EXPORT bool Contains(const Extent& outer, const Extent& inner);

/// How many layers of nodes around `inner` it takes to cover `outer`.
VTKISTHMUSFILTERSCORE_EXPORT int LayersBetween(const Extent& inner, const Extent& outer);

/// The nodes of the cells that `bounds` (world, vtk's order) meets, with `reach` more to each side,
/// kept within `whole`. The bounds are taken through the image's physical-to-index transform.
VTKISTHMUSFILTERSCORE_EXPORT Extent Covering(vtkImageData* image, const double bounds[6],
  const std::array<int, 3>& reach, const Extent& whole);

/**
 * Makes `image` its own part in `extent`: nodes, cells and all arrays as vtkImageData::Crop leaves
 * them, and none where `extent` has none of it. Linear in the values kept; VTK's goes value by
 * value, which took ten times the curvature of a volume in two pieces.
 */
VTKISTHMUSFILTERSCORE_EXPORT void CropTo(vtkImageData* image, const Extent& extent);

}

#endif
