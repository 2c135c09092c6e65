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
 * Output arrays: `HighPass` (w, active; positive on the denser side of an edge) and, if
 * OutputFields is on, `SlowField` (u) and `FastField` (v). Cost: nodes x sqrt(Time); memory: six
 * volumes of the output's type.
 *
 * @sa vtkHighOrderDiffusion vtkPDETransform
 */
#ifndef vtkDiffusionHighPass_h
#define vtkDiffusionHighPass_h

#include "vtkDiffusionAlgorithm.h"
#include "vtkIsthmusFiltersImagingModule.h"

class VTKISTHMUSFILTERSIMAGING_EXPORT vtkDiffusionHighPass : public vtkDiffusionAlgorithm
{
public:
  static vtkDiffusionHighPass* New();
  vtkTypeMacro(vtkDiffusionHighPass, vtkDiffusionAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// d_10, length^2 per unit of time, of the slow field u. Default 0.05.
  vtkSetMacro(DiffusivityU, double);
  vtkGetMacro(DiffusivityU, double);
  ///@}

  ///@{
  /// d_20, length^2 per unit of time, of the fast field v. Default 1.
  vtkSetMacro(DiffusivityV, double);
  vtkGetMacro(DiffusivityV, double);
  ///@}

  ///@{
  /// epsilon_u, per unit of time: strength with which v pulls u. Default 0.05.
  vtkSetMacro(CouplingU, double);
  vtkGetMacro(CouplingU, double);
  ///@}

  ///@{
  /// epsilon_v, per unit of time: strength with which u pulls v. Default 0.05.
  vtkSetMacro(CouplingV, double);
  vtkGetMacro(CouplingV, double);
  ///@}

  ///@{
  /// Gradient at which diffusion stops, in data units per length; 0 (default): it never stops.
  vtkSetMacro(Sigma, double);
  vtkGetMacro(Sigma, double);
  ///@}

  ///@{
  /// End time. Default 4, with which v is smoothed as by a Gaussian of 2.8 voxels.
  vtkSetMacro(Time, double);
  vtkGetMacro(Time, double);
  ///@}

  ///@{
  /// Number of steps in which coupling and diffusion alternate; 0 (default) chooses it
  /// automatically.
  vtkSetMacro(Steps, int);
  vtkGetMacro(Steps, int);
  ///@}

  ///@{
  /// Add u and v to the output. Default off.
  vtkSetMacro(OutputFields, bool);
  vtkGetMacro(OutputFields, bool);
  vtkBooleanMacro(OutputFields, bool);
  ///@}

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

  double DiffusivityU = 0.05;
  double DiffusivityV = 1.0;
  double CouplingU = 0.05;
  double CouplingV = 0.05;
  double Sigma = 0.0;
  double Time = 4.0;
  int Steps = 0;
  bool OutputFields = false;
};

#endif
