/**
 * @class vtkCombinatorialMap
 * @brief Answers incidence queries on a volume mesh: the neighbours of a vertex, edge, face, cell,
 * half face or dart.
 *
 * An object, not a filter: SetMesh() builds the map of a vtkUnstructuredGrid of volume cells once
 * (CompactCombinatorialMap.h), which the queries then use. In Python,
 * isthmus.incidence.CombinatorialMap provides the same with iterators and numpy arrays.
 *
 * Numbers: vertices are the grid's points, cells its cells (cells that are not volume cells have no
 * incidence); edges and faces are those of vtkCellIncidence; half faces are numbered cell by cell
 * in the order of each cell's faces, darts likewise. An array with GetNumber() values for a kind
 * can serve as an attribute of that kind.
 *
 * GetIncident(from, id, to) lists the elements of kind `to` that are incident to element `id` of
 * kind `from`: the cells around a vertex (its star), those around an edge (its fan,
 * counter-clockwise seen from the edge's larger vertex), the vertices of a face, ... Vertex to
 * Vertex: joined by an edge; Cell to Cell: with a common face; HalfFace to HalfFace: the other side
 * of the face (none on the boundary). Other pairs of the same kind are not defined and cause an
 * error. The cost of a query is proportional to the size of its result, whatever the size of the
 * mesh; queries from half faces and darts also take the logarithm of the number of cells.
 *
 * Errors (message, empty result): a mesh that is not a valid map (see vtkCellIncidence), numbers
 * and kinds that do not exist.
 */
#ifndef vtkCombinatorialMap_h
#define vtkCombinatorialMap_h

#include "vtkIsthmusFiltersCellComplexModule.h" // for the export macro

#include <vtkObject.h>

#include <memory>

class vtkIdList;
class vtkIdTypeArray;
class vtkUnstructuredGrid;

class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT vtkCombinatorialMap : public vtkObject
{
public:
  static vtkCombinatorialMap* New();
  vtkTypeMacro(vtkCombinatorialMap, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ElementKind
  {
    Vertex,
    Edge,
    Face,
    Cell,
    HalfFace,
    Dart
  };

  /// Builds the map of a mesh; the mesh itself is not kept. Returns false and reports an error if
  /// the mesh has no valid map. Time and memory are linear in the number of cells.
  bool SetMesh(vtkUnstructuredGrid* mesh);

  /// The number of elements of a kind; 0 without a mesh.
  vtkIdType GetNumber(int kind);

  /// The elements of kind `to` that are incident to element `id` of kind `from`.
  void GetIncident(int from, vtkIdType id, int to, vtkIdList* found);

  /// The same for all elements of kind `from`: those of element i are ids[offsets[i]] to
  /// ids[offsets[i + 1] - 1].
  void GetIncidence(int from, int to, vtkIdTypeArray* offsets, vtkIdTypeArray* ids);

  /// beta_1, beta_2 or beta_3 of all darts: the dart that differs in the edge (the next one around
  /// its face), the face, or the cell; -1 if there is no cell beyond.
  void GetBeta(int dimension, vtkIdTypeArray* darts);

  ///@{ The map's tables in use and their sizes in bytes. Tables of edges and faces are built on
  /// first use.
  int GetNumberOfTables();
  const char* GetTableName(int table);
  vtkIdType GetTableBytes(int table);
  ///@}

  /// The thesis' estimate for tetrahedra with coordinates, in bytes: 4 (8.7 n3 + n_b), n3 cells,
  /// n_b boundary faces (Table 3.8).
  double GetEstimatedBytes();

protected:
  vtkCombinatorialMap();
  ~vtkCombinatorialMap() override;

private:
  vtkCombinatorialMap(const vtkCombinatorialMap&) = delete;
  void operator=(const vtkCombinatorialMap&) = delete;

  class vtkInternals;
  template <typename Map>
  class vtkTypedInternals;
  std::unique_ptr<vtkInternals> Internals;
};

#endif
