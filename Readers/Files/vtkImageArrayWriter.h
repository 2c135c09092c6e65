/**
 * @class vtkImageArrayWriter
 * @brief Common base of writers of one point array of a vtkImageData: names of file and array.
 */
#ifndef vtkImageArrayWriter_h
#define vtkImageArrayWriter_h

#include "vtkGuardedFileWriter.h"
#include "vtkIsthmusReadersFilesModule.h" // for the export macro

#include <string> // for the array's name

class vtkImageData;

class VTKISTHMUSREADERSFILES_EXPORT vtkImageArrayWriter : public vtkGuardedFileWriter
{
public:
  vtkAbstractTypeMacro(vtkImageArrayWriter, vtkGuardedFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Point array to write. Default empty: the usual array of the format if there is one (named in
  /// the description of the writer), otherwise the active scalars, otherwise the first point array.
  vtkSetMacro(ArrayName, std::string);
  vtkGetMacro(ArrayName, std::string);
  ///@}

protected:
  vtkImageArrayWriter() = default;
  ~vtkImageArrayWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkImageData* GetImage();

  std::string ArrayName;

private:
  vtkImageArrayWriter(const vtkImageArrayWriter&) = delete;
  void operator=(const vtkImageArrayWriter&) = delete;
};

#endif
