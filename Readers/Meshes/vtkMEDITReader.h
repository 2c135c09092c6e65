/**
 * @class vtkMEDITReader
 * @brief Reads meshes in MEDIT's text format (.mesh), as Gmsh, Mmg, CGAL and fTetWild write them.
 *
 * Output: vtkUnstructuredGrid of edges, triangles, quadrilaterals, tetrahedra, pyramids, prisms and
 * hexahedra, linear or quadratic, in the order of the file, with the arrays of OutputArrayTable().
 * Cells of a higher order are dropped, which Notes in the field data and a warning
 * report, as they do a file without End, which may be truncated. The sections are described in
 * MEDITFile.h. If a file is missing, truncated, invalid, or a
 * .mesh file of another program, there is one error with the line, the error code is set, and the
 * output is empty. Time and memory: O(bytes).
 */
#ifndef vtkMEDITReader_h
#define vtkMEDITReader_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include "vtkMeshFileReader.h"

class VTKISTHMUSREADERSMESHES_EXPORT vtkMEDITReader : public vtkMeshFileReader
{
public:
  static vtkMEDITReader* New();
  vtkTypeMacro(vtkMEDITReader, vtkMeshFileReader);

  /// 1 if the file begins like a MEDIT mesh.
  static int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkMEDITReader() = default;
  ~vtkMEDITReader() override = default;

  void ReadMesh(isthmus::CellMesh& mesh) override;

private:
  vtkMEDITReader(const vtkMEDITReader&) = delete;
  void operator=(const vtkMEDITReader&) = delete;
};

#endif
