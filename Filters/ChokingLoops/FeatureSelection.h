/**
 * @file FeatureSelection.h
 * @brief Which features of a diagram are reported, and the threshold that a diagram proposes.
 */
#ifndef isthmus_FeatureSelection_h
#define isthmus_FeatureSelection_h

#include "ChokingLoops/FeatureDiagram.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

/// A length as the user states it: in percent of a side's reference length, or in units of the
/// data.
struct StatedLength
{
  double Value = 0.0;
  bool Percent = true;

  double Of(double reference) const
  {
    return this->Percent ? 0.01 * this->Value * reference : this->Value;
  }
};

/// Where additional features part from noise.
enum class ThresholdMode
{
  Given,     ///< at FeatureSelection::MinimumPersistence
  LargestGap ///< at the largest gap of each side's diagram
};

/// Which features to report.
struct FeatureSelection
{
  bool Inside = true;
  bool Outside = true;
  StatedLength MaximumDistance{ 100.0, true };
  StatedLength MinimumPersistence{ 5.0, true };
  ThresholdMode Threshold = ThresholdMode::Given;
  /// Handles and tunnels need not obey MaximumDistance. MinimumPersistence is never asked of them:
  /// in a ring of even width nothing widens behind the narrowing, and yet it is a handle.
  bool AlwaysReportHandles = true;
  /// Keep the features behind which the space widens most; 0: all of them.
  std::size_t MaximumNumber = 0;
};

/// A gap between neighbours of the bars of one side, in the unit of the points.
struct PersistenceGap
{
  double Threshold = 0.0; ///< its middle: persistences above it count
  double Width = 0.0;     ///< 0: there is none
};

/**
 * The largest gap of one side's additional features: their persistences in descending order, 0
 * behind the last, and the two neighbours whose difference is largest. One narrower than a
 * hundredth of the side's reference length is none; the threshold is that hundredth then.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT PersistenceGap LargestGap(
  const FeatureDiagram& diagram, SpaceSide side);

/// Indices of the features of a selection, ascending by Distance(). O(n log n).
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<std::size_t> SelectFeatures(
  const FeatureDiagram& diagram, const FeatureSelection& selection);

}

#endif
