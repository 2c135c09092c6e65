/**
 * @class vtkMeshFileWriter
 * @brief Common base of writers of mesh files: a file's name, points, cells and arrays from any
 * point set.
 */
#ifndef vtkMeshFileWriter_h
#define vtkMeshFileWriter_h

#include "vtkGuardedFileWriter.h"
#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include <vector> // for rules

namespace isthmus
{
struct CellMesh;
struct MeshArrayRule;
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

  /// The arrays that the format stores. All others are dropped, with a warning.
  virtual std::vector<isthmus::MeshArrayRule> Arrays() const = 0;

private:
  vtkMeshFileWriter(const vtkMeshFileWriter&) = delete;
  void operator=(const vtkMeshFileWriter&) = delete;
};

#endif
