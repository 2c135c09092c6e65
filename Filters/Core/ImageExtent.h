/**
 * @file ImageExtent.h
 * @brief Boxes of image nodes in VTK's extent form: from requests, growing, clipping,
 * counting, and covering points.
 */
#ifndef isthmus_ImageExtent_h
#define isthmus_ImageExtent_h

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
Extent ExtentOf(vtkInformation* info, vtkInformationIntegerVectorKey* key);

/// What a source that splits `all` makes for the piece that `request` asks for, ghost layers
/// included.
Extent PieceOf(vtkInformation* request, const Extent& all);

/// Makes a request for an image one for all of it, on each rank.
void AskForAll(vtkInformation* request);

/// Asks the image of `input` for its whole extent, whatever part is wanted of the result.
void AskForWholeImage(vtkInformation* input);

/// Tells the pipeline the whole extent, origin and spacing of the image that `output` will be.
void TellGeometry(vtkInformation* output, vtkImageData* image);

/// The same for an image whose geometry `make` sets. Nothing is said where that throws, but an
/// empty extent told: the execution meets it again, and empties its outputs along with the
/// sentence.
void TellGeometry(vtkInformation* output, const std::function<void(vtkImageData*)>& make);

/// Whether `output` is asked for as the first piece, or whole: where what cannot be split is made.
bool IsFirstPiece(vtkInformation* output);

/// @throws std::runtime_error where the image that `info` holds is not all that there is: a source
/// that splits it whatever is asked for.
void DemandAll(vtkInformation* info);

/// Whether this rank makes the result of the image in `info`. Of one that every rank has whole, the
/// first does; blocks of composite data, which have no whole extent of their own, are made where
/// they are.
bool IsMadeHere(vtkInformation* info);

bool IsEmpty(const Extent& extent);

/// `extent` with `reach` more nodes to each side, kept within `whole`. An empty one stays as it is.
Extent Grown(const Extent& extent, const std::array<int, 3>& reach, const Extent& whole);

/// Nodes of an extent, 0 if it is empty.
std::int64_t NodeCount(const Extent& extent);

/// The nodes that are in both.
Extent Intersection(const Extent& a, const Extent& b);

/// Whether no node of `inner` lies outside `outer`.
bool Contains(const Extent& outer, const Extent& inner);

/// How many layers of nodes around `inner` it takes to cover `outer`.
int LayersBetween(const Extent& inner, const Extent& outer);

/// The nodes of the cells that `bounds` (world, vtk's order) meets, with `reach` more to each side,
/// kept within `whole`. The bounds are taken through the image's physical-to-index transform.
Extent Covering(vtkImageData* image, const double bounds[6], const std::array<int, 3>& reach,
  const Extent& whole);

}

#endif
