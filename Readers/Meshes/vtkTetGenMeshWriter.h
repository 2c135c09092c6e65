/**
 * @class vtkTetGenMeshWriter
 * @brief Writes meshes as TetGen reads and writes them: .node, .ele, .face.
 *
 * FileName may end in any of the three: NAME.node gets the points, NAME.ele the tetrahedra,
 * NAME.face the triangles, if there are any; an old NAME.ele or NAME.face of TetGen's that is not
 * written is removed, since its cells would be read with the new points. The arrays Attribute
 * (double) and BoundaryMarker (whole numbers) are written, too; others are dropped, with a warning. For other cells, for a
 * FileName in .ele or .face without such cells, or if a file cannot be written completely, there is
 * an error and the error code is set. Time: O(bytes); memory: that of the mesh.
 */
#ifndef vtkTetGenMeshWriter_h
#define vtkTetGenMeshWriter_h

#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include "vtkMeshFileWriter.h"

class VTKISTHMUSREADERSMESHES_EXPORT vtkTetGenMeshWriter : public vtkMeshFileWriter
{
public:
  static vtkTetGenMeshWriter* New();
  vtkTypeMacro(vtkTetGenMeshWriter, vtkMeshFileWriter);

protected:
  vtkTetGenMeshWriter() = default;
  ~vtkTetGenMeshWriter() override = default;

  void WriteMesh(const isthmus::CellMesh& mesh) override;
  const char* ArrayNames() const override;

private:
  vtkTetGenMeshWriter(const vtkTetGenMeshWriter&) = delete;
  void operator=(const vtkTetGenMeshWriter&) = delete;
};

#endif
