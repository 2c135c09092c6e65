/**
 * @class vtkMapChokingLoops
 * @brief A density map in, its choking loops out: contour, closed and clean, then vtkChokingLoops.
 *
 * Input: vtkImageData with one-component point scalars of any number type, any spacing, origin and
 * direction. Values that are not numbers count as outside.
 *
 * Outputs 0 to 3 are those of vtkChokingLoops, whose parameters this filter has, too; output 4 is
 * the surface, as vtkMapSurface makes it at the same level: closed half a cell beyond the map where
 * the level leaves it. Radii are in the unit of the map, angstrom. Field data of output 0 has the
 * `Level`.
 *
 * Level has to be given: a finite number between the least and the greatest value of the map.
 * vtkMapSurface proposes one. The contour and the analysis are kept: thresholds, side and
 * shortening are answered from them.
 *
 * Errors (sentence, empty outputs): those of vtkChokingLoops; no level, or one that nothing is
 * inside of. Cost: that of vtkMapSurface and vtkChokingLoops. On several MPI ranks the first one
 * does everything. CapHoles, Filtration and MorseFunction have no meaning here and are left alone.
 *
 * @sa vtkMapSurface vtkChokingLoops vtkMapHandles
 */
#ifndef vtkMapChokingLoops_h
#define vtkMapChokingLoops_h

#include "vtkChokingLoops.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"
#include "vtkSmartPointer.h"

#include <limits>
#include <memory>

class vtkImageData;

class VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT vtkMapChokingLoops : public vtkChokingLoops
{
public:
  static vtkMapChokingLoops* New();
  vtkTypeMacro(vtkMapChokingLoops, vtkChokingLoops);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Value of the level set, in the unit of the scalars. Default: none, not a number.
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
  /// Keep that many components of the surface, those of the largest area; 0 (default): all.
  vtkSetClampMacro(LargestComponents, int, 0, VTK_INT_MAX);
  vtkGetMacro(LargestComponents, int);
  ///@}

protected:
  vtkMapChokingLoops();
  ~vtkMapChokingLoops() override;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkMapChokingLoops(const vtkMapChokingLoops&) = delete;
  void operator=(const vtkMapChokingLoops&) = delete;

  void Contour(vtkImageData* image);

  double Level = std::numeric_limits<double>::quiet_NaN();
  bool InsideIsHigher = true;
  int LargestComponents = 0;

  struct Key;
  std::unique_ptr<Key> MadeOf; ///< the surface of the last run
  vtkSmartPointer<vtkPolyData> Surface;
};

#endif
