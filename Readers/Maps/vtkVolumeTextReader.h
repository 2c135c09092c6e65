/**
 * @class vtkVolumeTextReader
 * @brief Reads voxel values as plain text (.dat): three counts, then numbers, with x varying
 * fastest.
 *
 * The format in which the thesis exports voxel values (X. Feng, PhD thesis, chapter 5), written by
 * vtkVolumeTextWriter, plain, .gz or .bz2. Output: vtkImageData with the point array `Density` in
 * double precision, origin 0 and spacing 1, since the file has neither. Doubles that are written
 * and read again are bitwise equal; floats are, too, after rounding to float.
 *
 * If no line end follows the last number of a file, digits of it may be missing: such a file cannot
 * be distinguished from a whole one.
 *
 * If a file is missing, truncated, too long or invalid, there is one error with the line, the error
 * code is set, and the output is empty. Time and memory: O(numbers).
 */
#ifndef vtkVolumeTextReader_h
#define vtkVolumeTextReader_h

#include "Core/OutputArrays.h"
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

  /// 1 if the file begins with a line of three counts.
  static int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

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
