/**
 * @class vtkMapSurface
 * @brief A density map as a closed, clean surface at an automatic level.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction. Values that are not numbers count as outside.
 *
 * Output: vtkPolyData, triangles facing away from the inside, with unit point normals and the cell
 * array `Component` (0 for the one of the largest area). It is a manifold, and closed unless
 * CloseAtBorder is off. Field data: that of the input, `Level` (the one taken), `ComponentsFound`
 * (before dust was hidden) and `ComponentArea` (length^2) of those that stay, largest first;
 * `InvertedContrast` (1), with a warning, where an automatic level was taken above a density that
 * seems darker than the background (MapContrast in LevelEstimate.h).
 *
 * AutomaticLevel takes the level that the map's depositors recommend, where the reader found it
 * (field data `RecommendedLevel`, from `emd-NNNN.xml` beside the map), else one that separates the
 * molecule from its surroundings (LevelEstimate.h). It is kept until the map changes, so that a new
 * Level costs two passes over the map and the surface: well under a second for 256^3 nodes.
 *
 * Memory: surface with normals, 100 bytes a triangle; the map is not copied where it is float or
 * double. On failure: one error through vtkErrorMacro and an empty output. The whole map is
 * needed on one rank.
 *
 * @sa vtkDelaunayIsosurface vtkHessianCurvature
 */
#ifndef vtkMapSurface_h
#define vtkMapSurface_h

#include "vtkIsthmusFiltersContouringModule.h"
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the level

class vtkDataArray;
class vtkImageData;

namespace isthmus
{
class AutomaticLevel;
}

class VTKISTHMUSFILTERSCONTOURING_EXPORT vtkMapSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkMapSurface* New();
  vtkTypeMacro(vtkMapSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum QualityType
  {
    Cubes = 0,
    Delaunay = 1
  };

  ///@{
  /// Value of the level set, in the unit of the scalars. Setting it switches AutomaticLevel off.
  /// Default 0.
  void SetLevel(double level);
  vtkGetMacro(Level, double);
  ///@}

  /// Level alone: for a panel, where AutomaticLevel has a switch of its own.
  void SetLevelOnly(double level);

  ///@{
  /// Take the recommended level, or else an estimated one, instead of Level. Default on.
  vtkSetMacro(AutomaticLevel, bool);
  vtkGetMacro(AutomaticLevel, bool);
  vtkBooleanMacro(AutomaticLevel, bool);
  ///@}

  /// The level of the last run, whoever chose it.
  vtkGetMacro(UsedLevel, double);

  ///@{
  /// The inside is where the value is above the level (densities). Default on. An automatic level
  /// is found for either.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Leave out components of a smaller area, length^2 (angstrom^2 for maps). Default 0: none.
  vtkSetMacro(MinimumComponentArea, double);
  vtkGetMacro(MinimumComponentArea, double);
  ///@}

  ///@{
  /// Leave out components whose area is a smaller share, 0 to 1, of the largest one's. Default 0.
  vtkSetMacro(MinimumComponentShare, double);
  vtkGetMacro(MinimumComponentShare, double);
  ///@}

  ///@{
  /// Keep that many components, the largest. Default 0: all of them.
  vtkSetMacro(LargestComponents, int);
  vtkGetMacro(LargestComponents, int);
  ///@}

  ///@{
  /// Where the level set leaves the map, close the surface half a cell beyond it. Default on. A
  /// Delaunay surface is always closed.
  vtkSetMacro(CloseAtBorder, bool);
  vtkGetMacro(CloseAtBorder, bool);
  vtkBooleanMacro(CloseAtBorder, bool);
  ///@}

  ///@{
  /// Cubes (default): marching cubes, at once. Delaunay: no angle below 30 degrees, as from
  /// vtkDelaunayIsosurface with its defaults; about 110 microseconds a point.
  vtkSetMacro(Quality, int);
  vtkGetMacro(Quality, int);
  ///@}

  ///@{
  /// Unit normals at the points, for smooth shading. Default on.
  vtkSetMacro(GenerateNormals, bool);
  vtkGetMacro(GenerateNormals, bool);
  vtkBooleanMacro(GenerateNormals, bool);
  ///@}

protected:
  vtkMapSurface();
  ~vtkMapSurface() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  void MakeSurface(vtkImageData* image, vtkPolyData* surface);
  bool IsSuspectedOfInversion(vtkImageData* image, vtkDataArray* scalars);

  vtkMapSurface(const vtkMapSurface&) = delete;
  void operator=(const vtkMapSurface&) = delete;

  double Level = 0.0;
  bool AutomaticLevel = true;
  double UsedLevel = 0.0;
  bool InsideIsHigher = true;
  double MinimumComponentArea = 0.0;
  double MinimumComponentShare = 0.0;
  int LargestComponents = 0;
  bool CloseAtBorder = true;
  int Quality = Cubes;
  bool GenerateNormals = true;

  std::unique_ptr<isthmus::AutomaticLevel> LevelOfMap;
};

#endif
