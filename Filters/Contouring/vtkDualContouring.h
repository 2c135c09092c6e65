/**
 * @class vtkDualContouring
 * @brief A surface with sharp edges and corners kept, from a volume or from another surface.
 *
 * Input: vtkImageData with one-component point scalars (normals are the gradient of the volume,
 * next to edges that of one side), or a closed vtkPolyData (normals are those of its triangles),
 * which is sampled on a grid with Spacing.
 *
 * Output: vtkPolyData in world coordinates, facing outward: triangles, or quadrilaterals. Every
 * edge belongs to two polygons; the surface is open only where a level leaves the volume. Field
 * data of the input are kept.
 *
 * Source: T. Ju et al., doi:10.1145/566654.566586, with a vertex for each piece of surface in a
 * cell (S. Schaefer et al., doi:10.1109/TVCG.2007.1012). Polygons may cross where the surface turns
 * within a cell, unless FreeOfCrossings is on. On failure, there is one error through vtkErrorMacro
 * and the output is empty. Cost: see DualContouring.h. The whole input is needed on one rank.
 */
#ifndef vtkDualContouring_h
#define vtkDualContouring_h

#include "Contouring/DualContouringParameters.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersContouringModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSFILTERSCONTOURING_EXPORT vtkDualContouring : public vtkPolyDataAlgorithm
{
public:
  static vtkDualContouring* New();
  vtkTypeMacro(vtkDualContouring, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  ///@{
  /// The inside is where the value is above the level; volumes only.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Spacing of the grid for a surface, in its unit; 0: 1/64 of the longest side of its bounds.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// How much normals must vary within a cell to count as an edge or a corner, as a fraction of the
  /// largest eigenvalue, 0 to 1; a smaller value keeps blunter edges and more noise. For surfaces,
  /// edges of at least this angle, and at least 30 degrees, are kept exactly, but the tip of a
  /// corner that no line of the grid crosses may be cut off. 0.07 corresponds to
  /// 30 degrees.
  ISTHMUS_PARAMETER(FeatureThreshold, double);
  ///@}

  ///@{
  /// How far, in spacings from 0 to 1, a vertex may move into other cells that have a vertex. A
  /// vertex may always move into empty cells and to edges. Polygons cross more easily above
  /// 0.
  ISTHMUS_PARAMETER(Reach, double);
  ///@}

  ///@{
  /// Output the quadrilaterals of the method instead of triangles.
  ISTHMUS_PARAMETER_SWITCH(Quadrilaterals);
  ///@}

  ///@{
  /// Allowed distance from the surface of all cells, in the unit of length of the input. Above 0,
  /// cells are merged where the surface is flat enough (octree), and it stays manifold. 0:
  /// no cells are merged.
  ISTHMUS_PARAMETER(Tolerance, double);
  ///@}

  ///@{
  /// Prevent triangles from crossing: those that cross are cut into smaller ones that each stay in
  /// a cell, which rounds edges there. Needs triangles and Reach 0.
  ISTHMUS_PARAMETER_SWITCH(FreeOfCrossings);
  ///@}

  /// Value of the level set, in the unit of the scalars; volumes only; unless it is given, the
  /// policy is that of AutomaticLevel.h.
  ISTHMUS_AUTOMATIC_UNLESS_GIVEN(Level);

protected:
  vtkDualContouring();
  ~vtkDualContouring() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkDualContouring(const vtkDualContouring&) = delete;
  void operator=(const vtkDualContouring&) = delete;

  isthmus::DualContouringParameters Parameters;
  bool InsideIsHigher = true;
  double Spacing = 0.0;
};

#endif
