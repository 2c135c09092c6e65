/**
 * @class   vtkFeatureTracks
 * @brief   Tracks pockets, pores or choke points through time.
 *
 * Input 0: features at each time step, from a pipeline with time (e.g. a molecule with several
 * models): a table with CenterX, CenterY, CenterZ (the Ranking of vtkMolecularPockets) or
 * BottleneckX, ... (the Pores of vtkPoreProfile), points (bottlenecks, choke points), or cells or
 * points grouped by an array PocketId, PoreId or FeatureId (the pockets, mouths or alpha balls of
 * vtkMolecularPockets, the lines of vtkPoreProfile, the loops of vtkChokingLoops); the rules are in
 * FeatureInput.h. The columns or arrays `Radius`, `Volume` and `Score` are passed on if they exist.
 * Input 1 (optional): the lining residues of the same filter, which make the matching reliable
 * where features are crowded.
 *
 * The filter requests all time steps, one after the other. FeatureTracks.h has the definitions.
 *
 * Outputs, whose arrays OutputArrayTable() lists: 0, vtkTable, one row per feature and time (no
 * track changes the kind or side of a choking loop); 1, vtkTable for charts, one row per time with
 * a column for each track, the longest first; 2, vtkPolyData, one polyline per track; 3, vtkTable,
 * merges and splits.
 *
 * **Errors** (message, empty outputs): an input without positions, options out of range. Without
 * time steps, each feature is a track.
 */
#ifndef vtkFeatureTracks_h
#define vtkFeatureTracks_h

#include "Core/FilterProperties.h"
#include "Core/OutputArrays.h"
#include "Pockets/FeatureTracks.h"
#include "vtkIsthmusFiltersPocketsModule.h" // for the export macro
#include "vtkTableAlgorithm.h"

#include <memory> // for the collected time steps

class vtkAlgorithmOutput;
class vtkPolyData;

namespace isthmus
{
struct TrackedData;
}

class VTKISTHMUSFILTERSPOCKETS_EXPORT vtkFeatureTracks : public vtkTableAlgorithm
{
public:
  static vtkFeatureTracks* New();
  vtkTypeMacro(vtkFeatureTracks, vtkTableAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /// The lining residues, optional: input 1.
  void SetLiningConnection(vtkAlgorithmOutput* table) { this->SetInputConnection(1, table); }

  ///@{
  /// Largest distance that a feature moves from one time step to the next. Default: 4 angstrom.
  ISTHMUS_PARAMETER(MaximumDistance, double);
  ///@}

  ///@{
  /// Number of time steps that a track may miss. Default: 25.
  ISTHMUS_PARAMETER(MaximumGap, int);
  ///@}

  enum ChartedValues
  {
    Radius = 0,
    Volume = 1,
    Score = 2
  };

  ///@{
  /// Quantity of each track in output 1. Default: Radius.
  vtkSetMacro(Charted, int);
  vtkGetMacro(Charted, int);
  ///@}

  ///@{
  /// Tracks with fewer features are omitted from outputs 1 and 2. Default: 1.
  vtkSetMacro(MinimumLength, int);
  vtkGetMacro(MinimumLength, int);
  ///@}

  vtkTable* GetChart();
  vtkPolyData* GetPaths();
  vtkTable* GetEvents();

  /// The arrays that the filter adds to its outputs.
  static const std::vector<isthmus::OutputArray>& OutputArrayTable();

protected:
  vtkFeatureTracks();
  ~vtkFeatureTracks() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkFeatureTracks(const vtkFeatureTracks&) = delete;
  void operator=(const vtkFeatureTracks&) = delete;

  void Finish(vtkInformationVector* outputs);

  std::unique_ptr<isthmus::TrackedData> Collected; ///< of the time steps so far
  isthmus::TrackOptions Parameters;
  int Charted = Radius;
  int MinimumLength = 1;
};

#endif
