/**
 * @class vtkOFFSurfaceReader
 * @brief Reads surfaces in Geomview's Object File Format (.off, and with colours or normals).
 *
 * Output: vtkPolyData with points in double precision and the arrays of OutputArrayTable(); normals
 * are active. The grammar is in OFFFile.h. If no
 * line end follows the last number of a file, digits of it may be missing: such a file cannot be
 * distinguished from a whole one. If a file is missing, truncated or invalid, there is one error
 * with the line, the error code is set, and the output is empty. Time and memory: O(bytes).
 */
#ifndef vtkOFFSurfaceReader_h
#define vtkOFFSurfaceReader_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class VTKISTHMUSREADERSMESHES_EXPORT vtkOFFSurfaceReader : public vtkPolyDataAlgorithm
{
public:
  static vtkOFFSurfaceReader* New();
  vtkTypeMacro(vtkOFFSurfaceReader, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// 1 if the file begins like an OFF file.
  static int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkOFFSurfaceReader();
  ~vtkOFFSurfaceReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkOFFSurfaceReader(const vtkOFFSurfaceReader&) = delete;
  void operator=(const vtkOFFSurfaceReader&) = delete;

  char* FileName = nullptr;
};

#endif
