/**
 * @class vtkVolumeTextReader
 * @brief Reads voxel values as plain text (.dat): three counts, then numbers, x fastest.
 *
 * The thesis' export of voxel values (X. Feng, PhD thesis, chapter 5), as vtkVolumeTextWriter
 * writes it, plain, .gz or .bz2. Output: vtkImageData with the point array `Density` in double
 * precision, origin 0 and spacing 1, since the file has neither. Written and read again, doubles
 * are equal bit for bit; floats are once they are rounded to float again.
 *
 * A file that is missing, cut, too long or wrong: one error with the line, the error code, an
 * empty output. Time and memory: O(numbers).
 */
#ifndef vtkVolumeTextReader_h
#define vtkVolumeTextReader_h

#include "vtkIsthmusReadersMapsModule.h" // for the export macro

#include <vtkImageAlgorithm.h>

class VTKISTHMUSREADERSMAPS_EXPORT vtkVolumeTextReader : public vtkImageAlgorithm
{
public:
  static vtkVolumeTextReader* New();
  vtkTypeMacro(vtkVolumeTextReader, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// 1 when the file begins with a line of three counts.
  static int CanReadFile(const char* fileName);

protected:
  vtkVolumeTextReader();
  ~vtkVolumeTextReader() override;

  int RequestInformation(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkVolumeTextReader(const vtkVolumeTextReader&) = delete;
  void operator=(const vtkVolumeTextReader&) = delete;

  char* FileName = nullptr;
};

#endif
