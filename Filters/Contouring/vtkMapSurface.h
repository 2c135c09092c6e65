/**
 * @class vtkMapSurface
 * @brief A density map as a closed, clean surface at an automatic level.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction. Values that are not numbers count as outside.
 *
 * Output: vtkPolyData, triangles facing away from the inside, with unit point normals and the cell
 * array Component (0 for the component with the largest area). It is a manifold, and closed unless
 * CloseAtBorder is off. Field data: those of the input, Level (the level used), ComponentsFound
 * (before dust was hidden) and ComponentArea (length^2) of the remaining components, largest first.
 * InvertedContrast (1) is added, with a warning, if an automatic level was used but density seems
 * to be darker than the background (MapContrast in LevelEstimate.h).
 *
 * AutomaticLevel uses the level that the depositors of the map recommend, if the reader found it
 * (field data RecommendedLevel, from emd-NNNN.xml beside the map), otherwise one that separates the
 * molecule from its surroundings (LevelEstimate.h). It is cached until the map changes, so that a
 * new Level costs two passes over the map and the surface: well under a second for 256^3 nodes.
 *
 * Memory: the surface with normals takes 100 bytes for each triangle; the map is not copied if it
 * is float or double. On failure, there is one error through vtkErrorMacro and the output is empty.
 * The whole map is needed on one rank.
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

  /// Sets only Level, for a panel in which AutomaticLevel is a separate switch.
  void SetLevelOnly(double level);

  ///@{
  /// Use the recommended level, or otherwise an estimated one, instead of Level. Default on.
  vtkSetMacro(AutomaticLevel, bool);
  vtkGetMacro(AutomaticLevel, bool);
  vtkBooleanMacro(AutomaticLevel, bool);
  ///@}

  /// The level of the last run, whether it was chosen automatically or set.
  vtkGetMacro(UsedLevel, double);

  ///@{
  /// The inside is where the value is above the level (densities). Default on. The automatic level
  /// is estimated for either setting.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Drop components with an area below this value, in length^2 (angstrom^2 for maps). Default 0:
  /// none.
  vtkSetMacro(MinimumComponentArea, double);
  vtkGetMacro(MinimumComponentArea, double);
  ///@}

  ///@{
  /// Drop components whose area, relative to that of the largest one, is below this value, 0 to 1.
  /// Default 0.
  vtkSetMacro(MinimumComponentShare, double);
  vtkGetMacro(MinimumComponentShare, double);
  ///@}

  ///@{
  /// Number of components to keep, the largest ones. Default 0: all of them.
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
  /// Cubes (default): marching cubes, immediate. Delaunay: no angle below 30 degrees, like that of
  /// vtkDelaunayIsosurface with its defaults; about 110 microseconds for each point.
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
