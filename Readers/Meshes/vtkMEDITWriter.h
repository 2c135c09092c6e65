/**
 * @class vtkMEDITWriter
 * @brief Writes meshes in MEDIT's text format (.mesh), which Gmsh, Mmg, CGAL and fTetWild read.
 *
 * Edges, triangles, quadrilaterals, tetrahedra, pyramids, prisms and hexahedra, by kind, with the
 * array Reference of points and cells, or 0 without it. Reference may have any type, if all values
 * are whole numbers of 64 bits; otherwise, it is dropped with the reason in the warning, which
 * lists all other arrays as well. For other cells, or if the file cannot be written completely,
 * there is an error, the error code is set, and no file is left. Time: O(bytes); memory: that of
 * the mesh.
 */
#ifndef vtkMEDITWriter_h
#define vtkMEDITWriter_h

#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include "vtkMeshFileWriter.h"

class VTKISTHMUSREADERSMESHES_EXPORT vtkMEDITWriter : public vtkMeshFileWriter
{
public:
  static vtkMEDITWriter* New();
  vtkTypeMacro(vtkMEDITWriter, vtkMeshFileWriter);

protected:
  vtkMEDITWriter() = default;
  ~vtkMEDITWriter() override = default;

  void WriteMesh(const isthmus::CellMesh& mesh) override;
  std::vector<isthmus::MeshArrayRule> Arrays() const override;

private:
  vtkMEDITWriter(const vtkMEDITWriter&) = delete;
  void operator=(const vtkMEDITWriter&) = delete;
};

#endif
