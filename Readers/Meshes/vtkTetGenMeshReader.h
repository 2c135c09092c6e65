/**
 * @class vtkTetGenMeshReader
 * @brief Reads meshes as TetGen writes them: .node, .ele, .face.
 *
 * FileName is any of the three; the points come from NAME.node beside it. Output:
 * vtkUnstructuredGrid of tetrahedra (.ele) and triangles (.face), quadratic ones with -o2, or only
 * points (.node), with the arrays of OutputArrayTable() that the file has. The rows are
 * described in TetGenMeshFile.h. If no line end follows the last number of a file, digits of it may
 * be missing: such a file cannot be distinguished from a whole one. If a file is missing, truncated
 * or invalid, there is one error with the line, the error code is set, and the output is empty.
 * Time and memory: O(bytes).
 */
#ifndef vtkTetGenMeshReader_h
#define vtkTetGenMeshReader_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include "vtkMeshFileReader.h"

class VTKISTHMUSREADERSMESHES_EXPORT vtkTetGenMeshReader : public vtkMeshFileReader
{
public:
  static vtkTetGenMeshReader* New();
  vtkTypeMacro(vtkTetGenMeshReader, vtkMeshFileReader);

  /// 1 if the file has the name and the beginning of one of these.
  static int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkTetGenMeshReader() = default;
  ~vtkTetGenMeshReader() override = default;

  void ReadMesh(isthmus::CellMesh& mesh) override;

private:
  vtkTetGenMeshReader(const vtkTetGenMeshReader&) = delete;
  void operator=(const vtkTetGenMeshReader&) = delete;
};

#endif
