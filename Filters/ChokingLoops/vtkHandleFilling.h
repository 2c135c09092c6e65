/**
 * @class vtkHandleFilling
 * @brief Removes small handles and tunnels of a surface (thesis, chapter 6: topological filtering).
 *
 * Tunnels narrower than a given size are filled and handles thinner than it are cut, along the
 * membranes that vtkChokingLoops finds there. Each operation lowers the genus by one and keeps the
 * points of the rest of the surface. The size is compared with the `Radius` of choking loops.
 *
 * Input: a closed triangulated surface (vtkPolyData).
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0, the repaired surface (vtkPolyData), facing
 * outward; 1, the fillings (vtkTable), one row each, in the order in which they were made. A
 * warning says how many handles and tunnels below the size could not be filled.
 *
 * Of the input's arrays, only field data are passed on. Algorithm, limits, cost: HandleFilling.h.
 */
#ifndef vtkHandleFilling_h
#define vtkHandleFilling_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT vtkHandleFilling : public vtkPolyDataAlgorithm
{
public:
  static vtkHandleFilling* New();
  vtkTypeMacro(vtkHandleFilling, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Handles and tunnels with a smaller radius than this are removed. In the unit of the points,
  /// above 0. Default 1.
  ISTHMUS_PARAMETER(FillHandlesBelow, double);
  ///@}

  enum SideType
  {
    Inside,
    Outside,
    Both
  };

  ///@{
  /// Inside: handles are cut; Outside: tunnels are filled; Both (default): the narrower of the two
  /// is removed.
  ISTHMUS_PARAMETER(Side, int);
  ///@}

  ///@{
  /// Thickness of the plate that fills a tunnel, and width of the gap that cuts a handle, in radii
  /// of the tunnel or handle: above 0, at most 1; reduced where the wall beside it is thin. Default
  /// 0.25.
  ISTHMUS_PARAMETER(Thickness, double);
  ///@}

  ///@{
  /// As in vtkChokingLoops: longest edge of the samples; 0 (default): automatic.
  ISTHMUS_PARAMETER(SampleSpacing, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkHandleFilling();
  ~vtkHandleFilling() override = default;

  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkHandleFilling(const vtkHandleFilling&) = delete;
  void operator=(const vtkHandleFilling&) = delete;

  isthmus::HandleFillingParameters Parameters;
};

#endif
