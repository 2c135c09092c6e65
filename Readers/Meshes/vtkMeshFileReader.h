/**
 * @class vtkMeshFileReader
 * @brief Base class of readers of mesh files: a file name, and points, cells and arrays as a grid.
 */
#ifndef vtkMeshFileReader_h
#define vtkMeshFileReader_h

#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include <vtkUnstructuredGridAlgorithm.h>

namespace isthmus
{
struct CellMesh;
}

class VTKISTHMUSREADERSMESHES_EXPORT vtkMeshFileReader : public vtkUnstructuredGridAlgorithm
{
public:
  vtkAbstractTypeMacro(vtkMeshFileReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkMeshFileReader();
  ~vtkMeshFileReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  /// Reads `mesh` from FileName, which must be set; throws if that fails.
  virtual void ReadMesh(isthmus::CellMesh& mesh) = 0;

  char* FileName = nullptr;

private:
  vtkMeshFileReader(const vtkMeshFileReader&) = delete;
  void operator=(const vtkMeshFileReader&) = delete;
};

#endif
