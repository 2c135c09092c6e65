/**
 * @class vtkMEDITReader
 * @brief Reads meshes in MEDIT's text format (.mesh), as Gmsh, Mmg, CGAL and fTetWild write them.
 *
 * Output: vtkUnstructuredGrid of edges, triangles, quadrilaterals, tetrahedra, pyramids, prisms and
 * hexahedra, linear or quadratic, in the order of the file, with the array `Reference` on points
 * and cells. Cells of a higher order are dropped: `Notes` in the field data, and a warning. The
 * sections are described in MEDITFile.h. A file that is missing, cut or wrong, and .mesh files of
 * other programs: one error with the line, the error code, an empty output. Time and memory:
 * O(bytes).
 */
#ifndef vtkMEDITReader_h
#define vtkMEDITReader_h

#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include "vtkMeshFileReader.h"

class VTKISTHMUSREADERSMESHES_EXPORT vtkMEDITReader : public vtkMeshFileReader
{
public:
  static vtkMEDITReader* New();
  vtkTypeMacro(vtkMEDITReader, vtkMeshFileReader);

  /// 1 when the file begins as MEDIT meshes do.
  static int CanReadFile(const char* fileName);

protected:
  vtkMEDITReader() = default;
  ~vtkMEDITReader() override = default;

  void ReadMesh(isthmus::CellMesh& mesh) override;

private:
  vtkMEDITReader(const vtkMEDITReader&) = delete;
  void operator=(const vtkMEDITReader&) = delete;
};

#endif
