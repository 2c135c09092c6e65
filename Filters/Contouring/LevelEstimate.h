/**
 * @file LevelEstimate.h
 * @brief Automatic contour level of a density map, from the histogram of its values.
 */
#ifndef isthmus_LevelEstimate_h
#define isthmus_LevelEstimate_h

#include "Core/GridView.h"

#include <vector>

namespace isthmus
{

/**
 * Level for a map of which `values` are a representative sample; they are sorted by this function.
 *
 * The threshold that splits the values into two classes with the greatest variance between the
 * classes (N. Otsu, IEEE Trans. Syst. Man Cybern. 9 (1979) 62), computed exactly from the sorted
 * values, with the outer 0.05 % on either side clamped, so that a few hot voxels have no influence.
 * A map that fills its box with noise or solvent does not have two classes, and the threshold would
 * lie within its background. Therefore the level is at least three standard deviations of the
 * background above the median, unless fewer than 1 % of the values are that high. The deviation is
 * computed from the values below the median, which do not include the molecule.
 *
 * If all values are equal, the result is that value. O(n log n), with one copy of n prefix sums.
 * @throws std::invalid_argument if there are no values.
 */
double EstimateLevel(std::vector<double>& values);

/// A representative sample of at most 2^20 of the finite values of the grid, for EstimateLevel.
/// `noData` is null or has a flag for each node: those with flags other than 0 are left out.
template <typename T>
std::vector<double> SampleValues(
  const GridView<const T>& grid, const unsigned char* noData = nullptr);

/**
 * Whether the values are distances to a surface, below 0 on one of its sides: values of both signs
 * with a gradient of length 1, per unit of length or per node, within a tenth at four of five nodes
 * of a sample. Nodes beside a value at either end of the range are left out, since distances are
 * often cut off. A density would need the same slope everywhere. O(sample), of at most 2^20 nodes,
 * in addition to the range.
 */
template <typename T>
bool IsSignedDistance(const GridView<const T>& grid, const unsigned char* noData = nullptr);

/// Statistics of the finite values of a map by which its contrast is judged.
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

/// The contrast computed from SampleValues() and the nodes on the six faces: O(nodes^(2/3)) in
/// addition to the sample.
template <typename T>
MapContrast MeasureContrast(const GridView<const T>& grid, const unsigned char* noData = nullptr);

}

#endif
