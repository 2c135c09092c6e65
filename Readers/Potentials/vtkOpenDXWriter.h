/**
 * @class   vtkOpenDXWriter
 * @brief   writes a point array of a vtkImageData as an OpenDX file, the form APBS and VMD use
 *
 * Plain text, three values a line, z fastest, with origin and deltas in world coordinates (the
 * image's direction matrix included); gzip-compressed where the name ends in .gz. float arrays are
 * written as type float, all others as double. Without an ArrayName the array is `Potential` if
 * there is one. Every number has the fewest digits that are read back bit for bit:
 * vtkOpenDXReader gives the same values and, to the last bit, grid (64-bit integers beyond 2^53
 * aside). The image's field data `Comments` and `FieldName` are kept.
 *
 * An image without such an array, an empty one, and a file that can't be written to its end are
 * errors with the error code set; no part of a file is left behind.
 */
#ifndef vtkOpenDXWriter_h
#define vtkOpenDXWriter_h

#include "vtkImageArrayWriter.h"
#include "vtkIsthmusReadersPotentialsModule.h" // for the export macro

class VTKISTHMUSREADERSPOTENTIALS_EXPORT vtkOpenDXWriter : public vtkImageArrayWriter
{
public:
  static vtkOpenDXWriter* New();
  vtkTypeMacro(vtkOpenDXWriter, vtkImageArrayWriter);

protected:
  vtkOpenDXWriter() = default;
  ~vtkOpenDXWriter() override = default;

  void WriteFile() override;

private:
  vtkOpenDXWriter(const vtkOpenDXWriter&) = delete;
  void operator=(const vtkOpenDXWriter&) = delete;
};

#endif
