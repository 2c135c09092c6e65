/**
 * @class vtkMSMSReader
 * @brief Reads molecular surfaces of the program MSMS (pairs of .vert and .face files).
 *
 * FileName is either file of the pair. MSMS writes a surface with cavities as X, X_1, X_2, ...; all
 * of them are read unless AllComponents is off.
 *
 * Output: vtkPolyData of triangles in angstrom with the arrays of OutputArrayTable(); its normals
 * are active. Files need no comments and no counts (msms -no_header); without counts, a file that
 * was truncated between two lines is read as a shorter one. If no line end follows the last number
 * of a file, digits of it may be missing: such a file cannot be distinguished from a whole one. If
 * a file is missing, truncated or of another format, there is one error through vtkErrorMacro, the
 * error code is set, and the output is empty.
 */
#ifndef vtkMSMSReader_h
#define vtkMSMSReader_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusReadersMeshesModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSREADERSMESHES_EXPORT vtkMSMSReader : public vtkPolyDataAlgorithm
{
public:
  static vtkMSMSReader* New();
  vtkTypeMacro(vtkMSMSReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Path of the .vert or the .face file. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /// Read X_1, X_2, ... together with X, if they exist. Default on.
  vtkSetMacro(AllComponents, bool);
  vtkGetMacro(AllComponents, bool);
  vtkBooleanMacro(AllComponents, bool);
  ///@}

  /// 1 if the file has the name and the beginning of an MSMS file.
  static int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkMSMSReader();
  ~vtkMSMSReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMSMSReader(const vtkMSMSReader&) = delete;
  void operator=(const vtkMSMSReader&) = delete;

  char* FileName = nullptr;
  bool AllComponents = true;
};

#endif
