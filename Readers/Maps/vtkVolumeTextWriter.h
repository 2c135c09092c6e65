/**
 * @class vtkVolumeTextWriter
 * @brief Writes the values of an image as plain text (.dat): three counts, then numbers, x fastest.
 *
 * The thesis' export of voxel values (X. Feng, PhD thesis, chapter 5): a line "nx ny nz", then a
 * line of nx values for each row along x. Numbers have the fewest digits that are read back bit
 * for bit. Origin and spacing are not part of the format, a warning is issued where they are not 0
 * and 1.
 *
 * No nodes, no such array, an array of several components, a file that can't be written to its end:
 * one error through vtkErrorMacro, the error code set, and no file. About 0.1 us a number;
 * memory 1 MiB.
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
