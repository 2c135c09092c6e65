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

}

#endif
