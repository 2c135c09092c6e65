/**
 * @class vtkAreaQuantiles
 * @brief Two quantiles of an array over the area of a surface: the range for a colour bar.
 *
 * Extreme values of curvature and potential occur at a few points near creases; with a colour range
 * between them, the surface would have almost a single colour. Input: vtkPolyData (or another
 * vtkDataSet, whose points or cells have equal weights) with the point or cell array of
 * `SetInputArrayToProcess(0, ...)`, one component. Values that are not finite are ignored, and so
 * are those for which the point array CurvatureValid is 0.
 *
 * Output: vtkTable with two rows (OutputArrayTable()); no rows if there are no values. The plugin
 * uses it to choose colour ranges, also on a remote server. Memory: 16 bytes a value.
 */
#ifndef vtkAreaQuantiles_h
#define vtkAreaQuantiles_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersSurfacesModule.h"
#include "vtkTableAlgorithm.h"

class VTKISTHMUSFILTERSSURFACES_EXPORT vtkAreaQuantiles : public vtkTableAlgorithm
{
public:
  static vtkAreaQuantiles* New();
  vtkTypeMacro(vtkAreaQuantiles, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Fractions of the area, 0 to 1.
  vtkSetMacro(Lower, double);
  vtkGetMacro(Lower, double);
  vtkSetMacro(Upper, double);
  vtkGetMacro(Upper, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkAreaQuantiles();
  ~vtkAreaQuantiles() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkAreaQuantiles(const vtkAreaQuantiles&) = delete;
  void operator=(const vtkAreaQuantiles&) = delete;

  double Lower = 0.02;
  double Upper = 0.98;
};

#endif
