#include "Tetrahedra/StuffingWarp.h"

#include "Core/ParallelFor.h"

namespace isthmus
{
namespace
{

bool IsLong(std::size_t edge)
{
  return edge < 6;
}

LatticePoint Along(const LatticePoint& p, std::size_t edge)
{
  const LatticePoint& s = LatticeSteps[edge];
  return { p[0] + s[0], p[1] + s[1], p[2] + s[2] };
}

}

StuffingWarp::StuffingWarp(const StuffingLattice& lattice, const ProgressCallback& progress)
  : Lattice(lattice)
  , Edge(static_cast<std::size_t>(lattice.Nodes()), Unmoved)
{
  ParallelFor(
    0, lattice.Nodes(), 1 << 14,
    [this](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        const LatticePoint p = this->Lattice.PointOf(node);
        if (this->Lattice.IsNear(p))
        {
          this->Edge[static_cast<std::size_t>(node)] = this->NearestCrossing(p, node);
        }
      }
    },
    progress);
}

/// How far along the edge from `node` the surface crosses it; by quotients, so that no value is too
/// large. The middle of a face of the box (-1) has no value: the surface is closed there, so it is
/// taken to lie on it. @pre they are on different sides.
double StuffingWarp::FractionFrom(std::int64_t node, std::int64_t other) const
{
  const double a = node < 0 ? 0.0 : std::abs(this->Lattice.Value(node));
  const double b = other < 0 ? 0.0 : std::abs(this->Lattice.Value(other));
  return a == 0.0 ? 0.0 : 1.0 / (1.0 + b / a);
}

unsigned char StuffingWarp::NearestCrossing(const LatticePoint& p, std::int64_t node) const
{
  const bool inside = this->Lattice.IsInside(node);
  unsigned char nearest = Unmoved;
  double least = 1e300;
  for (std::size_t e = 0; e < LatticeEdges; ++e)
  {
    const LatticePoint q = Along(p, e);
    bool exists = true;
    for (std::size_t a = 0; a < 3; ++a)
    {
      exists = exists && q[a] >= 0 && q[a] <= 2 * this->Lattice.Cells()[a];
    }
    const std::int64_t other = exists ? this->Lattice.Node(q) : -1;
    if (other < 0 || this->Lattice.IsInside(other) == inside)
    {
      continue;
    }
    const double t = this->FractionFrom(node, other);
    const double length = t * (IsLong(e) ? 1.0 : std::sqrt(0.75));
    if (t < (IsLong(e) ? StuffingAlphaLong : StuffingAlphaShort) && length < least)
    {
      least = length;
      nearest = static_cast<unsigned char>(e);
    }
  }
  return nearest;
}

int StuffingWarp::Side(const LatticePoint& p) const
{
  const std::int64_t node = this->Lattice.Node(p);
  if (node < 0)
  {
    return -1; // the middle of a face of the box
  }
  return this->Edge[static_cast<std::size_t>(node)] != Unmoved ? 0
    : this->Lattice.IsInside(node)                             ? 1
                                                               : -1;
}

Point3 StuffingWarp::Position(const LatticePoint& p) const
{
  const std::int64_t node = this->Lattice.Node(p);
  const Point3 from = this->Lattice.Position(p);
  const std::size_t edge = node < 0 ? Unmoved : this->Edge[static_cast<std::size_t>(node)];
  if (edge == Unmoved)
  {
    return from;
  }
  const LatticePoint q = Along(p, edge);
  const double t = this->FractionFrom(node, this->Lattice.Node(q));
  return from + t * (this->Lattice.Position(q) - from);
}

Point3 StuffingWarp::Crossing(const LatticePoint& a, const LatticePoint& b) const
{
  const bool isShort = ((a[0] ^ b[0]) & 1) != 0;
  const double alpha = isShort ? StuffingAlphaShort : StuffingAlphaLong;
  // Always from the same end, so that all tetrahedra around the edge find the same bits.
  const bool swap = b < a;
  const LatticePoint& low = swap ? b : a;
  const LatticePoint& high = swap ? a : b;
  const double t = std::min(1.0 - alpha,
    std::max(alpha, this->FractionFrom(this->Lattice.Node(low), this->Lattice.Node(high))));
  const Point3 from = this->Lattice.Position(low);
  return from + t * (this->Lattice.Position(high) - from);
}

/// How far a point is moved, in cells.
double StuffingWarp::MoveLength(const LatticePoint& p) const
{
  const Point3 d = this->Position(p) - this->Lattice.Position(p);
  return Length(d);
}

void StuffingWarp::Keep(const LatticePoint& p)
{
  this->Edge[static_cast<std::size_t>(this->Lattice.Node(p))] = Unmoved;
  ++this->StayedCount;
}

}
