/**
 * @class vtkMapSurface
 * @brief A density map as a closed, clean surface at an automatic level.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction. Values that are not numbers count as outside.
 *
 * Output: vtkPolyData, triangles facing away from the inside, a manifold, closed unless
 * CloseAtBorder is off, with the field data of the input and the arrays of OutputArrayTable().
 * If InvertedContrast is 1, there is also a warning (MapContrast in LevelEstimate.h).
 *
 * AutomaticLevel uses the level that the depositors of the map recommend, if the reader found it
 * (field data RecommendedLevel, from emd-NNNN.xml beside the map), otherwise one that separates the
 * molecule from its surroundings (LevelEstimate.h). It is cached until the map changes, so that a
 * new Level costs only two passes over the map, and the surface.
 *
 * Memory: the surface with normals takes 100 bytes for each triangle; the map is not copied if it
 * is float or double. On failure, there is one error through vtkErrorMacro and the output is empty.
 * The whole map is needed on one rank.
 *
 * @sa vtkDelaunayIsosurface vtkHessianCurvature
 */
#ifndef vtkMapSurface_h
#define vtkMapSurface_h

#include "Contouring/MapSurface.h"
#include "Contouring/MarchingCubes.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersContouringModule.h"
#include "vtkPolyDataAlgorithm.h"

class vtkDataArray;
class vtkImageData;

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
  /// The inside is where the value is above the level (densities). The automatic level
  /// is estimated for either setting.
  ISTHMUS_PARAMETER_SWITCH_OF(Contour, InsideIsHigher);
  ///@}

  ///@{
  /// Drop components with an area below this value, in length^2 (angstrom^2 for maps).
  ISTHMUS_PARAMETER(MinimumComponentArea, double);
  ///@}

  ///@{
  /// Drop components whose area, relative to that of the largest one, is below this value, 0 to 1.
  ISTHMUS_PARAMETER(MinimumComponentShare, double);
  ///@}

  ///@{
  /// Number of components to keep, the largest ones; 0: all of them.
  ISTHMUS_PARAMETER(LargestComponents, int);
  ///@}

  ///@{
  /// Where the level set leaves the map, close the surface half a cell beyond it. A
  /// Delaunay surface is always closed.
  ISTHMUS_PARAMETER_SWITCH_OF(Contour, CloseAtBorder);
  ///@}

  ///@{
  /// Cubes: marching cubes, immediate. Delaunay: no angle below 30 degrees, like that of
  /// vtkDelaunayIsosurface with its defaults; slower, in proportion to the number of points.
  vtkSetMacro(Quality, int);
  vtkGetMacro(Quality, int);
  ///@}

  /// The arrays that the filter adds to its outputs, and which of them are optional.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// Which optional arrays to make.
  ISTHMUS_OUTPUT_ARRAY_SELECTION();

  /// Value of the level set, in the unit of the scalars; unless it is given, the policy is that of
  /// AutomaticLevel.h: recommended, or else estimated.
  ISTHMUS_AUTOMATIC_UNLESS_GIVEN(Level);

protected:
  vtkMapSurface();
  ~vtkMapSurface() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  void MakeSurface(vtkImageData* image, vtkPolyData* surface);
  bool IsInverted(vtkImageData* image, vtkDataArray* scalars);

  vtkMapSurface(const vtkMapSurface&) = delete;
  void operator=(const vtkMapSurface&) = delete;

  isthmus::DustParameters Parameters;
  isthmus::MarchingCubesParameters Contour; ///< but its Level
  int Quality = Cubes;
};

#endif
