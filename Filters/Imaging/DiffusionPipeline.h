/**
 * @file DiffusionPipeline.h
 * @brief One tile of rows walked through plane by plane: u -> L u -> ... -> W, c -> rate -> update.
 */
#ifndef isthmus_DiffusionPipeline_h
#define isthmus_DiffusionPipeline_h

#include "DiffusionOperator.h"

#include <algorithm>
#include <cstdint>
#include <vector>

namespace isthmus
{

/// The last few planes of a quantity, as far as a tile of rows needs them, each row with margins.
template <typename T>
class PlaneRing
{
public:
  PlaneRing(std::int64_t rowLength, std::int64_t tileRows, int depth);

  /// The rows held from now on: those from `first`, of a grid with `rows` rows and `planes` planes.
  void Place(std::int64_t first, std::int64_t rows, std::int64_t planes);

  T* Row(std::int64_t row, std::int64_t plane)
  {
    return this->Values.data() +
      ((plane % this->Depth) * this->RowCount + (row - this->FirstRow)) * this->Stride + RowMargin;
  }

  /// The row with its neighbours; beyond the grid's ends, the outermost ones again (Neumann).
  RowStencil<T> Stencil(std::int64_t row, std::int64_t plane)
  {
    const std::int64_t lastRow = this->GridRows - 1, lastPlane = this->GridPlanes - 1;
    return { this->Row(row, plane), this->Row(std::max<std::int64_t>(row - 1, 0), plane),
      this->Row(std::min(row + 1, lastRow), plane),
      this->Row(row, std::max<std::int64_t>(plane - 1, 0)),
      this->Row(row, std::min(plane + 1, lastPlane)) };
  }

private:
  std::int64_t RowCount, Depth, Stride;
  std::int64_t FirstRow = 0, GridRows = 0, GridPlanes = 0;
  std::vector<T> Values;
};

template <typename T>
class DiffusionPipeline
{
public:
  struct Range
  {
    std::int64_t Begin, End;
  };

  /// Rows of a tile whose rings fill about half of a core's second-level cache.
  static std::int64_t TileRowsThatFit(const DiffusionOperator<T>& diffusion);

  DiffusionPipeline(const DiffusionOperator<T>& diffusion, std::int64_t tileRows);

  /// Does one stage for these rows of these planes.
  void Run(const DiffusionStage<T>& stage, Range rows, Range planes);

private:
  void Load(PlaneRing<T>& ring, const T* volume, Range rows, std::int64_t plane);
  void RaiseOrder(int order, Range rows, std::int64_t plane);
  void FillCoefficient(const DiffusionStage<T>& stage, Range rows, std::int64_t plane);
  void WriteRow(const DiffusionStage<T>& stage, std::int64_t row, std::int64_t plane);
  void AddReactions(const T* current, std::int64_t offset);

  const DiffusionOperator<T>& Diffusion;
  DiffusionLags Lags;
  std::int64_t Length; ///< of a row
  std::array<T, 3> SecondWeights, FirstWeights;
  Range OwnRows{ 0, 0 }, OwnPlanes{ 0, 0 }; ///< of the tile, without what its neighbours own
  std::vector<PlaneRing<T>> Levels;         ///< L^m u with the lower orders added; the last is W
  PlaneRing<T> C;
  std::vector<T> RateScratch;
};

}

#endif
