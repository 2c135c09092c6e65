/**
 * @file NoData.h
 * @brief Finds the value by which a map marks voxels without data, and replaces it.
 */
#ifndef isthmus_NoData_h
#define isthmus_NoData_h

#include <cstdint>
#include <optional>

namespace isthmus
{

/**
 * The value that stands for "no data", such as -9999 or 1e35: the smallest or the largest of all,
 * in at least two voxels, of a magnitude at least 20 times that of every other value, while the
 * others are at least 32 different ones. So zeros outside a mask, binary masks, labels and single
 * hot voxels are data. Values that are not finite are ignored. One pass, O(count).
 */
template <typename T>
std::optional<T> FindNoDataValue(const T* values, std::int64_t count);

struct NoDataReplacement
{
  std::int64_t Voxels = 0;
  double By = 0.0;
};

/**
 * Marks all voxels of the value `noData` by 1 in `mask`, others by 0, and replaces it by 0, the
 * value of masked maps outside their mask, or the nearest to 0 in the range of the other values.
 */
template <typename T>
NoDataReplacement ReplaceNoData(T* values, std::int64_t count, T noData, unsigned char* mask);

}

#endif
