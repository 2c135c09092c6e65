/**
 * @class   vtkMolecularDensity
 * @brief   atoms as a volume: union of balls, or a smooth sum of Gaussians
 *
 * Input: the atoms, any vtkPointSet whose point array `Radius` (or the one chosen with
 * SetInputArrayToProcess) holds radii in the unit of the points (angstrom), e.g. from
 * vtkMacromoleculeReader. Without that array, radii are assigned by element (array `Element`;
 * AtomRadii.h). Output: vtkImageData around the atoms with the arrays of OutputArrayTable().
 *
 * With radii R_i = RadiusScale x radius,
 *
 *  - UnionOfBalls: 1 within a distance of R_i of an atom, else 0;
 *  - GaussianSum (default): sum of exp(-Decay (|x - x_i|^2 / R_i^2 - 1)).
 *
 * **Surface.** Contour at 1 (GaussianSum) or 0.5 (UnionOfBalls): the first encloses all balls and
 * is smooth, the second has the steps of the grid. Decay 2.3 gives a surface near the
 * solvent-excluded one; smaller values close more crevices. Formulas and sources:
 * MolecularDensity.h.
 *
 * The grid has cubic cells; its first node lies Padding beyond the outermost ball. The whole grid
 * is produced for any requested part. Atoms without radius (NaN) are dropped, with a warning; atoms
 * with radius 0 have no effect. If the atoms move in time, the grid of a later time step has at
 * least as many nodes along each axis as that of the first one.
 *
 * **Errors** (one message, empty output): neither radii nor elements; negative radii, coordinates
 * that are not finite; a Spacing that is not positive or so small that the grid does not fit into
 * memory. Without atoms, the image is empty and there is no error.
 *
 * **Cost.** Linear in atoms and nodes, in parallel. Memory: 4 bytes for each node and about 100
 * bytes for each atom. The result is bitwise the same on any number of threads and for any order of
 * the atoms. On several MPI ranks, each rank computes the density of its own atoms: gather the
 * atoms first.
 */
#ifndef vtkMolecularDensity_h
#define vtkMolecularDensity_h

#include "Core/ArrayProperty.h"
#include "Core/OutputArrays.h"
#include "vtkImageAlgorithm.h"
#include "vtkIsthmusFiltersAtomsModule.h" // for the export macro

#include <memory> // to update its input in RequestInformation

class vtkPointSet;

namespace isthmus
{
class InputInAdvance;
}

class VTKISTHMUSFILTERSATOMS_EXPORT vtkMolecularDensity : public vtkImageAlgorithm
{
public:
  static vtkMolecularDensity* New();
  vtkTypeMacro(vtkMolecularDensity, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the radii, `Radius` by default.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  enum Forms
  {
    UnionOfBalls = 0,
    GaussianSum = 1
  };

  ///@{
  /// UnionOfBalls or GaussianSum (default).
  vtkSetMacro(Form, int);
  vtkGetMacro(Form, int);
  ///@}

  ///@{
  /// The factor eta by which all radii are multiplied. Default 1.
  vtkSetMacro(RadiusScale, double);
  vtkGetMacro(RadiusScale, double);
  ///@}

  ///@{
  /// How fast a Gaussian falls off, no unit, above 0, up to 500. Default 2.3.
  vtkSetMacro(Decay, double);
  vtkGetMacro(Decay, double);
  ///@}

  ///@{
  /// Spacing of the grid, in the unit of the points. Default 0.5.
  vtkSetMacro(Spacing, double);
  vtkGetMacro(Spacing, double);
  ///@}

  ///@{
  /// Distance between the outermost ball and the border of the grid, along x, y, z, in the unit of
  /// the points. Default 3 each, so that the surface at level 1 is closed.
  vtkSetVector3Macro(Padding, double);
  vtkGetVector3Macro(Padding, double);
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkMolecularDensity();
  ~vtkMolecularDensity() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkMolecularDensity(const vtkMolecularDensity&) = delete;
  void operator=(const vtkMolecularDensity&) = delete;

  void FillImage(vtkPointSet* atoms, vtkInformation* outInfo, vtkImageData* output);

  int Form = GaussianSum;
  double RadiusScale = 1.0;
  double Decay = 2.3;
  double Spacing = 0.5;
  double Padding[3] = { 3.0, 3.0, 3.0 };
  std::unique_ptr<isthmus::InputInAdvance> Advance;
};

#endif
