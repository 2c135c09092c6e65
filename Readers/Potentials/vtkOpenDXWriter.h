/**
 * @class   vtkOpenDXWriter
 * @brief   writes a point array of a vtkImageData as an OpenDX file, the form APBS and VMD use
 *
 * Writes plain text with three values on each line, z varying fastest, and origin and deltas in
 * world coordinates (including the direction matrix of the image); gzip-compressed if the name ends
 * in .gz. The type is double, since PyMOL and others refuse float. Without an ArrayName the
 * array is `Potential` if there is one. Every number is written with the fewest digits that are
 * read back bit for bit: vtkOpenDXReader reads bitwise the same values and grid (except for 64-bit
 * integers beyond 2^53). The image's field data `Comments` and `FieldName` are kept.
 *
 * If the image is empty or has no such array, the array has fewer tuples than there are nodes, or
 * the file cannot be written completely, there is an error and the error code is set; no partial
 * file is left.
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
