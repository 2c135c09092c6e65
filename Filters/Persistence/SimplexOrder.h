/**
 * @file SimplexOrder.h
 * @brief The order in which simplices enter, by a radix sort of their values.
 */
#ifndef isthmus_SimplexOrder_h
#define isthmus_SimplexOrder_h

#include "Core/Progress.h"
#include "Persistence/SimplexIds.h"
#include "vtkIsthmusFiltersPersistenceModule.h" // for the export macro

namespace isthmus
{

/**
 * All simplices of one dimension in ascending (first, value, id); `rank` becomes the inverse.
 *
 * `first` marks simplices that come before all others (one flag each, or none); no value is NaN.
 * Bits of doubles, turned round below zero, stand in the order of their values: the 32 leading ones
 * in which the values differ are sorted by three stable passes of 11, and runs of equal ones by the
 * value itself. O(n), parallel, the same on any number of threads; 16 bytes a simplex while it
 * runs.
 */
template <typename Id, typename Rank>
HandleVector<Rank, Id> SimplexOrder(const HandleVector<Id, double>& value,
  const HandleVector<Id, char>& first, HandleVector<Id, Rank>& rank,
  const ProgressCallback& progress = {});

/// The same by levels, counted from 0: all simplices in ascending (level, id). Two passes for up to
/// four million levels.
template <typename Id, typename Rank>
HandleVector<Rank, Id> SimplexOrder(const HandleVector<Id, std::uint32_t>& level,
  HandleVector<Id, Rank>& rank, const ProgressCallback& progress = {});

extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<EdgeRank, EdgeId> SimplexOrder(
  const HandleVector<EdgeId, double>& value, const HandleVector<EdgeId, char>& first,
  HandleVector<EdgeId, EdgeRank>& rank, const ProgressCallback& progress);
extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<TriangleRank, TriangleId>
SimplexOrder(const HandleVector<TriangleId, double>& value,
  const HandleVector<TriangleId, char>& first, HandleVector<TriangleId, TriangleRank>& rank,
  const ProgressCallback& progress);
extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<TetrahedronRank, TetrahedronId>
SimplexOrder(const HandleVector<TetrahedronId, double>& value,
  const HandleVector<TetrahedronId, char>& first,
  HandleVector<TetrahedronId, TetrahedronRank>& rank, const ProgressCallback& progress);

extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<EdgeRank, EdgeId> SimplexOrder(
  const HandleVector<EdgeId, std::uint32_t>& level, HandleVector<EdgeId, EdgeRank>& rank,
  const ProgressCallback& progress);
extern template VTKISTHMUSFILTERSPERSISTENCE_EXPORT HandleVector<TriangleRank, TriangleId>
SimplexOrder(const HandleVector<TriangleId, std::uint32_t>& level,
  HandleVector<TriangleId, TriangleRank>& rank, const ProgressCallback& progress);

}

#endif
