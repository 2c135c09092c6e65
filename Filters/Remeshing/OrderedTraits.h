/**
 * @file OrderedTraits.h
 * @brief Geometric traits with which CGAL's hole filling is reproducible. Private: only for files
 * that use CGAL.
 *
 * CGAL searches for the best filling among the faces of a Delaunay triangulation, in the order of
 * its cells; of equally good ones, it takes the first. Unless cells have time stamps, CGAL compares
 * their addresses, so that the order, and thus the filling, depends on the memory allocated before.
 */
#ifndef isthmus_OrderedTraits_h
#define isthmus_OrderedTraits_h

#include "Remeshing/CGALSurface.h"

#include <CGAL/Delaunay_triangulation_cell_base_3.h>

#include <cstddef>

namespace isthmus::cgal
{

/// To be passed as `geom_traits`.
struct OrderedTraits : Kernel
{
};

}

namespace CGAL
{

/// Cells that are compared by the order in which they were made.
template <typename Base>
class Delaunay_triangulation_cell_base_3<isthmus::cgal::OrderedTraits, Base> : public Base
{
public:
  using Has_timestamp = Tag_true;
  using Geom_traits = isthmus::cgal::OrderedTraits;
  using Point_3 = Geom_traits::Point_3;
  using Point = Point_3;

  template <typename Structure>
  struct Rebind_TDS
  {
    using Other = Delaunay_triangulation_cell_base_3<Geom_traits,
      typename Base::template Rebind_TDS<Structure>::Other>;
  };

  using Base::Base;

  std::size_t time_stamp() const { return this->Stamp; }
  void set_time_stamp(std::size_t stamp) { this->Stamp = stamp; }

private:
  std::size_t Stamp = static_cast<std::size_t>(-1);
};

}

#endif
