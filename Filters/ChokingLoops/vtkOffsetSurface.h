/**
 * @class vtkOffsetSurface
 * @brief Computes the points at a given distance from a surface: the boundary of the region
 * accessible to the center of a ball.
 *
 * Shows what "choked at d" means (thesis, Fig. 6.4): at a distance equal to the `Radius` of a
 * choking loop, the offset surface pinches off there. The distance to the triangles is sampled on a
 * regular grid, exactly near the offset, and contoured (flying edges). The error is about the
 * square of the grid spacing divided by the distance.
 *
 * Input: triangles (vtkPolyData), closed unless both sides are requested. Output: the surface at
 * `Distance` on the requested side, with the arrays of OutputArrayTable(). Triangles and normals
 * face outward from what it encloses: the grown body, the shrunken one, or the layer
 * between both. Formulas, errors and cost: OffsetSurface.h.
 */
#ifndef vtkOffsetSurface_h
#define vtkOffsetSurface_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT vtkOffsetSurface : public vtkPolyDataAlgorithm
{
public:
  static vtkOffsetSurface* New();
  vtkTypeMacro(vtkOffsetSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Distance from the surface, in the unit of the points, above 0. Default 1.
  ISTHMUS_PARAMETER(Distance, double);
  ///@}

  enum SideType
  {
    Inside,
    Outside,
    Both
  };

  ///@{
  /// Inside, Outside (of a closed surface, whichever way it is oriented) or Both (default).
  ISTHMUS_PARAMETER(Side, int);
  ///@}

  ///@{
  /// Grid cells along the longest side of the offset's bounding box, from 8 to 1024. Default 128.
  ISTHMUS_PARAMETER(Resolution, int);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkOffsetSurface() = default;
  ~vtkOffsetSurface() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkOffsetSurface(const vtkOffsetSurface&) = delete;
  void operator=(const vtkOffsetSurface&) = delete;

  isthmus::OffsetSurfaceParameters Parameters;
};

#endif
