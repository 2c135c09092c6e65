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

/// All values of an array, in the type of the list with the same size and kind; bits as uint8.
NumberList ToNumberList(vtkDataArray* array);

/// Adds each attribute to `data` as a point or cell array.
void AddAttributes(const std::vector<MeshAttribute>& attributes, vtkDataSet* data);

/// Adds the messages as the field data array Notes, unless there are none.
void AddNotes(const std::vector<std::string>& notes, vtkDataSet* data);

/// A warning about inverted tetrahedra (Core/TetrahedralMesh.h), or an empty text.
/// @pre all vertices are points of the mesh.
std::string InvertedTetrahedra(const CellMesh& mesh);

/// Points (double), cells and arrays. `Normals` become the active normals.
void ToGrid(const CellMesh& mesh, vtkUnstructuredGrid* grid);

/// The same for cells up to polygons, in VTK's order: vertices, lines, polygons.
/// @pre no attribute is on cells, which this order would mix up.
void ToSurface(const CellMesh& mesh, vtkPolyData* surface);

/// @throws std::invalid_argument with the first point that has a coordinate that is not finite.
void RequireFinitePoints(vtkPointSet* data);

/// An array that a format stores.
struct MeshArrayRule
{
  enum class Numbers
  {
    Whole,  ///< int64
    Finite, ///< double
    Any     ///< double, infinite ones and NaN as well
  };
  MeshAttribute::Place On;
  std::string Name;
  Numbers Kind;
  std::int64_t Components = 1;     ///< 0: any number
  std::vector<CellShape> Shapes{}; ///< the cells on which the format stores it; empty: all
};

/**
 * Points, cells and those arrays that fit `rules`, whatever their type, if the rule's type holds
 * all their values exactly. `remark` states which arrays are dropped, and for those that a rule
 * names, why. Values on cells other than the rule's shapes become 0.
 * @throws std::invalid_argument for cells that CellShape lacks, cells with points that do not
 * exist, and points that are not finite.
 */
CellMesh FromPointSet(
  vtkPointSet* data, const std::vector<MeshArrayRule>& rules, std::string& remark);

}

#endif
