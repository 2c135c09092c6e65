/**
 * @file VolumeSample.h
 * @brief Parts of a volume that represent the whole, the same on every rank.
 *
 * A search for parameters works on a sample: a coarse copy of every n-th node, blocks in which the
 * noise is measured, and blocks that are denoised on trial. All are chosen from the whole grid and
 * gathered on every rank, so that the results of all ranks are bitwise equal without further
 * communication.
 */
#ifndef isthmus_VolumeSample_h
#define isthmus_VolumeSample_h

#include "Imaging/DiffusionGrid.h"
#include "vtkIsthmusFiltersImagingModule.h"

#include <array>
#include <cstdint>
#include <vector>

namespace isthmus
{

using Index3 = std::array<std::int64_t, 3>;

/// A box of nodes of the whole grid: [Begin, End).
struct SampleBox
{
  Index3 Begin{ 0, 0, 0 }, End{ 0, 0, 0 };

  Index3 Size() const
  {
    return { this->End[0] - this->Begin[0], this->End[1] - this->Begin[1],
      this->End[2] - this->Begin[2] };
  }
  std::int64_t Count() const
  {
    const Index3 n = this->Size();
    return n[0] * n[1] * n[2];
  }
};

/// A block for trials: only the nodes of Inner are evaluated; those around them in Box are a
/// margin.
struct TrialBlock
{
  SampleBox Box, Inner;
  double Weight = 1.0;       ///< of each inner node, so that sums estimate means over the whole
  std::vector<float> Values; ///< of Box, (value - Offset) / Scale
  std::vector<float> Noise;  ///< of Box, noise / Scale; empty where it is unknown
  std::vector<char> IsFill;  ///< of Box: constant background, which is left as it is
};

/// Scaled blocks in which the noise is measured, without constant background.
struct NoiseBlocks
{
  Index3 Size{ 0, 0, 0 };
  std::vector<std::vector<float>> Values;
};

struct VolumeSample
{
  Index3 Whole{ 0, 0, 0 };
  double Offset = 0.0, Scale = 1.0; ///< mean and standard deviation of the coarse copy
  bool HasFill = false;             ///< a masked or padded background of one value
  double Fill = 0.0;                ///< that value
  NoiseBlocks Small, Large;         ///< of 8^3 and of 16^3 nodes
  std::vector<TrialBlock> Trials;
};

/// Whether a node has the fill value and shares it with three or more of its neighbours. `begin`
/// and `size` describe the array; at its ends the node itself replaces a missing neighbour.
template <typename T>
bool IsFillNode(const T* values, const Index3& size, const Index3& node, T fill);

/**
 * Samples `values`; `noise` (may be null) is a volume of noise like that in `values`.
 *
 * A volume of up to 300 000 nodes is one trial block. Larger ones have six blocks of about 28^3
 * nodes and a margin. These are chosen systematically with a probability proportional to their
 * standard deviation, and weighted to compensate for it.
 */
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT VolumeSample SampleVolume(
  const DiffusionGrid<T>& grid, const T* values, const T* noise);

///@{
/// Mean over the whole of the values and of their squares, summed as integers of a common unit, so
/// that neither threads nor ranks change a bit.
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT double ExactMean(const DiffusionGrid<T>& grid, const T* values);
template <typename T>
VTKISTHMUSFILTERSIMAGING_EXPORT double ExactMeanSquare(
  const DiffusionGrid<T>& grid, const T* values);
///@}

}

#endif
