/**
 * @file GridInformation.h
 * @brief Pipeline information of a grid file, set before the data are read and checked afterwards.
 */
#ifndef isthmus_GridInformation_h
#define isthmus_GridInformation_h

#include "vtkIsthmusReadersFilesModule.h" // for the export macro

#include <array>
#include <cstdint>

class vtkImageData;
class vtkInformation;

namespace isthmus
{

/// Nodes along x, y, z; angstrom between them; where the first one lies; the direction matrix, by
/// rows. No nodes: a file that can't be read.
struct GridInformation
{
  std::array<std::int64_t, 3> Dimensions{};
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Origin{};
  std::array<double, 9> Direction{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
};

/// Puts the grid into the information of an output.
VTKISTHMUSREADERSFILES_EXPORT void Describe(const GridInformation& grid, vtkInformation* info);

/// A file that was replaced since its information was read would be shown in the old geometry.
/// @throws ReaderError (BadRequest) where `info` describes another grid
VTKISTHMUSREADERSFILES_EXPORT void RequireUnchanged(
  const GridInformation& grid, vtkInformation* info, const char* path);

/// Gives the image the update extent, and the grid's geometry.
VTKISTHMUSREADERSFILES_EXPORT void StartImage(vtkInformation* info, vtkImageData* image);

}

#endif
