/**
 * @class   vtkBindingSites
 * @brief   Finds and ranks likely binding sites: connected patches of large polarized curvature.
 *
 * Input: the output of vtkPolarizedCurvature, or any vtkPolyData with a point array for ranking
 * (input array 0: `PolarizedCurvature`), with classes (input array 1: `SiteClass`) unless Classes
 * is AllPoints, and optionally with a potential for the means (input array 2: `Potential`).
 *
 * **With atoms** on input 1 (points with `Radius`), sites are the pockets of
 * vtkMolecularPockets (its defaults), ranked by their score x the square root of the mean
 * |amplitude| of the surface that lines them. `Area` and `Points` are those of that surface;
 * `MeanDepth` and the center are those of the pocket. This finds ligands far better: see
 * Filters/Pockets/README.md. The following describes patches, without atoms.
 *
 * Points above the threshold that have the same class and are connected by edges form patches;
 * patches of the same class closer than MergeDistance are merged. Each patch has a rank; 1 is the
 * best.
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0, the surface; 1, a table with one row per site.
 * The definitions are in BindingSites.h.
 *
 * **Defaults** were tuned on the eight complexes of Filters/Pockets/BindingSites.md, which reports
 * how well they predict.
 *
 * **Errors** (message, empty outputs): atoms in a different place than the surface
 * (InputOverlap.h); missing arrays; a quantile, threshold, distance or area out of range. If no
 * point is above the threshold (e.g. for a constant array), or if the molecule has no pockets,
 * there is a warning and no site. An empty surface causes neither.
 *
 * **Cost.** O(n log n) for n points, plus 1000 n for the hull, in parallel; bitwise the same on any
 * number of threads. With several MPI ranks, each rank processes only its own piece, so gather the
 * surface first.
 */
#ifndef vtkBindingSites_h
#define vtkBindingSites_h

#include "Core/ArrayProperty.h"
#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Pockets/BindingSites.h"
#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro
#include "vtkPolyDataAlgorithm.h"

#include <vector> // for the table of output arrays

class vtkAlgorithmOutput;
class vtkDataArray;
class vtkPointSet;
class vtkTable;

namespace isthmus
{
struct BindingSiteResult;
struct MoleculeAtoms;
struct SiteFields;
struct SurfaceView;
}

class VTKISTHMUSFILTERSPOCKETS_EXPORT vtkBindingSites : public vtkPolyDataAlgorithm
{
public:
  static vtkBindingSites* New();
  vtkTypeMacro(vtkBindingSites, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// Input array 0 is the point array of the amplitudes, `PolarizedCurvature` by default.
  ISTHMUS_NAMED_INPUT_ARRAYS();

  ///@{
  /// The molecule's atoms, optional: input 1.
  void SetAtomsConnection(vtkAlgorithmOutput* atoms) { this->SetInputConnection(1, atoms); }
  void SetAtomsData(vtkPointSet* atoms);
  ///@}

  ///@{
  /// Whether sites are pockets if there are atoms. Default: on. Off: sites are patches.
  vtkSetMacro(UsePockets, bool);
  vtkGetMacro(UsePockets, bool);
  vtkBooleanMacro(UsePockets, bool);
  ///@}

  enum PointClasses
  {
    Ligands = 0,
    Proteins = 1,
    AllClasses = 2,
    AllPoints = 3
  };

  ///@{
  /// Which points may belong to sites: those of SiteClass 2 and 4 (Ligands, default), 1 and 3
  /// (Proteins), 1 to 4 (AllClasses), or all points as one class, without SiteClass (AllPoints).
  vtkSetMacro(Classes, int);
  vtkGetMacro(Classes, int);
  ///@}

  enum AmplitudeModes
  {
    AbsoluteValue = 0,
    PositivePart = 1,
    NegativePart = 2
  };

  ///@{
  /// Amplitude of a value v of the array: |v| (default), max(v, 0), or max(-v, 0).
  vtkSetMacro(Amplitude, int);
  vtkGetMacro(Amplitude, int);
  ///@}

  ///@{
  /// The fraction of the area that lies at or below the automatic Threshold, in [0, 1). Default:
  /// 0.93.
  ISTHMUS_PARAMETER(Quantile, double);
  ///@}

  ///@{
  /// Distance within which patches of one class are merged, in angstrom. Default: 1; 0: none are
  /// merged.
  ISTHMUS_PARAMETER(MergeDistance, double);
  ///@}

  ///@{
  /// Area below which patches are dropped, in angstrom^2. Default: 5.
  ISTHMUS_PARAMETER(MinimumArea, double);
  ///@}

  enum Rankings
  {
    ByScore = 0,
    ByArea = 1,
    ByMeanDepth = 2,
    ByMeanPotential = 3
  };

  ///@{
  /// Quantity by which sites are ranked, the largest first: Score (default), Area, MeanDepth, or
  /// |MeanPotential|.
  ISTHMUS_PARAMETER(RankBy, int);
  ///@}

  /// Output 1.
  vtkTable* GetSiteTable();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

  /// Amplitude above which points belong to patches, in the array's unit. Automatic unless given:
  /// Quantile of the surface's area.
  ISTHMUS_AUTOMATIC_UNLESS_GIVEN(Threshold);

protected:
  vtkBindingSites();
  ~vtkBindingSites() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  isthmus::BindingSiteOptions Parameters;
  bool UsePockets = true;
  int Classes = Ligands;
  int Amplitude = AbsoluteValue;

private:
  vtkBindingSites(const vtkBindingSites&) = delete;
  void operator=(const vtkBindingSites&) = delete;

  vtkDataArray* Scalar(int index, vtkPolyData* surface, const char* remedy);
  isthmus::SiteFields Fields(vtkPolyData* surface);
  isthmus::BindingSiteResult Patches(vtkPolyData* surface, const isthmus::SurfaceView& triangles);
  isthmus::MoleculeAtoms PrepareAtoms(vtkPointSet* input);
  isthmus::BindingSiteResult Pockets(vtkPolyData* surface, const isthmus::SurfaceView& triangles,
    const isthmus::MoleculeAtoms& atoms);
};

#endif
