/**
 * @class vtkOffsetSurface
 * @brief The points at a given distance from a surface: what is left for a ball to roll in.
 *
 * Shows what "choked at d" means (thesis, Fig. 6.4): at the `Radius` of a choking loop the offset
 * surface pinches off there. The distance to the triangles is sampled on a regular grid, exactly
 * where it matters, and contoured (flying edges), so that the result is right to about the square
 * of the grid spacing over the distance.
 *
 * Input: triangles (vtkPolyData), closed unless both sides are requested. Output: the surface at
 * `Distance` on the requested side, with normals that face away from the input and the cell spacing
 * as field data `GridSpacing`. Formulas, errors and cost: OffsetSurface.h.
 */
#ifndef vtkOffsetSurface_h
#define vtkOffsetSurface_h

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
  vtkSetMacro(Distance, double);
  vtkGetMacro(Distance, double);
  ///@}

  enum SideType
  {
    Inside,
    Outside,
    Both
  };

  ///@{
  /// Inside, Outside (of a closed surface, whichever way it faces) or Both (default).
  vtkSetClampMacro(Side, int, Inside, Both);
  vtkGetMacro(Side, int);
  ///@}

  ///@{
  /// Grid cells along the longest side of the offset's box. Default 128.
  vtkSetClampMacro(Resolution, int, 8, 1024);
  vtkGetMacro(Resolution, int);
  ///@}

protected:
  vtkOffsetSurface() = default;
  ~vtkOffsetSurface() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkOffsetSurface(const vtkOffsetSurface&) = delete;
  void operator=(const vtkOffsetSurface&) = delete;

  double Distance = 1.0;
  int Side = Both;
  int Resolution = 128;
};

#endif
