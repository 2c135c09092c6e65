/**
 * @class vtkTetCutaway
 * @brief Removes a connected piece of a volume mesh, starting from a seed, and shows the exposed
 * faces.
 *
 * Cells are removed in breadth-first order through their faces, beginning at a boundary face, until
 * a given number of cells, a distance from the seed, or a plane is reached (X. Feng's thesis,
 * Figure 4.14). The rest consists of whole cells, so the quality of the mesh can be judged.
 *
 * Input: vtkUnstructuredGrid of volume cells, as for vtkCellIncidence; despite the name of the
 * class, any linear type is accepted.
 *
 * Output port 0, vtkPolyData: the boundary of the remaining cells, with each face as a polygon,
 * counter-clockwise seen from outside, with the data of the cell that it bounds.
 *
 * Output port 1, vtkUnstructuredGrid: the cells that remain with their data. OutputArrayTable()
 * lists the arrays that are added.
 *
 * Both outputs keep all points of the input, so that the bounds and the camera do not change.
 *
 * A seed that does not exist is an error. If the seed is on the other side of the plane, nothing is
 * removed and a warning is issued. Time and memory are linear in the number of cells. With several
 * MPI ranks, each rank cuts its own piece.
 */
#ifndef vtkTetCutaway_h
#define vtkTetCutaway_h

#include "CellComplex/TetCutaway.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersCellComplexModule.h" // for the export macro

#include <vtkPolyDataAlgorithm.h>

class VTKISTHMUSFILTERSCELLCOMPLEX_EXPORT vtkTetCutaway : public vtkPolyDataAlgorithm
{
public:
  static vtkTetCutaway* New();
  vtkTypeMacro(vtkTetCutaway, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SeedModes
  {
    AtPoint = 0,
    AtFace = 1
  };
  ///@{ Where the removal begins: at the boundary face nearest to SeedPoint, or at the
  /// face with the number SeedFace.
  vtkSetMacro(SeedMode, int);
  vtkGetMacro(SeedMode, int);
  ///@}

  ///@{
  /// A point near the boundary, in the units of the mesh.
  vtkSetVector3Macro(SeedPoint, double);
  vtkGetVector3Macro(SeedPoint, double);
  ///@}

  ///@{ FaceId of the seed face, as numbered by vtkCellIncidence.
  vtkSetMacro(SeedFace, vtkIdType);
  vtkGetMacro(SeedFace, vtkIdType);
  ///@}

  enum StopRules
  {
    ByNumber = 0,
    ByDistance = 1,
    ByPlane = 2
  };
  ///@{ Criterion that ends the removal: NumberOfCells, Distance, or the plane.
  ISTHMUS_PARAMETER(StopRule, int);
  ///@}

  ///@{ Number of cells to remove.
  ISTHMUS_PARAMETER(NumberOfCells, vtkIdType);
  ///@}

  ///@{ Largest distance of the centers of removed cells from that of the seed cell, in the units of
  /// the mesh.
  ISTHMUS_PARAMETER(Distance, double);
  ///@}

  ///@{ Plane: cells with their center on the side to which PlaneNormal points are removed if they
  /// are connected with the seed.
  ISTHMUS_PARAMETER_VECTOR3(PlaneOrigin, double);
  ISTHMUS_PARAMETER_VECTOR3(PlaneNormal, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkTetCutaway();
  ~vtkTetCutaway() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

  isthmus::CutawayRule Parameters;
  int SeedMode = AtPoint;
  double SeedPoint[3] = { 0.0, 0.0, 0.0 };
  vtkIdType SeedFace = 0;

private:
  vtkTetCutaway(const vtkTetCutaway&) = delete;
  void operator=(const vtkTetCutaway&) = delete;
};

#endif
