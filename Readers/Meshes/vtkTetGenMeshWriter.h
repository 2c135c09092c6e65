/**
 * @class vtkTetGenMeshWriter
 * @brief Writes meshes as TetGen reads and writes them: .node, .ele, .face.
 *
 * FileName may end in any of the three: NAME.node gets the points, NAME.ele the tetrahedra,
 * NAME.face the triangles, if there are any; an old NAME.ele or NAME.face of TetGen's that is not
 * written is removed, since its cells would be read with the new points. Attribute of points and
 * tetrahedra and BoundaryMarker of points and triangles are written, too, whatever their types, if
 * doubles hold all values of Attribute, and whole numbers of 64 bits those of BoundaryMarker.
 * Otherwise, they are dropped with the reason in the warning, which lists all other arrays as well.
 * For other cells, for a FileName in .ele or .face without such cells, or if a file cannot be
 * written completely, there is an error and the error code is set. Time: O(bytes); memory: that of
 * the mesh.
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
  std::vector<isthmus::MeshArrayRule> Arrays() const override;

private:
  vtkTetGenMeshWriter(const vtkTetGenMeshWriter&) = delete;
  void operator=(const vtkTetGenMeshWriter&) = delete;
};

#endif
