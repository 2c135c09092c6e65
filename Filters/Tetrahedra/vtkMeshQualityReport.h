/**
 * @class vtkMeshQualityReport
 * @brief Angles and radius-edge ratios of triangles or tetrahedra: arrays, histogram, one line.
 *
 * Input: vtkPolyData of triangles or vtkUnstructuredGrid of tetrahedra only.
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0, the input with measures of its cells and a
 * summary; 1, vtkTable, one row for each of NumberOfBins bins over 0 to 180 degrees: the histogram
 * of all angles (three for a triangle, six for a tetrahedron).
 *
 * A sliver is a tetrahedron with a dihedral angle below 5 degrees, which the radius-edge ratio does
 * not detect. Inverted are tetrahedra whose corners are ordered opposite to those of most of the
 * volume, as where a mesh overlaps itself: a warning names them, and the volume in the summary
 * counts them as negative.
 *
 * On several MPI ranks the line and the table describe the cells of all ranks; ghost cells are
 * measured but not counted.
 *
 * vtkMeshQuality gives one measure at a time and no dihedral range. For other cells, there is one
 * error through vtkErrorMacro and the outputs are empty. O(n), in parallel.
 */
#ifndef vtkMeshQualityReport_h
#define vtkMeshQualityReport_h

#include "Core/OutputArrays.h"
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

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

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
