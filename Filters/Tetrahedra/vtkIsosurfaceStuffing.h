/**
 * @class vtkIsosurfaceStuffing
 * @brief Tetrahedra of bounded dihedral angles inside, outside or on both sides of a level set.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction (a density, or a signed distance with InsideIsHigher off). The level set is that of the
 * trilinear interpolation; where it leaves the volume it is closed within one layer of cells.
 *
 * Output: vtkUnstructuredGrid of tetrahedra with the arrays of OutputArrayTable(). With Both, the
 * two sides share the points and triangles of the level set and fill the box (the bounds of the
 * volume and at least four more layers of cells), which a Poisson solver needs. All dihedral angles
 * are from 10.7 to 164.8 degrees, even in a graded mesh. Field data of the input are kept.
 *
 * Source: F. Labelle, J. R. Shewchuk, doi:10.1145/1276377.1276448. Second order in CellSize. Cost:
 * see IsosurfaceStuffing.h. On failure, there is one error through vtkErrorMacro and the output is
 * empty. The whole volume is needed on one rank.
 */
#ifndef vtkIsosurfaceStuffing_h
#define vtkIsosurfaceStuffing_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Tetrahedra/IsosurfaceStuffing.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

class VTKISTHMUSFILTERSTETRAHEDRA_EXPORT vtkIsosurfaceStuffing : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkIsosurfaceStuffing* New();
  vtkTypeMacro(vtkIsosurfaceStuffing, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  enum SideType
  {
    Inside,
    Outside,
    Both
  };

  ///@{
  /// The inside is where the value is above the level (densities).
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Inside: fill the inside of the level set; Outside: fill the rest of the box; Both: fill both.
  ///
  ISTHMUS_PARAMETER(Side, int);
  ///@}

  ///@{
  /// Side of the cubes of the lattice, in the unit of the spacing; 0: the smallest spacing. Most
  /// edges have about this length.
  ISTHMUS_PARAMETER(CellSize, double);
  ///@}

  ///@{
  /// Away from the level set cubes may grow to 2^GradingLevels times CellSize, 0 to 8; 0: uniform.
  ///
  ISTHMUS_PARAMETER(GradingLevels, int);
  ///@}

  ///@{
  /// Memory limit in MiB; 0: three quarters of the machine's memory. A larger lattice
  /// ends in an error before it is allocated.
  vtkSetMacro(MemoryLimit, int);
  vtkGetMacro(MemoryLimit, int);
  ///@}

  /// Value of the level set, in the unit of the scalars; unless it is given, the policy is that
  /// of AutomaticLevel.h.
  ISTHMUS_AUTOMATIC_UNLESS_GIVEN(Level);

protected:
  vtkIsosurfaceStuffing();
  ~vtkIsosurfaceStuffing() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIsosurfaceStuffing(const vtkIsosurfaceStuffing&) = delete;
  void operator=(const vtkIsosurfaceStuffing&) = delete;

  isthmus::StuffingParameters Parameters;
  bool InsideIsHigher = true;
  int MemoryLimit = 0;
};

#endif
