/**
 * @class vtkIsosurfaceStuffing
 * @brief Tetrahedra of bounded dihedral angles inside, outside or on both sides of a level set.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction (a density, or a signed distance with InsideIsHigher off). The level set is that of the
 * trilinear interpolation; where it leaves the volume it is closed within one layer of cells.
 *
 * Output: vtkUnstructuredGrid of tetrahedra. Cell array `RegionId` (int): 1 inside, 0 outside.
 * Point array `OnSurface` (unsigned char): 1 on the level set. With Both, the two sides share the
 * points and triangles of the level set and fill the box (the bounds of the volume and at least
 * four more layers of cells), which a Poisson solver needs. All dihedral angles are from 10.7 to
 * 164.8 degrees, even in a graded mesh. Field data of the input are kept; the field array
 * `KeptPoints` (vtkIdType) counts the places where the level set turned within a cell
 * (IsosurfaceStuffing.h).
 *
 * Source: F. Labelle, J. R. Shewchuk, doi:10.1145/1276377.1276448. Second order in CellSize. Cost:
 * see IsosurfaceStuffing.h. On failure, there is one error through vtkErrorMacro and the output is
 * empty. The whole volume is needed on one rank.
 */
#ifndef vtkIsosurfaceStuffing_h
#define vtkIsosurfaceStuffing_h

#include "Core/Deprecation.h"
#include "vtkIsthmusFiltersTetrahedraModule.h"
#include "vtkUnstructuredGridAlgorithm.h"

class VTKISTHMUSFILTERSTETRAHEDRA_EXPORT vtkIsosurfaceStuffing : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkIsosurfaceStuffing* New();
  vtkTypeMacro(vtkIsosurfaceStuffing, vtkUnstructuredGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum SideType
  {
    Inside,
    Outside,
    Both,
    INSIDE ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Inside") = Inside,
    OUTSIDE ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Outside") = Outside,
    BOTH ISTHMUS_DEPRECATED_ENUMERATOR("1.0.0", "use Both") = Both
  };

  ///@{
  /// Value of the level set, in the unit of the scalars. Default 0.
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /// The inside is where the value is above the level (densities). Default on.
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Inside: fill the inside of the level set; Outside: fill the rest of the box; Both: fill both.
  /// Default Inside.
  vtkSetClampMacro(Side, int, Inside, Both);
  vtkGetMacro(Side, int);
  ///@}

  ///@{
  /// Side of the cubes of the lattice, in the unit of the spacing; 0: the smallest spacing. Most
  /// edges have about this length. Default 0.
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /// Away from the level set cubes may grow to 2^GradingLevels times CellSize, 0 to 8; 0: uniform.
  /// Default 0.
  vtkSetMacro(GradingLevels, int);
  vtkGetMacro(GradingLevels, int);
  ///@}

  ///@{
  /// Memory for the values on the lattice, in MiB; a larger lattice is refused. 0: three quarters
  /// of the machine's memory. Default 0.
  vtkSetClampMacro(MemoryLimit, int, 0, VTK_INT_MAX);
  vtkGetMacro(MemoryLimit, int);
  ///@}

protected:
  vtkIsosurfaceStuffing();
  ~vtkIsosurfaceStuffing() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkIsosurfaceStuffing(const vtkIsosurfaceStuffing&) = delete;
  void operator=(const vtkIsosurfaceStuffing&) = delete;

  double Level = 0.0;
  bool InsideIsHigher = true;
  int Side = Inside;
  double CellSize = 0.0;
  int GradingLevels = 0;
  int MemoryLimit = 0;
};

#endif
