/**
 * @class vtkDiffusionHighPass
 * @brief Edges and detail of a volume: the difference of two coupled diffusions.
 *
 * Equations 4.37 to 4.39 of X. Feng's thesis (G. W. Wei, Y. Q. Jia, Europhys. Lett. 59 (2002) 814):
 *
 *     u_t = div(d_1 grad u) + CouplingU (v - u),   v_t = div(d_2 grad v) + CouplingV (u - v),
 *     w = u - v,   u = v = input at time 0,
 *
 * d_1, d_2 = DiffusivityU, DiffusivityV times exp(-|grad|^2 / (2 Sigma^2)), Neumann boundaries.
 * With DiffusivityV >> DiffusivityU, w is a high-pass or (DiffusivityU > 0) band-pass of the input;
 * it is zero for a constant and, with coupling, vanishes for long times.
 *
 * Output arrays: `HighPass` (w, active) and those that GetOutputArraySelection() has. Cost: nodes x
 * sqrt(Time); memory: six volumes of the output's type.
 *
 * @sa vtkHighOrderDiffusion vtkPDETransform
 */
#ifndef vtkDiffusionHighPass_h
#define vtkDiffusionHighPass_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Imaging/DiffusionHighPass.h"
#include "vtkDiffusionAlgorithm.h"
#include "vtkIsthmusFiltersImagingModule.h"

class VTKISTHMUSFILTERSIMAGING_EXPORT vtkDiffusionHighPass : public vtkDiffusionAlgorithm
{
public:
  static vtkDiffusionHighPass* New();
  vtkTypeMacro(vtkDiffusionHighPass, vtkDiffusionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// d_10, length^2 per unit of time, of the slow field u.
  ISTHMUS_PARAMETER(DiffusivityU, double);
  ///@}

  ///@{
  /// d_20, length^2 per unit of time, of the fast field v.
  ISTHMUS_PARAMETER(DiffusivityV, double);
  ///@}

  ///@{
  /// epsilon_u, per unit of time: strength with which v pulls u.
  ISTHMUS_PARAMETER(CouplingU, double);
  ///@}

  ///@{
  /// epsilon_v, per unit of time: strength with which u pulls v.
  ISTHMUS_PARAMETER(CouplingV, double);
  ///@}

  ///@{
  /// Gradient at which diffusion stops, in data units per length; 0: it never stops.
  ISTHMUS_PARAMETER(Sigma, double);
  ///@}

  ///@{
  /// End time. With DiffusivityV = 1, a time of 4 smooths v as a Gaussian of 2.8 voxels does.
  ISTHMUS_PARAMETER(Time, double);
  ///@}

  ///@{
  /// Number of steps in which coupling and diffusion alternate; 0 chooses it
  /// automatically.
  ISTHMUS_PARAMETER(Steps, int);
  ///@}

  ///@{
  /// Lengths in units of the smallest spacing (on) or in the data's unit, angstrom
  /// for maps (off). Times, diffusivities and gradients follow.
  vtkSetMacro(VoxelUnits, bool);
  vtkGetMacro(VoxelUnits, bool);
  vtkBooleanMacro(VoxelUnits, bool);
  ///@}

  /// The arrays that the filter adds to its outputs, and which of them are optional.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// Which optional arrays to make.
  ISTHMUS_OUTPUT_ARRAY_SELECTION();

protected:
  vtkDiffusionHighPass();
  ~vtkDiffusionHighPass() override = default;

  int HaloWidth() override;
  void Process(isthmus::DiffusionImage<float>& image) override;
  void Process(isthmus::DiffusionImage<double>& image) override;

private:
  template <typename T>
  void FindEdges(isthmus::DiffusionImage<T>& image);

  vtkDiffusionHighPass(const vtkDiffusionHighPass&) = delete;
  void operator=(const vtkDiffusionHighPass&) = delete;

  isthmus::HighPassParameters Parameters;
};

#endif
