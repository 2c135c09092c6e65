/**
 * @file MeshConversion.h
 * @brief Meshes of files as VTK data, and back.
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

/// The numbers as an array of their own type, without a name.
vtkSmartPointer<vtkDataArray> ToDataArray(const NumberList& numbers, std::int64_t components);

/// Each attribute as a point or cell array of `data`.
void AddAttributes(const std::vector<MeshAttribute>& attributes, vtkDataSet* data);

/// The sentences as the field data array `Notes`; none where there are none.
void AddNotes(const std::vector<std::string>& notes, vtkDataSet* data);

/// Points (double), cells and arrays. `Normals` become the active normals.
void ToGrid(const CellMesh& mesh, vtkUnstructuredGrid* grid);

/// The same for cells up to polygons, in VTK's order: vertices, lines, polygons.
/// @pre no attribute is on cells, which this order would mix up.
void ToSurface(const CellMesh& mesh, vtkPolyData* surface);

/// @throws std::invalid_argument with the first point that has a coordinate that is not finite.
void RequireFinitePoints(vtkPointSet* data);

/**
 * Points, cells and those of `names` among the arrays that hold numbers: whole numbers as int64,
 * others as double. `remark` says which arrays are left out. @throws std::invalid_argument for
 * cells that CellShape does not name, for cells with points that are not there, and points not
 * finite.
 */
CellMesh FromPointSet(
  vtkPointSet* data, const std::vector<std::string>& names, std::string& remark);

}

#endif
