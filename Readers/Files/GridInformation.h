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

/// Numbers of nodes along x, y, z; the spacing in angstrom; the position of the first node; the
/// direction matrix, by rows. There are no nodes if the file cannot be read.
struct GridInformation
{
  std::array<std::int64_t, 3> Dimensions{};
  std::array<double, 3> Spacing{ 1.0, 1.0, 1.0 };
  std::array<double, 3> Origin{};
  std::array<double, 9> Direction{ 1, 0, 0, 0, 1, 0, 0, 0, 1 };
};

/// Stores the grid in the pipeline information of an output.
VTKISTHMUSREADERSFILES_EXPORT void Describe(const GridInformation& grid, vtkInformation* info);

/// A file that was replaced since its information was read would be shown in the old geometry.
/// @throws ReaderError (BadRequest) where `info` describes another grid
VTKISTHMUSREADERSFILES_EXPORT void RequireUnchanged(
  const GridInformation& grid, vtkInformation* info, const char* path);

/// Sets the extent of the image to the update extent, and its geometry to that of the grid.
VTKISTHMUSREADERSFILES_EXPORT void StartImage(vtkInformation* info, vtkImageData* image);

}

#endif
