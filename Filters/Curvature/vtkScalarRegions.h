/**
 * @class   vtkScalarRegions
 * @brief   Divides a surface into regions between thresholds of one or two scalars: labels, areas,
 * tables.
 *
 * Input: a vtkPolyData with a point array of one component (input array 0) and, with
 * UseSecondScalar, another (input array 1), for example a curvature and the potential. n thresholds
 * define n + 1 regions: region 0 is below the first threshold, region i is [threshold i, threshold
 * i + 1), and region n is from the last threshold upwards.
 *
 * Outputs, whose arrays OutputArrayTable() lists:
 *  - 0, the surface with labels on points and cells; `Region` becomes the active scalars;
 *  - 1, table with one row per region and its area; with a second scalar also the joint areas, in a
 *    column for each of its regions;
 *  - 2, table of a threshold sweep (with SweepSteps): the lowest threshold moves to SweepTarget,
 *    then the highest one;
 *  - 3, histogram of the first scalar by area, with HistogramBins bins from its lowest to its
 *    highest value on the surface.
 *
 * Polygons and strips are split into triangles for the areas. Rules and sources are in
 * ScalarRegions.h.
 *
 * **Errors** (one message, empty outputs): missing arrays, thresholds that are not ascending,
 * scalars that are not finite, a SweepTarget that is not between the thresholds. An empty surface
 * is not an error.
 *
 * **Cost.** O(triangles x regions per triangle), in parallel, bitwise the same on any number of
 * threads. With several MPI ranks, each sums its own piece, so gather the surface first (in
 * ParaView: Aggregate Dataset).
 */
#ifndef vtkScalarRegions_h
#define vtkScalarRegions_h

#include "Core/OutputArrays.h"
#include "vtkIsthmusFiltersCurvatureModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for the thresholds

namespace isthmus
{
struct SurfaceView;
struct ThresholdedScalar;
}

class vtkTable;

class VTKISTHMUSFILTERSCURVATURE_EXPORT vtkScalarRegions : public vtkPolyDataAlgorithm
{
public:
  static vtkScalarRegions* New();
  vtkTypeMacro(vtkScalarRegions, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{ Thresholds of the first scalar, ascending, in its unit. Setting a threshold beyond the last
  /// one extends the list; getting one there
  /// returns 0.
  void SetNumberOfThresholds(int number);
  int GetNumberOfThresholds() const { return static_cast<int>(this->Thresholds.size()); }
  void SetThreshold(int index, double value);
  double GetThreshold(int index) const { return At(this->Thresholds, index); }
  ///@}

  ///@{
  /// Thresholds of the second scalar, ascending, in its unit.
  void SetNumberOfSecondThresholds(int number);
  int GetNumberOfSecondThresholds() const
  {
    return static_cast<int>(this->SecondThresholds.size());
  }
  void SetSecondThreshold(int index, double value);
  double GetSecondThreshold(int index) const { return At(this->SecondThresholds, index); }
  ///@}

  ///@{
  /// Whether regions of a second scalar cross those of the first.
  vtkSetMacro(UseSecondScalar, bool);
  vtkGetMacro(UseSecondScalar, bool);
  vtkBooleanMacro(UseSecondScalar, bool);
  ///@}

  enum AreaRules
  {
    Fractional = 0,
    WholeTriangles = 1
  };

  ///@{ How triangles across a threshold are counted: Fractional (cut along it) or
  /// WholeTriangles (faster: in the region of two of the three corners).
  vtkSetMacro(AreaRule, int);
  vtkGetMacro(AreaRule, int);
  ///@}

  ///@{ Number of steps in which each of the outer thresholds moves to SweepTarget. 0: no
  /// sweep.
  vtkSetMacro(SweepSteps, int);
  vtkGetMacro(SweepSteps, int);
  ///@}

  ///@{
  /// Value at which a sweep ends, between the outer thresholds, in the scalar's unit.
  vtkSetMacro(SweepTarget, double);
  vtkGetMacro(SweepTarget, double);
  ///@}

  ///@{
  /// Number of bins of the histogram.
  vtkSetMacro(HistogramBins, int);
  vtkGetMacro(HistogramBins, int);
  ///@}

  ///@{
  /// Outputs 1, 2 and 3.
  vtkTable* GetRegionTable() { return this->TableAt(1); }
  vtkTable* GetSweepTable() { return this->TableAt(2); }
  vtkTable* GetHistogram() { return this->TableAt(3); }
  ///@}

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkScalarRegions();
  ~vtkScalarRegions() override = default;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::vector<double> Thresholds{ -0.1, 0.1 };
  std::vector<double> SecondThresholds{ -1.0, 2.0 };
  bool UseSecondScalar = false;
  int AreaRule = Fractional;
  int SweepSteps = 0;
  double SweepTarget = 0.0;
  int HistogramBins = 32;

private:
  vtkScalarRegions(const vtkScalarRegions&) = delete;
  void operator=(const vtkScalarRegions&) = delete;

  static double At(const std::vector<double>& values, int index);
  void Put(std::vector<double>& values, int index, double value);
  void Resize(std::vector<double>& values, int number);
  vtkTable* TableAt(int port);
  isthmus::ThresholdedScalar Scalar(int index, vtkPolyData* input, std::string& name);
  void Compute(vtkPolyData* input, vtkPolyData* output);
};

#endif
