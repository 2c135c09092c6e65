/**
 * @class   vtkMolecularFlowSurface
 * @brief   molecular surface by mean curvature flow with the atoms as obstacle
 *
 * Input: atoms, a vtkPointSet whose point array `Radius` (or the one chosen with
 * SetInputArrayToProcess) holds radii in angstrom, or a vtkMolecule; if there is no such array,
 * radii are assigned by element (array `Element`, or the molecule's atomic numbers; Bondi's table,
 * then Alvarez'). Water is dropped unless IncludeWaters is on, and one of alternate locations is
 * kept. Proteins and nucleic acids without hydrogens get united-atom radii, see UnitedAtoms. The
 * field array `Notes` of outputs 0 and 1 has a note on each of these.
 *
 * Outputs, whose arrays OutputArrayTable() lists:
 *  - 0: vtkPolyData, the surface: closed, facing outwards;
 *  - 1: vtkImageData, the signed distance to it;
 *  - 2: vtkTable, the history of the flow.
 *
 * The flow starts from balls of Enlargement times the radius and runs for EvolutionTime, or until
 * convergence (Steady). The converged surface is the minimal molecular surface, which has the least
 * area around the atoms and is a hull that fills pockets, pores and tunnels. A ProbeRadius adds a
 * second obstacle, the solvent-excluded surface of that probe, which the flow cannot cross: regions
 * that the probe can enter stay open, and the rest is smooth, without the cusps of that surface.
 * Formulas, sources: SurfaceFlow.h.
 *
 * **Which surface.** The term molecular surface usually means the solvent-excluded surface for
 * water (probe 1.4); for electrostatics and for channels set a ProbeRadius of 1.4, or the preset
 * Channel. The default is that of the thesis, without a probe.
 *
 * **Time.** With TimeSteps above 0, the time of the pipeline is that of the flow, and a time slider
 * shows the evolving surface.
 *
 * **Errors** (message, empty outputs): atoms without radii and elements; coordinates or radii that
 * are not finite, negative radii, none above 0; parameters out of range; a grid that does not fit
 * into memory, reported with its size before anything is allocated; a Spacing so large that no node
 * lies inside an atom. Atoms with radius NaN are dropped, with a warning. Without atoms, the
 * outputs are empty and there is no error.
 *
 * **Cost.** The cost of a step is proportional to area / Spacing, the number of steps for a given
 * time to 1 / Spacing^2; a Steady flow takes a few hundred fine steps. Memory: 40 to 50 bytes for
 * each node. The result is bitwise the same on any number of threads. All atoms are needed on one
 * rank.
 */
#ifndef vtkMolecularFlowSurface_h
#define vtkMolecularFlowSurface_h

#include "Atoms/AtomProperties.h"
#include "Core/ArrayProperty.h"
#include "Core/OutputArrays.h"
#include "MolecularSurfaces/SolventProperties.h"
#include "vtkIsthmusFiltersMolecularSurfacesModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the update of its input
#include <vector> // for the table of output arrays

class vtkImageData;
class vtkTable;

namespace isthmus
{
class InputInAdvance;
}

