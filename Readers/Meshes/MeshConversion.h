/**
 * @file MeshConversion.h
 * @brief Converts meshes of files to VTK data, and back.
 */
#ifndef isthmus_MeshConversion_h
#define isthmus_MeshConversion_h

#include "Meshes/CellMesh.h"

#include <vtkSmartPointer.h>

#include <string>
#include <vector>

class vtkDataArray;
class vtkDataSet;
class vtkPointSet;
class vtkPolyData;
class vtkUnstructuredGrid;

namespace isthmus
{

/// The numbers as an array of the same type, without a name.
vtkSmartPointer<vtkDataArray> ToDataArray(const NumberList& numbers, std::int64_t components);

/// Adds each attribute to `data` as a point or cell array.
void AddAttributes(const std::vector<MeshAttribute>& attributes, vtkDataSet* data);

/// Adds the sentences as the field data array Notes, unless there are none.
void AddNotes(const std::vector<std::string>& notes, vtkDataSet* data);

/// Points (double), cells and arrays. `Normals` become the active normals.
void ToGrid(const CellMesh& mesh, vtkUnstructuredGrid* grid);

/// The same for cells up to polygons, in VTK's order: vertices, lines, polygons.
/// @pre no attribute is on cells, which this order would mix up.
void ToSurface(const CellMesh& mesh, vtkPolyData* surface);

/// @throws std::invalid_argument with the first point that has a coordinate that is not finite.
void RequireFinitePoints(vtkPointSet* data);

/**
 * Points, cells and the numeric arrays listed in `names`: whole numbers as int64, others as double.
 * `remark` states which arrays are dropped. @throws std::invalid_argument for cells that CellShape
 * lacks, cells with points that do not exist, and points that are not finite.
 */
CellMesh FromPointSet(
  vtkPointSet* data, const std::vector<std::string>& names, std::string& remark);

}

#endif
