/**
 * @file PointBins.h
 * @brief Sorts points into cubic bins, to find those near a place.
 */
#ifndef isthmus_PointBins_h
#define isthmus_PointBins_h

#include "Core/Geometry.h"
#include "Core/View.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <utility>
#include <vector>

namespace isthmus
{

/**
 * Points sorted by the bin they are in (32 bytes per point). Where their box has few bins for their
 * number, a table says where each bin begins; else only bins with points take memory (24 bytes per
 * point more), so that stray points far away do no harm. O(n log n). Points at coordinates over
 * size beyond 2^53, or not finite, are never found near a place.
 */
class PointBins
{
public:
  PointBins(const View<Point3>& points, double size)
    : Size(size)
  {
    std::vector<std::pair<Bin, std::int64_t>> order;
    order.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      order.emplace_back(this->FindBin(points[i]), static_cast<std::int64_t>(i));
    }
    std::sort(order.begin(), order.end());
    this->Entries.reserve(points.size());
    for (const auto& [bin, id] : order)
    {
      this->Entries.push_back({ points[static_cast<std::size_t>(id)], id });
    }
    this->MakeTable(order);
  }

  /// Numbers of the points as Near visits them.
  std::vector<std::int64_t> Order() const
  {
    std::vector<std::int64_t> ids;
    ids.reserve(this->Entries.size());
    for (const Entry& entry : this->Entries)
    {
      ids.push_back(entry.Id);
    }
    return ids;
  }

  /// Calls `visit(id, squared distance)` for each point within `reach` of `place`, in an order that
  /// depends only on the points.
  template <typename Visit>
  void Near(const Point3& place, double reach, Visit&& visit) const
  {
    const double squared = reach * reach;
    this->NearRanges(place, reach,
      [&](std::size_t first, std::size_t last)
      {
        for (std::size_t i = first; i < last; ++i)
        {
          const Entry& entry = this->Entries[i];
          const Point3 d = entry.Point - place;
          const double dd = Dot(d, d);
          if (dd <= squared)
          {
            visit(entry.Id, dd);
          }
        }
      });
  }

  /// Calls `visit(first, last)` for ranges of the positions in Order() that include all points
  /// within `reach` of `place`, and possibly others.
  template <typename Visit>
  void NearRanges(const Point3& place, double reach, Visit&& visit) const
  {
    const double squared = reach * reach;
    Bin low = this->FindBin({ place[0] - reach, place[1] - reach, place[2] - reach });
    Bin high = this->FindBin({ place[0] + reach, place[1] + reach, place[2] + reach });
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::max(low[axis], this->Low[axis]);
      high[axis] = std::min(high[axis], this->High[axis]);
    }
    // Without a table, finding a row takes as long as visiting a hundred points.
    const double rows =
      (static_cast<double>(high[0] - low[0]) + 1.0) * (static_cast<double>(high[1] - low[1]) + 1.0);
    if (this->Begins.empty() && 100.0 * rows > static_cast<double>(this->Entries.size()))
    {
      visit(std::size_t{ 0 }, this->Entries.size());
      return;
    }
    for (std::int64_t z = low[0]; z <= high[0]; ++z)
    {
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
      {
        // The chord of the ball in this row of bins, slightly longer because of rounding.
        const double dz = this->Gap(z, place[2]);
        const double dy = this->Gap(y, place[1]);
        const double left = squared * (1.0 + 1e-12) - dy * dy - dz * dz;
        if (left < 0.0)
        {
          continue;
        }
        const double chord = std::sqrt(left) + 1e-12 * (reach + std::fabs(place[0]));
        const auto [first, last] =
          this->Row(z, y, std::max(low[2], this->FindBin(place[0] - chord)),
            std::min(high[2], this->FindBin(place[0] + chord)));
        if (first < last)
        {
          visit(first, last);
        }
      }
    }
  }

private:
  using Bin = std::array<std::int64_t, 3>; ///< z, y, x

  struct Entry
  {
    Point3 Point;
    std::int64_t Id;
  };

  void MakeTable(const std::vector<std::pair<Bin, std::int64_t>>& order)
  {
    if (order.empty())
    {
      return;
    }
    this->Low = this->High = order.front().first;
    for (const auto& [bin, id] : order)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        this->Low[axis] = std::min(this->Low[axis], bin[axis]);
        this->High[axis] = std::max(this->High[axis], bin[axis]);
      }
    }
    double bins = 1.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      bins *= static_cast<double>(this->High[axis] - this->Low[axis]) + 1.0;
    }
    if (bins > 8.0 * static_cast<double>(order.size()) + 4096.0)
    {
      this->Bins.reserve(order.size());
      for (const auto& [bin, id] : order)
      {
        this->Bins.push_back(bin);
      }
      return;
    }
    this->Begins.assign(static_cast<std::size_t>(bins) + 1, order.size());
    std::size_t next = 0;
    for (std::size_t i = 0; i < order.size(); ++i)
    {
      for (const std::size_t at = this->CountPoints(order[i].first); next <= at; ++next)
      {
        this->Begins[next] = i;
      }
    }
  }

  std::size_t CountPoints(const Bin& bin) const
  {
    return static_cast<std::size_t>(
      ((bin[0] - this->Low[0]) * (this->High[1] - this->Low[1] + 1) + bin[1] - this->Low[1]) *
        (this->High[2] - this->Low[2] + 1) +
      bin[2] - this->Low[2]);
  }

  /// The entries in bins `first` to `last` of a row, all of them inside of the box.
  std::pair<std::size_t, std::size_t> Row(
    std::int64_t z, std::int64_t y, std::int64_t first, std::int64_t last) const
  {
    if (first > last)
    {
      return { 0, 0 };
    }
    if (!this->Begins.empty())
    {
      return { this->Begins[this->CountPoints({ z, y, first })],
        this->Begins[this->CountPoints({ z, y, last }) + 1] };
    }
    const auto low = std::lower_bound(this->Bins.begin(), this->Bins.end(), Bin{ z, y, first });
    const auto high = std::upper_bound(low, this->Bins.end(), Bin{ z, y, last });
    return { static_cast<std::size_t>(low - this->Bins.begin()),
      static_cast<std::size_t>(high - this->Bins.begin()) };
  }

  std::int64_t FindBin(double x) const
  {
    constexpr double most = 9007199254740992.0; // 2^53
    const double bin = std::floor(x / this->Size);
    return bin > -most ? static_cast<std::int64_t>(std::min(bin, most)) // NaN is not
                       : -static_cast<std::int64_t>(most);
  }

  Bin FindBin(const Point3& p) const
  {
    return { this->FindBin(p[2]), this->FindBin(p[1]), this->FindBin(p[0]) };
  }

  /// Distance of `x` from the bins with this number along its axis.
  double Gap(std::int64_t bin, double x) const
  {
    const double low = this->Size * static_cast<double>(bin);
    return std::max({ 0.0, low - x, x - low - this->Size });
  }

  double Size;
  std::vector<Entry> Entries;
  Bin Low{ 0, 0, 0 }, High{ -1, -1, -1 };
  std::vector<std::size_t> Begins; ///< of each bin of the box, and the end; or none
  std::vector<Bin> Bins;           ///< of each entry, where there is no table
};

}

#endif
