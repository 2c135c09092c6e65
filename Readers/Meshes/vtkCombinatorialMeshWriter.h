/**
 * @class vtkCombinatorialMeshWriter
 * @brief Writes the volume cells of a vtkUnstructuredGrid as a combinatorial mesh (.cmesh).
 *
 * The format is described at vtkCombinatorialMeshReader, which returns the same points, cells
 * and numbers bit for bit, with three exceptions: vtkIdType arrays are read as 64-bit integers and
 * char as signed char; VTK_POLYHEDRON faces are oriented to agree with the first face of the cell;
 * cells of higher order are reduced to their corners, and points, lines and surface cells are
 * dropped, with a warning. Arrays that do not contain numbers, or too few of them, are also dropped
 * with a warning.
 *
 * If the file cannot be written completely, there is an error and the error code is set.
 */
#ifndef vtkCombinatorialMeshWriter_h
#define vtkCombinatorialMeshWriter_h

#include "vtkGuardedFileWriter.h"
#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

class vtkUnstructuredGrid;

class VTKISTHMUSREADERSMESHES_EXPORT vtkCombinatorialMeshWriter : public vtkGuardedFileWriter
{
public:
  static vtkCombinatorialMeshWriter* New();
  vtkTypeMacro(vtkCombinatorialMeshWriter, vtkGuardedFileWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Write numbers as little-endian bytes (default) or as text.
  vtkSetMacro(Binary, bool);
  vtkGetMacro(Binary, bool);
  vtkBooleanMacro(Binary, bool);
  ///@}

protected:
  vtkCombinatorialMeshWriter() = default;
  ~vtkCombinatorialMeshWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteFile() override;

  bool Binary = true;

private:
  vtkCombinatorialMeshWriter(const vtkCombinatorialMeshWriter&) = delete;
  void operator=(const vtkCombinatorialMeshWriter&) = delete;
};

#endif
