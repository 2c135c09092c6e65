/**
 * @class vtkMeshQualityReport
 * @brief Angles and radius-edge ratios of triangles or tetrahedra: arrays, histogram, one line.
 *
 * Input: vtkPolyData of triangles or vtkUnstructuredGrid of tetrahedra only.
 *
 * Output 0: the input with cell arrays (double) `SmallestAngle` and `LargestAngle` in degrees (of a
 * triangle; dihedral ones of a tetrahedron), `RadiusEdgeRatio` (circumradius / shortest edge: 0.577
 * for the equilateral triangle, 0.612 for the regular tetrahedron; infinite for cells without area
 * or volume) and, of tetrahedra, `Volume` (signed: positive in VTK's order of the corners), and
 * field data `QualitySummary` (one line) and `QualityMeasures` (smallest angle, largest angle,
 * largest radius-edge ratio, slivers, inverted, named components). A sliver is a tetrahedron with a
 * dihedral angle below 5 degrees, which the radius-edge ratio does not detect. Tetrahedra are
 * inverted if their corners are ordered opposite to those of most of the volume, as where a mesh
 * overlaps itself: a warning names them, and the volume in the summary counts them as negative.
 *
 * Output 1: vtkTable, one row for each of NumberOfBins bins over 0 to 180 degrees: `Angle` (middle
 * of the bin), `Count`, `Fraction` of all angles (three for a triangle, six for a tetrahedron).
 *
 * On several MPI ranks the line and the table describe the cells of all ranks; ghost cells are
 * measured but not counted.
 *
 * vtkMeshQuality gives one measure at a time and no dihedral range. For other cells, there is one
 * error through vtkErrorMacro and the outputs are empty. O(n), in parallel.
 */
#ifndef vtkMeshQualityReport_h
#define vtkMeshQualityReport_h

#include "vtkIsthmusFiltersTetrahedraModule.h"
#include "vtkPassInputTypeAlgorithm.h"

#include <string>

class VTKISTHMUSFILTERSTETRAHEDRA_EXPORT vtkMeshQualityReport : public vtkPassInputTypeAlgorithm
{
public:
  static vtkMeshQualityReport* New();
  vtkTypeMacro(vtkMeshQualityReport, vtkPassInputTypeAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /// Number of bins of the histogram from 0 to 180 degrees.
  vtkSetMacro(NumberOfBins, int);
  vtkGetMacro(NumberOfBins, int);
  ///@}

  /// The summary line of the last update, which is also in the field data of the output.
  vtkGetMacro(Summary, std::string);

protected:
  vtkMeshQualityReport();
  ~vtkMeshQualityReport() override = default;

  int FillInputPortInformation(int port, vtkInformation* information) override;
  int FillOutputPortInformation(int port, vtkInformation* information) override;
  int RequestDataObject(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;
  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector*) override;

private:
  vtkMeshQualityReport(const vtkMeshQualityReport&) = delete;
  void operator=(const vtkMeshQualityReport&) = delete;

  int NumberOfBins = 36;
  std::string Summary;
};

#endif
