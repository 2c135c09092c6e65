/**
 * @class   vtkSurfaceMeasures
 * @brief   area, enclosed volume, genus and components of a surface, or of a level of a volume
 *
 * The input, a vtkPolyData or a vtkImageData, is passed on with its measures as field data; output
 * 1 is a vtkTable of the same. Lengths are in the unit of the data, angstrom for molecular data.
 *
 * The measures and columns are those of OutputArrayTable(); the table has a row for the whole
 * (`Component` -1) and one for each component.
 *
 * **Surface**: polygons and strips are split into triangles; vertices and lines are ignored.
 * Triangles that share a point are one component. `Volume` is positive where triangles are
 * counter-clockwise seen from outside, and the volume of cavities is subtracted. Cracks between
 * facets, flipped patches, and cavities that face the same way as the shell around them are
 * corrected first, with a warning (SurfaceCorrection.h). `Volume` is NaN, with a warning, if the
 * surface does not enclose a volume, or if closed components cross each other (ShellCrossings.h);
 * the volumes of the components are then those of each component alone. `Genus` is -1, with a
 * warning, if the surface has irregular points.
 *
 * A component that passes through itself is reported by a warning with a place; parts that it
 * encloses twice count twice.
 *
 * `AreaError` and `VolumeError` take the mesh as samples of a smooth surface, as meshes of maps
 * are: they estimate how far the measures are from those of that surface (ChordError.h). Edges
 * sharper than 60 degrees count as sharp. A mesh that is meant as it is, such as a CAD part, has
 * none of these errors.
 *
 * **Image**: four measures of the isosurface at Level of its scalars: the sharp Area and Volume
 * with estimates of their errors (CartesianMeasures.h), and SmearedArea and SmearedVolume of the
 * scalars scaled to 0 outside and 1 inside. A warning says if the level reaches the border. Float
 * and double are used as they are, other types as a copy in double.
 *
 * Formulas and sources: SurfaceMeasures.h, CartesianMeasures.h.
 *
 * **Errors** (one message, empty output): coordinates or scalars that are not finite, damaged
 * cells, no point scalars or several components, equal InsideValue and OutsideValue. Empty input is
 * not an error.
 *
 * **Cost.** Surfaces take O(triangles), with 150 bytes for each; images take O(nodes), with an
 * eighth of their memory. On several MPI ranks, each measures its own piece: gather the surface
 * first (in ParaView: Aggregate Dataset).
 */
#ifndef vtkSurfaceMeasures_h
#define vtkSurfaceMeasures_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersSurfacesModule.h" // for the export macro
#include "vtkPassInputTypeAlgorithm.h"

#include <vector> // for the table of output arrays

class vtkImageData;
class vtkPolyData;
class vtkTable;

class VTKISTHMUSFILTERSSURFACES_EXPORT vtkSurfaceMeasures : public vtkPassInputTypeAlgorithm
{
public:
  static vtkSurfaceMeasures* New();
  vtkTypeMacro(vtkSurfaceMeasures, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Level of the image's scalars that is measured, in their unit.
  vtkSetMacro(Level, double);
  vtkGetMacro(Level, double);
  ///@}

  ///@{
  /// Whether the scalars are higher inside (on: densities) or lower (off: distances).
  vtkSetMacro(InsideIsHigher, bool);
  vtkGetMacro(InsideIsHigher, bool);
  vtkBooleanMacro(InsideIsHigher, bool);
  ///@}

  ///@{
  /// Scalars deep inside and far outside, in their unit; the smeared measures scale them to 1 and
  /// 0.
  vtkSetMacro(InsideValue, double);
  vtkGetMacro(InsideValue, double);
  vtkSetMacro(OutsideValue, double);
  vtkGetMacro(OutsideValue, double);
  ///@}

  /// Output 1.
  vtkTable* GetTable();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkSurfaceMeasures();
  ~vtkSurfaceMeasures() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestDataObject(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Level = 0.5;
  bool InsideIsHigher = true;
  double InsideValue = 1.0;
  double OutsideValue = 0.0;

private:
  vtkSurfaceMeasures(const vtkSurfaceMeasures&) = delete;
  void operator=(const vtkSurfaceMeasures&) = delete;

  void Measure(vtkPolyData* surface, vtkDataObject* output, vtkTable* table);
  void Measure(vtkImageData* image, vtkDataObject* output, vtkTable* table);
};

#endif
