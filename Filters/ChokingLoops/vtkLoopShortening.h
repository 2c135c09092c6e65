/**
 * @class vtkLoopShortening
 * @brief Shortens closed polylines on a surface to geodesic loops of their homotopy class.
 *
 * Input 0: closed polylines (vtkPolyData) whose points lie on the surface, such as the loops of
 * vtkChokingLoops; the first point may be repeated at the end. Input 1: the closed, manifold,
 * consistently oriented triangle surface. Points are moved to the nearest point of the surface and
 * joined along its edges where they are not neighbours, which keeps the class of loops that follow
 * the surface closely.
 *
 * Output: one closed polyline for each input loop, with its cell data and the arrays of
 * OutputArrayTable(). A loop that can be contracted to a point is returned unchanged.
 *
 * Errors (one message, empty output): a surface that CheckedSurface() in SurfacePreparation.h
 * refuses, a loop on two parts of the surface, a loop that is a single point or runs back along
 * itself, loops and a surface that do not overlap (InputOverlap.h; small loops do not cause a
 * warning here).
 *
 * Source: S.-Q. Xin, Y. He, C.-W. Fu, IEEE TVCG 18 (2012) 879. Time per round: proportional to the
 * number of edges crossed.
 */
#ifndef vtkLoopShortening_h
#define vtkLoopShortening_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"
#include "vtkPolyDataAlgorithm.h"

class VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT vtkLoopShortening : public vtkPolyDataAlgorithm
{
public:
  static vtkLoopShortening* New();
  vtkTypeMacro(vtkLoopShortening, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Maximum number of rounds; each finds the shortest path in a strip of triangles and reroutes
  /// the strip. From 1 to 100000; default 1000, which in practice means until the loop is a
  /// geodesic.
  ISTHMUS_PARAMETER(MaximumRounds, int);
  ///@}

  ///@{
  /// Relative accuracy of the length, from 1e-12 to 1. Default 1e-6.
  ISTHMUS_PARAMETER(Tolerance, double);
  ///@}

  /// The surface: the second input.
  void SetSurfaceConnection(vtkAlgorithmOutput* port) { this->SetInputConnection(1, port); }
  void SetSurfaceData(vtkDataObject* surface) { this->SetInputData(1, surface); }

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkLoopShortening();
  ~vtkLoopShortening() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkLoopShortening(const vtkLoopShortening&) = delete;
  void operator=(const vtkLoopShortening&) = delete;

  isthmus::LoopShorteningParameters Parameters;
};

#endif
