/**
 * @file ScalarFeatures.h
 * @brief The classes of a volume as numbered features, longest first, and their Betti curves.
 */
#ifndef isthmus_ScalarFeatures_h
#define isthmus_ScalarFeatures_h

#include "Persistence/CubicalDiagram.h"
#include "Persistence/VolumeView.h"
#include "vtkIsthmusFiltersPersistenceModule.h"

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

namespace isthmus
{

/// The features that count.
struct FeatureParameters
{
  enum Unit
  {
    Absolute,           ///< MinimumPersistence is a difference of values
    StandardDeviations, ///< ... in standard deviations of the volume
    LargestGap          ///< MinimumPersistence is not used: features above the widest gap are kept
  };

  bool Superlevel = false;
  /// Only features that exist between these levels are considered; the length of a bar is that of
  /// its part between them.
  std::array<double, 2> Range{ -std::numeric_limits<double>::infinity(),
    std::numeric_limits<double>::infinity() };
  double MinimumPersistence = 0.0;
  int PersistenceUnit = Absolute;
};

/// @throws std::invalid_argument with property, value and range.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT void Check(const FeatureParameters& parameters);

struct ScalarFeature
{
  CubicalPair Pair;
  double Birth = 0.0;
  double Death = 0.0; ///< infinite (-infinite for superlevels) where it never ends
  /// Length of the part in the range; infinite for the class that never ends.
  double Persistence = 0.0;
  /// Number of the feature it is joined to when it ends; -1: none, or the outside.
  std::int64_t Joined = -1;
};

struct FeatureList
{
  /// Sorted by length, longest first, with ties by dimension and position. The index in this list
  /// is the FeatureId, which does not change with the threshold.
  std::vector<ScalarFeature> Features;
  double Threshold = 0.0; ///< smallest persistence of kept features, in units of the values
  std::size_t Kept = 0;   ///< number of features with at least this persistence
};

/// Throws as Check() does.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT FeatureList ScalarFeatures(const VolumeView& volume,
  const VolumeStatistics& statistics, const CubicalDiagram& diagram,
  const FeatureParameters& parameters);

/// Betti numbers by level. The integrals start at the first level (for superlevels, the last) and
/// are exact, not sums over the levels.
struct BettiCurves
{
  std::vector<double> Levels; ///< ascending
  std::array<std::vector<std::int64_t>, 3> All;
  std::array<std::vector<std::int64_t>, 3> Filtered;
  std::array<std::vector<double>, 3> Integral;
  std::array<std::vector<double>, 3> FilteredIntegral;
};

/// Cost: O((features + levels) log levels).
VTKISTHMUSFILTERSPERSISTENCE_EXPORT BettiCurves CountBetti(
  const FeatureList& features, bool superlevel, const std::vector<double>& levels);

/// Throws std::invalid_argument unless there are from 2 to a million levels and the first of two
/// finite ends of the range is below the second; null: no range.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT void RequireLevels(std::int64_t count, const double* range);

/// `count` levels from `low` to `high`, both included exactly; one where they are equal.
VTKISTHMUSFILTERSPERSISTENCE_EXPORT std::vector<double> EvenLevels(
  double low, double high, std::int64_t count);

}

#endif
