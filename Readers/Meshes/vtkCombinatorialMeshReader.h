/**
 * @class vtkCombinatorialMeshReader
 * @brief Reads volume meshes of any cell types: types by their faces, then vertex lists (.cmesh).
 *
 * The format is that of X. Feng's thesis (3.3.1.1, Table 3.3) with coordinates and attributes:
 *
 *     file       = "isthmus-combinatorial-mesh" "1" coding types vertices blocks attributes "end"
 *     coding     = "text" | "binary"
 *     types      = "types" COUNT type*
 *     type       = "type" VERTICES FACES NAME <end of line> face*
 *     face       = SIZE VERTEX*          local vertices from 0, counter-clockwise from outside
 *     vertices   = "vertices" COUNT real values               x y z of each vertex
 *     blocks     = "blocks" COUNT block*
 *     block      = "block" TYPE CELLS values                  int64: the vertices of each cell
 *     attributes = "attributes" COUNT attribute*
 *     attribute  = "attribute" place number COMPONENTS NAME <end of line> values
 *     place      = "vertices" | "cells"
 *     real       = "float32" | "float64"
 *     number     = real | "int8" | "uint8" | ... | "int64" | "uint64"
 *
 * Words are separated by blanks and line breaks. Types and vertices are numbered from 0, cells in
 * the order of their blocks. In a text file values are numbers. In a binary file there is a line
 * break, then their little-endian bytes, then a line break. Names extend to the end of their line.
 *
 * Output: vtkUnstructuredGrid. Types with the faces of a linear VTK cell become that cell, and the
 * prism of the thesis becomes VTK_WEDGE. All others, and types whose name begins with "polyhedron",
 * become VTK_POLYHEDRON. Attributes become point and cell data.
 *
 * If a file is missing, truncated or invalid, there is an error with the line and the expected
 * contents, the error code is set, and the output is empty. Memory: a small multiple of the file
 * size.
 */
#ifndef vtkCombinatorialMeshReader_h
#define vtkCombinatorialMeshReader_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusReadersMeshesModule.h" // for the export macro

#include <vtkUnstructuredGridAlgorithm.h>

class VTKISTHMUSREADERSMESHES_EXPORT vtkCombinatorialMeshReader
  : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkCombinatorialMeshReader* New();
  vtkTypeMacro(vtkCombinatorialMeshReader, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// The file to read. Default: none.
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /// 1 if the file begins like a combinatorial mesh.
  int CanReadFile(const char* fileName);

  /// The arrays that the reader adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkCombinatorialMeshReader();
  ~vtkCombinatorialMeshReader() override;

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  char* FileName = nullptr;

private:
  vtkCombinatorialMeshReader(const vtkCombinatorialMeshReader&) = delete;
  void operator=(const vtkCombinatorialMeshReader&) = delete;
};

#endif
