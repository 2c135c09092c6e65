/**
 * @class vtkMeshFileWriter
 * @brief What writers of mesh files share: a file's name, points, cells and arrays from any point
 * set.
 */
#ifndef vtkMeshFileWriter_h
#define vtkMeshFileWriter_h

#include "vtkGuardedFileWriter.h"
#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

namespace isthmus
{
struct CellMesh;
}

class VTKISTHMUSREADERSMESHES_EXPORT vtkMeshFileWriter : public vtkGuardedFileWriter
{
public:
  vtkAbstractTypeMacro(vtkMeshFileWriter, vtkGuardedFileWriter);

protected:
  vtkMeshFileWriter() = default;
  ~vtkMeshFileWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFile() override;

  /// Writes `mesh` to FileName, which must be set; throws if that fails.
  virtual void WriteMesh(const isthmus::CellMesh& mesh) = 0;

  /// Names of the arrays that the format can store, separated by blanks.
  virtual const char* ArrayNames() const = 0;

private:
  vtkMeshFileWriter(const vtkMeshFileWriter&) = delete;
  void operator=(const vtkMeshFileWriter&) = delete;
};

#endif
