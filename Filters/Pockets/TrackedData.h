/**
 * @file TrackedData.h
 * @brief Collects features from VTK data, time step by time step, and writes their tracks as VTK
 * data.
 */
#ifndef isthmus_TrackedData_h
#define isthmus_TrackedData_h

#include "Pockets/FeatureTracks.h"

#include <array>
#include <cstdint>

class vtkDataObject;
class vtkPolyData;
class vtkTable;

namespace isthmus
{

/// Features of all time steps so far, with the values passed on: Radius, Volume, Score.
struct TrackedData
{
  std::vector<double> Times; ///< empty: no time steps
  std::vector<TrackFrame> Frames;
  std::vector<std::vector<std::array<double, 3>>> Values;
  std::vector<std::vector<std::int64_t>> Numbers; ///< numbers of the features in the input

  /// One feature of one frame.
  struct Place
  {
    std::size_t Frame;
    std::size_t Feature;
  };
  using Tracks = std::vector<std::vector<Place>>;

  /// Adds a frame (FeatureInput.h).
  void Add(vtkDataObject* features, vtkTable* lining);

  /// Removes all frames.
  void Clear();

  double GetTime(std::size_t frame) const { return this->Times.empty() ? 0.0 : this->Times[frame]; }
  void FillTable(const Tracks& places, vtkTable* table) const;
  void FillChart(const Tracks& places, const std::vector<std::size_t>& order, int charted,
    vtkTable* chart) const;
  void FillPaths(
    const Tracks& places, const std::vector<std::size_t>& order, vtkPolyData* paths) const;
  void FillEvents(const std::vector<TrackEvent>& events, vtkTable* table) const;
};

}

#endif
