/**
 * @class vtkCellIncidence
 * @brief Lists the edges and faces of a volume mesh, each once, with a number and the incident
 * cells.
 *
 * Input: vtkUnstructuredGrid of linear volume cells of any type, including VTK_POLYHEDRON. Cells of
 * higher order are represented by their corner points, and points, lines and surface cells are
 * dropped, both with a warning.
 *
 * Output port 0, vtkPolyData: each edge as one line, from its smaller to its larger point. Output
 * port 1, vtkPolyData: each face as one polygon, counter-clockwise seen from outside the mesh or,
 * for an interior face, from its second cell. OutputArrayTable() lists their arrays.
 *
 * Edges are ordered by the numbers of their points, faces by their three smallest, so the ids do
 * not depend on the order of the cells or on the number of threads. Both outputs share the input's
 * points and point data, and its field data; with PassCellData each edge and face carries the cell
 * data of its first incident cell.
 *
 * Time and memory are linear in the number of cells (isthmus::CompactCombinatorialMap). A face with
 * three cells, cells whose faces do not match, and cells that use a point twice or a point that
 * does not exist cause an error that names them, and empty outputs. With several MPI ranks, each
 * rank numbers its own piece: gather the mesh first if ids must be global.
 */
#ifndef vtkCellIncidence_h
#define vtkCellIncidence_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersCellComplexModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT vtkCellIncidence : public vtkPolyDataAlgorithm
{
public:
  static vtkCellIncidence* New();
  vtkTypeMacro(vtkCellIncidence, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Whether edges and faces carry the cell data of their first incident cell.
  vtkSetMacro(PassCellData, bool);
  vtkGetMacro(PassCellData, bool);
  vtkBooleanMacro(PassCellData, bool);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkCellIncidence();
  ~vtkCellIncidence() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  bool PassCellData = true;

private:
  vtkCellIncidence(const vtkCellIncidence&) = delete;
  void operator=(const vtkCellIncidence&) = delete;
};

#endif