class VTKISTHMUSFILTERSMOLECULARSURFACES_EXPORT vtkMolecularFlowSurface
  : public vtkPolyDataAlgorithm
{
public:
  static vtkMolecularFlowSurface* New();
  vtkTypeMacro(vtkMolecularFlowSurface, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the radii, `Radius` by default.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  enum Presets
  {
    Custom = 0, ///< the properties below
    Fine = 1,   ///< Enlargement 1.3, EvolutionTime 2.5: the thesis' fine surface
    Coarse = 2, ///< Enlargement 2.0, EvolutionTime 2.5: the thesis' coarse surface
    Hull = 3,   ///< Enlargement 1.3, Steady, no probe: the minimal molecular surface
    Channel = 4 ///< Enlargement 1.3, Steady, ProbeRadius 1.4: space that water can enter stays open
  };

  enum Methods
  {
    SignedDistanceFlow = 0, ///< second order in the spacing
    ThesisFlow = 1,         ///< as printed in the thesis, for comparison
    SolventExcluded = 2     ///< no flow: the surface of a probe of ProbeRadius, for comparison
  };

  ///@{
  /// Custom (default): the properties below are used. Any other preset uses its own Enlargement,
  /// EvolutionTime, Steady and ProbeRadius instead of those that are set.
  ISTHMUS_PARAMETER(Preset, int);
  ///@}

  ///@{
  /// Method of computing the surface. Default SignedDistanceFlow.
  ISTHMUS_PARAMETER(Method, int);
  ///@}

  ///@{
  /// The factor eta by which the radii are multiplied at the start of the flow, at least 1. Default
  /// 1.3.
  ISTHMUS_PARAMETER(Enlargement, double);
  ///@}

  ///@{
  /// Evolution time of the flow, in square angstrom, unless Steady. Default 2.5, which corresponds
  /// to the 100 steps of the thesis.
  ISTHMUS_PARAMETER(EvolutionTime, double);
  ///@}

  ///@{
  /// Continue until the surface has converged. Default off.
  ISTHMUS_PARAMETER_SWITCH(Steady);
  ///@}

  ///@{
  /// Radius of the probe that keeps pores and pockets open, in angstrom; 0 (default): none.
  ISTHMUS_PARAMETER(ProbeRadius, double);
  ///@}

  ///@{
  /// Spacing of the grid, in angstrom. Default 0.5.
  ISTHMUS_PARAMETER(Spacing, double);
  ///@}

  ///@{
  /// Distance from the enlarged atoms to the border of the grid, in angstrom. Two spacings are
  /// always kept, so that the surface never touches the border. Default 1.7.
  ISTHMUS_PARAMETER(Padding, double);
  ///@}

  ///@{
  /// Level of S that output 0 shows, between 0 and 1 (exclusive). Larger levels lie further inside:
  /// the offset from the surface of the flow is 1.2 Spacing (1 - 2 Level) outwards. Default 0.5.
  ISTHMUS_PARAMETER(Level, double);
  ///@}

  ///@{
  /// Start a Steady flow on coarser grids, which is many times faster. Default on.
  ISTHMUS_PARAMETER_SWITCH(CoarseToFine);
  ///@}

  ///@{
  /// Include the solvent: pressure and dispersion (thesis 4.9) in addition to the surface tension.
  /// Default off.
  ISTHMUS_PARAMETER_SWITCH(Solvent);
  ///@}

  ///@{
  /// Triangles with no angle below 30 degrees by Delaunay refinement (vtkDelaunayIsosurface)
  /// instead of those of the cells of the grid; takes about ten times as long. Default off.
  ISTHMUS_PARAMETER_SWITCH(DelaunayQuality);
  ///@}

  ///@{
  /// Above 0, at most 10000: the outputs have this number of time steps after the first, from 0 to
  /// EvolutionTime (square angstrom), and are computed for the one that the pipeline requests. Not
  /// used with Steady, or if the atoms have time steps of their own. Default 0.
  ISTHMUS_PARAMETER(TimeSteps, int);
  ///@}

  /// Output 1 and 2.
  vtkImageData* GetImage();
  vtkTable* GetHistory();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// IncludeWaters and UnitedAtoms determine which atoms are used, and their radii; see
  /// AtomProperties.h. Default off and on.
  ISTHMUS_ATOM_PROPERTIES();
  /// SurfaceTension, above 0, is used for Energy and balances the pull of the solvent; Pressure is
  /// used with Solvent on. See SolventProperties.h. Defaults 0.0700 and 0.0464.
  ISTHMUS_SOLVENT_PROPERTIES(Parameters);

protected:
  vtkMolecularFlowSurface();
  ~vtkMolecularFlowSurface() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMolecularFlowSurface(const vtkMolecularFlowSurface&) = delete;
  void operator=(const vtkMolecularFlowSurface&) = delete;

  class vtkInternals; ///< functions of one execution

  isthmus::MolecularFlowParameters Parameters;
  std::unique_ptr<isthmus::InputInAdvance> Advance;
};

#endif
