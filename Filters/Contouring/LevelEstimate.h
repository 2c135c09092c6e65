/**
 * @file LevelEstimate.h
 * @brief Automatic contour level of a density map, from the histogram of its values.
 */
#ifndef isthmus_LevelEstimate_h
#define isthmus_LevelEstimate_h

#include "Core/GridView.h"
#include "vtkIsthmusFiltersContouringModule.h"

#include <vector>

namespace isthmus
{

/**
 * Level for a map of which `values` are a fair sample; they are sorted here.
 *
 * The threshold that splits the values into two classes of the greatest variance between them
 * (N. Otsu, IEEE Trans. Syst. Man Cybern. 9 (1979) 62), exact on the sorted values and with the
 * outer 0.05 % on either side drawn in, so that some hot voxels do not decide. A map that fills its
 * box with noise or solvent has no two classes, and the threshold falls amid its background: so the
 * level is at least three standard deviations of the background above the median, taken from the
 * values below the median (which no molecule is part of), unless fewer than 1 % are that high.
 *
 * Where all values are equal, that value. O(n log n), one copy of n prefix sums.
 * @throws std::invalid_argument for no values.
 */
VTKISTHMUSFILTERSCONTOURING_EXPORT double EstimateLevel(std::vector<double>& values);

/// A fair sample of at most 2^20 of the grid's values that are finite, for EstimateLevel.
template <typename T>
VTKISTHMUSFILTERSCONTOURING_EXPORT std::vector<double> SampleValues(const GridView<const T>& grid);

/// The statistics by which the contrast of a map is judged, of values that are finite.
struct MapContrast
{
  double Skewness = 0.0;       ///< third central moment over the cube of the standard deviation
  double LowShare = 0.0;       ///< of the sample: values two standard deviations below the mean
  double BorderLowShare = 0.0; ///< the same of the nodes on the six faces

  /**
   * Whether density is darker than the background, as in raw micrographs: the tail of the values is
   * on the low side, and low values avoid the border. (Density that is brighter has a skewness of
   * 0.9 to 11 in maps of the EMDB; a mask that is lower than the map within lies at the border.)
   */
  bool IsInverted() const
  {
    return this->Skewness < -0.8 && this->LowShare > 0.0005 &&
      this->BorderLowShare < 0.9 * this->LowShare;
  }
};

/// Of SampleValues() and the nodes on the six faces: O(nodes^(2/3)) beside the sample.
template <typename T>
VTKISTHMUSFILTERSCONTOURING_EXPORT MapContrast ContrastOf(const GridView<const T>& grid);

}

#endif
