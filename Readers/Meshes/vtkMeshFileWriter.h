/**
 * @class vtkMeshFileWriter
 * @brief What writers of mesh files share: a file's name, points, cells and arrays from any point
 * set.
 */
#ifndef vtkMeshFileWriter_h
#define vtkMeshFileWriter_h

#include "vtkIsthmusModule.h" // for the export macro

#include <vtkWriter.h>

namespace isthmus
{
struct CellMesh;
}

class VTKISTHMUS_EXPORT vtkMeshFileWriter : public vtkWriter
{
public:
  vtkAbstractTypeMacro(vtkMeshFileWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to write. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkMeshFileWriter() = default;
  ~vtkMeshFileWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteData() override;
  /// What VTK 9.7 calls in its place.
  virtual bool WriteDataAndReturn()
  {
    this->WriteData();
    return this->GetErrorCode() == 0;
  }

  /// Writes `mesh` to FileName, which is set, or throws with a sentence.
  virtual void WriteMesh(const isthmus::CellMesh& mesh) = 0;

  /// Names of the arrays that the format holds, separated by blanks.
  virtual const char* ArrayNames() const = 0;

  char* FileName = nullptr;

private:
  vtkMeshFileWriter(const vtkMeshFileWriter&) = delete;
  void operator=(const vtkMeshFileWriter&) = delete;
};

#endif
