/**
 * @class vtkGuardedFileWriter
 * @brief Base class of our writers: file name, and one error message if a file cannot be written.
 *
 * A missing file name, input without points (a filter before has failed), or any failure to write
 * the whole file, is reported as one error with the error code set; an abort is not an error. In
 * all cases an existing file of this name is not changed.
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

  /// Returns 1 if the file was written completely, and 0 after an error or an abort, which leave an
  /// existing file of this name unchanged.
  int Write() override;

protected:
  vtkGuardedFileWriter() = default;
  ~vtkGuardedFileWriter() override;

  void WriteData() override;
  /// The function that VTK 9.7 calls instead.
  virtual bool WriteDataAndReturn()
  {
    this->WriteData();
    return this->GetErrorCode() == 0;
  }

  /// Writes the input to FileName, which must be set; throws if that fails.
  virtual void WriteFile() = 0;

  char* FileName = nullptr;

private:
  bool IsWritten = false;

  vtkGuardedFileWriter(const vtkGuardedFileWriter&) = delete;
  void operator=(const vtkGuardedFileWriter&) = delete;
};

#endif
