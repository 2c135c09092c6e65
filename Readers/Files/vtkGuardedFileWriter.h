/**
 * @class vtkGuardedFileWriter
 * @brief Base class of our writers: file name, and one error message if a file cannot be written.
 *
 * A missing file name, and any failure to write the whole file, is one error with the error code
 * set; an abort is not an error. Both leave a file of this name as it was.
 */
#ifndef vtkGuardedFileWriter_h
#define vtkGuardedFileWriter_h

#include "vtkIsthmusReadersFilesModule.h" // for the export macro

#include <vtkWriter.h>

class VTKISTHMUSREADERSFILES_EXPORT vtkGuardedFileWriter : public vtkWriter
{
public:
  vtkAbstractTypeMacro(vtkGuardedFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// Returns 1 when the file is written to its end, 0 where there is an error or an abort; what was
  /// in a file of this name before is still there then.
  int Write() override;

protected:
  vtkGuardedFileWriter() = default;
  ~vtkGuardedFileWriter() override;

  void WriteData() override;
  /// What VTK 9.7 calls in its place.
  virtual bool WriteDataAndReturn()
  {
    this->WriteData();
    return this->GetErrorCode() == 0;
  }

  /// Writes the input to FileName, which is set, or throws.
  virtual void WriteFile() = 0;

  char* FileName = nullptr;

private:
  bool IsWritten = false;

  vtkGuardedFileWriter(const vtkGuardedFileWriter&) = delete;
  void operator=(const vtkGuardedFileWriter&) = delete;
};

#endif
