/**
 * @class vtkOFFSurfaceWriter
 * @brief Writes surfaces in Geomview's Object File Format (.off), the thesis' triangle-mesh file.
 *
 * Writes points, lines and polygons; with a point array Normals of three finite components, it is
 * an NOFF file. vtkOFFSurfaceReader reads the same coordinates from it, bit for bit. Other arrays
 * are dropped, with a warning that lists them. For strips, or if the file cannot be written
 * completely, there is an error, the error code is set, and no file is left. Time: O(bytes);
 * memory: that of the surface.
 */
#ifndef vtkOFFSurfaceWriter_h
#define vtkOFFSurfaceWriter_h

#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include "vtkMeshFileWriter.h"

class VTKISTHMUSREADERSMESHES_EXPORT vtkOFFSurfaceWriter : public vtkMeshFileWriter
{
public:
  static vtkOFFSurfaceWriter* New();
  vtkTypeMacro(vtkOFFSurfaceWriter, vtkMeshFileWriter);

protected:
  vtkOFFSurfaceWriter() = default;
  ~vtkOFFSurfaceWriter() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  void WriteMesh(const isthmus::CellMesh& mesh) override;
  std::vector<isthmus::MeshArrayRule> Arrays() const override;

private:
  vtkOFFSurfaceWriter(const vtkOFFSurfaceWriter&) = delete;
  void operator=(const vtkOFFSurfaceWriter&) = delete;
};

#endif
