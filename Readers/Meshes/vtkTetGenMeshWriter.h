/**
 * @class vtkTetGenMeshWriter
 * @brief Writes meshes as TetGen reads and writes them: .node, .ele, .face.
 *
 * FileName may end in any of the three: NAME.node gets the points, NAME.ele the tetrahedra,
 * NAME.face the triangles, where there are any. Arrays `Attribute` (double) and `BoundaryMarker`
 * (whole numbers) go with them, others are dropped, with a warning. Other cells, a FileName in .ele
 * or .face where there are no cells for it, and a file that can't be written to its end, are an
 * error with the error code set. Time: O(bytes); memory: that of the mesh.
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
