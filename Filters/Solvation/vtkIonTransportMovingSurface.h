/**
 * @class   vtkIonTransportMovingSurface
 * @brief   ion transport through a channel whose surface moves with the field and the ions
 *
 * Inputs and properties of vtkIonTransport. Surface tension, pressure, dispersion, the electric
 * field and the osmotic pressure of the ions move the surface of channel and membrane; the flow of
 * the surface and the Poisson-Nernst-Planck equations are solved alternately until currents and
 * lumen converge. This is the coupled Laplace-Beltrami and Poisson-Nernst-Planck model of X. Feng,
 * PhD thesis, equations 4.25 to 4.28; see MovingChannel.h. The surface starts from that of the
 * atoms, or from input 1, and never recedes behind it. Well depths are as for vtkNonpolarSolvation.
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0 and 1, those of vtkIonTransport for the last
 * surface; 2, vtkTable with a row for each update, the first for the initial surface.
 *
 * Accuracy: rotations change the current by up to 1.4 %, and the first update differs from
 * vtkIonTransport by 0.7 % at Spacing 0.5 and 2 % at 0.8 (PermittivityMean in TransportGrid.h).
 * After MaximumUpdates the surface that changed least is returned, with a warning.
 *
 * **Errors**: those of vtkIonTransport, atoms without well depths, and a surface that closes the
 * channel. Cost: that of vtkIonTransport for each update.
 */
#ifndef vtkIonTransportMovingSurface_h
#define vtkIonTransportMovingSurface_h

#include "Core/OutputArrays.h"
#include "MolecularSurfaces/SolventProperties.h"
#include "Solvation/SolvationParameters.h"
#include "vtkIonTransport.h"
#include "vtkIsthmusFiltersSolvationModule.h" // for the export macro

#include <vector> // for the table of output arrays

class VTKISTHMUSFILTERSSOLVATION_EXPORT vtkIonTransportMovingSurface : public vtkIonTransport
{
public:
  static vtkIonTransportMovingSurface* New();
  vtkTypeMacro(vtkIonTransportMovingSurface, vtkIonTransport);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of steps of the flow between two solutions, fewer if the volume converges before.
  /// Default 20.
  ISTHMUS_PARAMETER_OF(Motion.Policy, UpdatePeriod, int);
  ///@}

  ///@{
  /// The fractions of each period's motion and of each new force that are applied; above 0, at most
  /// 1. Defaults 1.
  ISTHMUS_PARAMETER_OF(Motion.Policy, SurfaceRelaxation, double);
  ISTHMUS_PARAMETER_OF(Motion.Policy, FieldRelaxation, double);
  ///@}

  ///@{
  /// The surface has converged when the relative change of the currents and of the water in the
  /// lumen is below UpdateTolerance twice in a row; the iteration always ends after MaximumUpdates.
  /// Defaults 1e-3 and 10.
  ISTHMUS_PARAMETER_OF(Motion, UpdateTolerance, double);
  ISTHMUS_PARAMETER_OF(Motion.Policy, MaximumUpdates, int);
  ///@}

  /// Output 2.
  vtkTable* GetUpdates();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// SurfaceTension, above 0, and Pressure: SolventProperties.h. Defaults 0.0700 and 0.0464.
  ISTHMUS_SOLVENT_PROPERTIES(Motion.Solvent);

protected:
  vtkIonTransportMovingSurface();
  ~vtkIonTransportMovingSurface() override;

  void CompleteProblem(vtkDataObject* input, const isthmus::MoleculeAtoms& atoms,
    isthmus::ChannelProblem& problem) override;
  std::string FillMotion(const isthmus::ChannelSolution& channel, vtkImageData* image,
    vtkInformationVector* outputVector) override;

private:
  vtkIonTransportMovingSurface(const vtkIonTransportMovingSurface&) = delete;
  void operator=(const vtkIonTransportMovingSurface&) = delete;

  isthmus::MovingChannelParameters Motion;
};

#endif
