/**
 * @file DiffusionPipeline.h
 * @brief One tile of rows walked through plane by plane, several stages behind each other.
 *
 * Each stage is u -> L u -> ... -> W, c -> rate -> update; its result is the next one's u. A stage
 * runs as many planes behind the one before as it looks far, so that all between the first u and
 * the last result is a few planes in cache.
 */
#ifndef isthmus_DiffusionPipeline_h
#define isthmus_DiffusionPipeline_h

#include "Imaging/DiffusionOperator.h"
#include "Imaging/PlaneRing.h"

#include <cstdint>
#include <vector>

namespace isthmus
{

template <typename T>
class DiffusionPipeline
{
public:
  struct Range
  {
    std::int64_t Begin, End;
  };

  /// Rows of a tile whose planes fill about half a MiB, or 1.5 MiB with several stages.
  static std::int64_t TileRowsThatFit(const DiffusionOperator<T>& diffusion, int stages);

  DiffusionPipeline(const DiffusionOperator<T>& diffusion, int stages, std::int64_t tileRows);

  /// Does the stages of a pass for these rows of these planes. What lies around them and is needed
  /// by the later stages is worked out again by each tile.
  void Run(const DiffusionPass<T>& pass, Range rows, Range planes);

private:
  /// What one stage keeps.
  struct Stage
  {
    std::vector<PlaneRing<T>> Levels; ///< L^m u with the lower orders added; the last is W
    PlaneRing<T> C;                   ///< empty where the coefficient is constant or stored
  };

  void RunStage(std::size_t stage, std::int64_t wave);
  /// The rows that a quantity `lag` planes behind the first u owes of its plane of this wave.
  Range Owed(std::int64_t plane, int lag) const;
  bool Own(std::int64_t row, std::int64_t plane) const;
  std::int64_t Offset(std::int64_t row, std::int64_t plane) const;
  void Load(PlaneRing<T>& ring, const T* volume, Range rows, std::int64_t plane);
  void RaiseOrder(Stage& stage, std::size_t level, Range rows, std::int64_t plane);
  void FillCoefficient(std::size_t stage, Range rows, std::int64_t plane);
  void FillRates(std::size_t stage, std::int64_t row, std::int64_t plane);
  void WriteRow(std::size_t stage, std::int64_t row, std::int64_t plane);
  void AddReactions(const T* current, std::int64_t offset);
  PlaneRing<T>& CoefficientOf(std::size_t stage);

  const DiffusionOperator<T>& Diffusion;
  DiffusionLags Lags;
  std::int64_t Length; ///< of a row
  std::array<T, 3> SecondWeights, FirstWeights;
  const DiffusionPass<T>* Pass = nullptr;
  Range OwnRows{ 0, 0 }, OwnPlanes{ 0, 0 }; ///< of the tile, without what its neighbours own
  std::vector<Stage> Stages;
  PlaneRing<T> StoredC; ///< shared by the stages
  std::vector<T> RateScratch;
};

}

#endif
