/**
 * @file PointBins.h
 * @brief Points in cubic bins, to find those near a place.
 */
#ifndef isthmus_PointBins_h
#define isthmus_PointBins_h

#include "Core/Geometry.h"
#include "Core/View.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>
#include <vector>

namespace isthmus
{

/**
 * Points sorted by the bin they are in. Only bins with points take memory (40 bytes a point), so
 * stray points far away do no harm. O(n log n). Coordinates over size must stay below 2^53.
 */
class PointBins
{
public:
  PointBins(const View<Point3>& points, double size)
    : Size(size)
  {
    this->Entries.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
    {
      this->Entries.push_back({ this->BinOf(points[i]), static_cast<std::int64_t>(i), points[i] });
    }
    std::sort(this->Entries.begin(), this->Entries.end());
  }

  /// Calls `visit(id, squared distance)` for each point within `reach` of `place`, in an order that
  /// depends on the points alone.
  template <typename Visit>
  void Near(const Point3& place, double reach, Visit&& visit) const
  {
    const double squared = reach * reach;
    const Bin low = this->BinOf({ place[0] - reach, place[1] - reach, place[2] - reach });
    const Bin high = this->BinOf({ place[0] + reach, place[1] + reach, place[2] + reach });
    for (std::int64_t z = low[0]; z <= high[0]; ++z)
    {
      for (std::int64_t y = low[1]; y <= high[1]; ++y)
      {
        // The ball's chord in this row of bins, a bit longer for rounding.
        const double dz = this->Gap(z, place[2]);
        const double dy = this->Gap(y, place[1]);
        const double left = squared * (1.0 + 1e-12) - dy * dy - dz * dz;
        if (left < 0.0)
        {
          continue;
        }
        const double chord = std::sqrt(left);
        const Bin first{ z, y, std::max(low[2], this->BinOf(place[0] - chord) - 1) };
        const Bin last{ z, y, std::min(high[2], this->BinOf(place[0] + chord) + 1) };
        auto at = std::lower_bound(this->Entries.begin(), this->Entries.end(), first,
          [](const Entry& e, const Bin& bin) { return e.Place < bin; });
        for (; at != this->Entries.end() && at->Place <= last; ++at)
        {
          const Point3 d = at->Point - place;
          const double dd = Dot(d, d);
          if (dd <= squared)
          {
            visit(at->Id, dd);
          }
        }
      }
    }
  }

private:
  using Bin = std::array<std::int64_t, 3>; ///< z, y, x

  struct Entry
  {
    Bin Place;
    std::int64_t Id;
    Point3 Point;

    bool operator<(const Entry& other) const
    {
      return std::tie(this->Place, this->Id) < std::tie(other.Place, other.Id);
    }
  };

  std::int64_t BinOf(double x) const
  {
    return static_cast<std::int64_t>(std::floor(x / this->Size));
  }

  Bin BinOf(const Point3& p) const
  {
    return { this->BinOf(p[2]), this->BinOf(p[1]), this->BinOf(p[0]) };
  }

  /// Distance of `x` from the bins of that number along its axis.
  double Gap(std::int64_t bin, double x) const
  {
    const double low = this->Size * static_cast<double>(bin);
    return std::max({ 0.0, low - x, x - low - this->Size });
  }

  double Size;
  std::vector<Entry> Entries;
};

}

#endif
