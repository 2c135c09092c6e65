/**
 * @class   vtkFullereneStability
 * @brief   rings and cages of molecules as balls grow around their atoms
 *
 * Input: one or more molecules, each a vtkPointSet (Macromolecule Reader, XYZ) or a vtkMolecule;
 * only the positions of the atoms count (and `Radius`, with ScaleByRadius). Blocks of a composite
 * data set are handled one by one.
 *
 * Balls of equal radius grow around the atoms. When the radius is half the length of a bond, its
 * two balls are joined. A ring of bonds closes at this radius and is filled at about its
 * circumradius; a cage is closed by its last ring and is filled when its cavity is. The bars are
 * the intervals from closing to filling.
 *
 * Outputs (vtkTable), whose columns OutputArrayTable() lists: 0, a row for each molecule; 1, the
 * bars, longest first in each dimension. Lengths are in the unit of the points (angstrom).
 *
 * **How far to trust it.** Among isomers of one size, FilteredIntegral correlates with the energy
 * of the same geometry, but the number of adjacent pentagons correlates better. Between sizes,
 * EnergyProxy mostly follows 1 / Atoms.
 *
 * **Errors** (one message, empty output): coordinates that are not finite; parameters that are not
 * positive lengths; missing radii if ScaleByRadius needs them. Without atoms, the table is empty
 * and there is no error.
 *
 * Exact (default): the alpha complex. Grid: as in the thesis, the cubical complex of the distance
 * with grid spacing Spacing up to Theta, a first-order approximation. Method: FullereneStability.h.
 */
#ifndef vtkFullereneStability_h
#define vtkFullereneStability_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Persistence/FullereneStability.h"
#include "vtkIsthmusFiltersPersistenceModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

#include <vector>

namespace isthmus
{
struct DistanceBar;
struct FullereneStability;
}

class VTKISTHMUSFILTERSPERSISTENCE_EXPORT vtkFullereneStability : public vtkTableAlgorithm
{
public:
  static vtkFullereneStability* New();
  vtkTypeMacro(vtkFullereneStability, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum Methods
  {
    Exact = 0,
    Grid = 1
  };

  ///@{
  /// Exact (default) or Grid.
  ISTHMUS_PARAMETER(Method, int);
  ///@}

  ///@{
  /// Shortest bar that counts, in the unit of the points; at least 0. Default 0.2.
  ISTHMUS_PARAMETER(FilterDelta, double);
  ///@}

  ///@{
  /// Largest distance computed on the grid, in the unit of the points. Bars that reach it end there
  /// and count even if they are short. Default 2. Not used by Exact.
  ISTHMUS_PARAMETER(Theta, double);
  ///@}

  ///@{
  /// Spacing of the grid, in the unit of the points. Default 0.2. Not used by Exact.
  ISTHMUS_PARAMETER(Spacing, double);
  ///@}

  ///@{
  /// Compute distances on the grid by fast marching (first order, as in the thesis) instead of
  /// exactly. Default off. Not used by Exact.
  ISTHMUS_PARAMETER_SWITCH(FastMarching);
  ///@}

  ///@{
  /// Grow each ball in proportion to the radius of its atom (point array `Radius`): distances are
  /// then in units of it. Grid only. Default off.
  ISTHMUS_PARAMETER_SWITCH(ScaleByRadius);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkFullereneStability();
  ~vtkFullereneStability() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkFullereneStability(const vtkFullereneStability&) = delete;
  void operator=(const vtkFullereneStability&) = delete;

  /// The row of a molecule, without atoms for an empty one, and its bars.
  isthmus::FullereneStability Analyse(
    vtkDataObject* input, std::vector<isthmus::DistanceBar>& bars);

  isthmus::StabilityParameters Parameters;
};

#endif
