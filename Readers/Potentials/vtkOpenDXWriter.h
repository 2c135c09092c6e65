/**
 * @class   vtkOpenDXWriter
 * @brief   writes a point array of a vtkImageData as an OpenDX file, the form APBS and VMD use
 *
 * Plain text, three values a line, z fastest, with origin and deltas in world coordinates (the
 * image's direction matrix included); gzip-compressed where the name ends in .gz. float arrays are
 * written as type float, all others as double. Every number has the fewest digits from which the
 * same bits come back: vtkOpenDXReader gives the same values and, to the last bit, grid (64-bit
 * integers beyond 2^53 aside). The image's field data `Comments` and `FieldName` are kept.
 *
 * An image without such an array, an empty one, and a file that can't be written to its end are
 * errors with the error code set; no part of a file is left behind.
 */
#ifndef vtkOpenDXWriter_h
#define vtkOpenDXWriter_h

#include "vtkIsthmusModule.h" // for the export macro

#include <vtkWriter.h>

#include <string> // for the name of the array

class VTKISTHMUS_EXPORT vtkOpenDXWriter : public vtkWriter
{
public:
  static vtkOpenDXWriter* New();
  vtkTypeMacro(vtkOpenDXWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /// Point array to write. Default: empty, which is `Potential` if there is one, else the active
  /// scalars, else the first point array.
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

protected:
  vtkOpenDXWriter() = default;
  ~vtkOpenDXWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;
  /// What VTK 9.7 calls in its place.
  virtual bool WriteDataAndReturn()
  {
    this->WriteData();
    return this->GetErrorCode() == 0;
  }

  char* FileName = nullptr;
  std::string ArrayName;

private:
  vtkOpenDXWriter(const vtkOpenDXWriter&) = delete;
  void operator=(const vtkOpenDXWriter&) = delete;
};

#endif
