/**
 * @class   vtkSurfaceToGrid
 * @brief   a surface on a grid: crossings with grid lines, inside and outside, signed distance
 *
 * Input 0 is a closed surface (vtkPolyData; polygons and strips are split into triangles) or a
 * volume (vtkImageData), whose isosurface at Level is the surface. For a surface, the grid is that
 * of the image on input 1, if there is one, else one around the surface with Spacing and Padding.
 * For a volume, it is the grid of the volume.
 *
 * **Output 0**, vtkImageData: `Inside`, `Irregular` and `SignedDistance` on nodes, unless
 * GetOutputArraySelection() has them off. A volume keeps its other arrays. Surface: the inside is
 * determined by the even-odd rule, so the orientation has no effect and cavities are outside.
 * Volume: inside is where the scalar is above Level (below, with InsideIsHigher off); the distance
 * is that to its isosurface by vtkFlyingEdges3D.
 *
 * **Output 1**, vtkPolyData, has a vertex for each crossing of the surface with a line of the grid,
 * in the order of the nodes below them. OutputArrayTable() lists the arrays of both.
 *
 * **Accuracy.** Crossings lie within 2^-20 spacings of the surface (grids of more than 500 nodes
 * along an axis: less exactly, as the number grows). Distances are exact within BandWidth spacings
 * h of the surface; farther away they are distances to the nearest crossing, which are never too
 * small, and too large by at most about h^2 / (2 distance), beside sharp edges and corners by up to
 * 2 h, unless ExactEverywhere is on.
 *
 * Formulas and sources: SurfaceCrossings.h, LevelCrossings.h, GridDistance.h.
 *
 * **Errors** (one message, empty outputs): surfaces that are not closed (if an array of
 * output 0 is selected), closed parts that cross (ShellCrossings.h), coordinates that are
 * not finite, damaged cells, negative Spacing, grids of a single layer, no point scalars. An empty
 * surface or image is not an error.
 *
 * **Cost.** O(triangles x nodes of their boxes grown by the band + nodes). Memory: 26 bytes for
 * each node (1 without distances). On several MPI ranks, each uses only its piece of the surface:
 * gather it first (in ParaView: Aggregate Dataset).
 */
#ifndef vtkSurfaceToGrid_h
#define vtkSurfaceToGrid_h

#include "Core/OutputArrays.h"
#include "vtkImageAlgorithm.h"
#include "vtkIsthmusFiltersSurfacesModule.h" // for the export macro

#include <memory> // to update its input in RequestInformation

class vtkPolyData;

#include <functional> // for progress
#include <vector>     // for distances

namespace isthmus
{
struct GridShape;
struct SurfaceView;
}

namespace isthmus
{
class InputInAdvance;
}

class VTKISTHMUSFILTERSSURFACES_EXPORT vtkSurfaceToGrid : public vtkImageAlgorithm
{
public:
  static vtkSurfaceToGrid* New();
  vtkTypeMacro(vtkSurfaceToGrid, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Spacing of the grid around a surface, in the unit of its points (angstrom). 0: the longest
  /// side of the bounding box / 64.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Number of spacings by which that grid extends beyond the bounding box on each side.
  vtkSetMacro(Padding, int);
  vtkGetMacro(Padding, int);
  ///@}

  ///@{
  /// Level of a volume that is the surface, in the unit of its scalars.
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /// Whether a volume's scalars are higher inside (on: densities) or lower
  /// (distances).
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  enum NormalModes
  {
    TriangleNormals = 0,
    PointNormals = 1
  };

  ///@{
  /// Normals at crossings with a surface: TriangleNormals or PointNormals (interpolated
  /// from the means of the triangles around each point).
  vtkSetMacro(NormalMode, int);
  vtkGetMacro(NormalMode, int);
  ///@}

  ///@{
  /// Width of the band around the surface in which distances are exact, in (largest) spacings, 1
  /// to 1000; larger values take more time.
  vtkSetMacro(BandWidth, double);
  vtkGetMacro(BandWidth, double);
  ///@}

  ///@{
  /// Whether distances are exact outside the band, too, by a search in a tree for each node.
  vtkSetMacro(ExactEverywhere, bool);
  vtkGetMacro(ExactEverywhere, bool);
  vtkBooleanMacro(ExactEverywhere, bool);
  ///@}

  /// Output 1.
  vtkPolyData* GetCrossings();

  /// The arrays that the filter adds to its outputs, and which of them are optional.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// Which optional arrays to make.
  ISTHMUS_OUTPUT_ARRAY_SELECTION();

protected:
  vtkSurfaceToGrid();
  ~vtkSurfaceToGrid() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Spacing = 0.0;
  int Padding = 2;
  double Level = 0.5;
  bool InsideIsHigher = true;
  int NormalMode = TriangleNormals;
  double BandWidth = 2.0;
  bool ExactEverywhere = false;

private:
  vtkSurfaceToGrid(const vtkSurfaceToGrid&) = delete;
  void operator=(const vtkSurfaceToGrid&) = delete;

  void CheckParameters() const;
  void GridAround(vtkPolyData* surface, vtkImageData* grid);
  std::vector<double> Distance(const isthmus::SurfaceView& mesh, const isthmus::GridShape& shape,
    const std::function<bool(double)>& progress);
  void FromSurface(vtkPolyData* surface, vtkImageData* output, vtkPolyData* crossings);
  void FromSurfaceOrJoined(vtkPolyData* surface, vtkImageData* output, vtkPolyData* crossings);
  void FromImage(vtkImageData* image, vtkImageData* output, vtkPolyData* crossings);

  std::unique_ptr<isthmus::InputInAdvance> Advance;
};

#endif
