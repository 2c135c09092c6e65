/**
 * @class vtkVolumeTextWriter
 * @brief Writes the values of an image as plain text (.dat): three counts, then numbers, with x
 * varying fastest.
 *
 * The format in which the thesis exports voxel values (X. Feng, PhD thesis, chapter 5): a line "nx
 * ny nz", then a line of nx values for each row along x. Numbers are written with the fewest digits
 * that are read back bit for bit. Origin and spacing are not part of the format; a warning is
 * issued if they are not 0 and 1.
 *
 * If there are no nodes or no such array, the array has several components or too few values, or
 * the file cannot be written completely, there is one error through vtkErrorMacro, the error code
 * is set, and no file is left. Time: O(numbers); memory: 1 MiB.
 */
#ifndef vtkVolumeTextWriter_h
#define vtkVolumeTextWriter_h

#include "vtkImageArrayWriter.h"
#include "vtkIsthmusReadersMapsModule.h" // for the export macro

class VTKISTHMUSREADERSMAPS_EXPORT vtkVolumeTextWriter : public vtkImageArrayWriter
{
public:
  static vtkVolumeTextWriter* New();
  vtkTypeMacro(vtkVolumeTextWriter, vtkImageArrayWriter);

protected:
  vtkVolumeTextWriter() = default;
  ~vtkVolumeTextWriter() override = default;

  void WriteFile() override;

private:
  vtkVolumeTextWriter(const vtkVolumeTextWriter&) = delete;
  void operator=(const vtkVolumeTextWriter&) = delete;
};

#endif
