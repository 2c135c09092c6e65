#include "Tetrahedra/StuffingLattice.h"

#include "Core/MemoryBudget.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"

#include <stdexcept>
#include <string>

namespace isthmus
{

const std::array<LatticePoint, LatticeEdges> LatticeSteps{ { { 2, 0, 0 }, { -2, 0, 0 }, { 0, 2, 0 },
  { 0, -2, 0 }, { 0, 0, 2 }, { 0, 0, -2 }, { -1, -1, -1 }, { 1, -1, -1 }, { -1, 1, -1 },
  { 1, 1, -1 }, { -1, -1, 1 }, { 1, -1, 1 }, { -1, 1, 1 }, { 1, 1, 1 } } };

namespace
{

/// Layers of cells between the bounds and the box: the surface may change two of them.
constexpr double FewestLayers = 3.0;

}

StuffingLattice::StuffingLattice(const Bounds3& bounds, const StuffingParameters& parameters)
  : Size(parameters.CellSize)
{
  constexpr double mostCells = 262144.0;
  const double pad = std::max(parameters.Margin, FewestLayers * this->Size);
  const double unit = std::ldexp(1.0, parameters.GradingLevels);
  for (std::size_t a = 0; a < 3; ++a)
  {
    const double length = bounds.Max[a] - bounds.Min[a] + 2.0 * pad;
    // A multiple of the largest octants, so that none leaves the box.
    const double cells = unit * std::ceil(length / this->Size / unit * (1.0 - 1e-12));
    if (!(cells <= mostCells))
    {
      throw std::invalid_argument("A cell size of " + FormatNumber(this->Size) +
        " would make more than 262144 cells along an axis: choose a larger one.");
    }
    this->Count[a] = std::max<std::int64_t>(1, static_cast<std::int64_t>(cells));
    this->Origin[a] =
      0.5 * (bounds.Min[a] + bounds.Max[a] - this->Size * static_cast<double>(this->Count[a]));
  }
  this->Corners = (this->Count[0] + 1) * (this->Count[1] + 1) * (this->Count[2] + 1);
  this->Centers = this->Count[0] * this->Count[1] * this->Count[2];
  parameters.Memory.Require(this->Bytes(),
    "A lattice of " + std::to_string(this->Centers) + " cells (cell size " +
      FormatNumber(this->Size) + ")",
    "choose a larger cell size");
}

double StuffingLattice::Bytes() const
{
  // Value and warp per node; marks per cell, one of them twice while they grow, and its level.
  return 9.0 * static_cast<double>(this->Nodes()) + 3.0 * static_cast<double>(this->Centers);
}

Point3 StuffingLattice::Position(const LatticePoint& p) const
{
  Point3 x;
  for (std::size_t a = 0; a < 3; ++a)
  {
    x[a] = this->Origin[a] + 0.5 * this->Size * static_cast<double>(p[a]);
  }
  return x;
}

std::int64_t StuffingLattice::Node(const LatticePoint& p) const
{
  const std::int64_t odd = p[0] & 1;
  if ((p[1] & 1) != odd || (p[2] & 1) != odd)
  {
    return -1;
  }
  const auto& n = this->Count;
  return odd ? this->Corners + this->Cell(p[0] / 2, p[1] / 2, p[2] / 2)
             : p[0] / 2 + (n[0] + 1) * (p[1] / 2 + (n[1] + 1) * (p[2] / 2));
}

LatticePoint StuffingLattice::GetPoint(std::int64_t node) const
{
  const bool center = node >= this->Corners;
  const std::int64_t more = center ? 0 : 1;
  const std::int64_t id = center ? node - this->Corners : node;
  const std::int64_t row = id / (this->Count[0] + more);
  return { 2 * (id % (this->Count[0] + more)) + (1 - more),
    2 * (row % (this->Count[1] + more)) + (1 - more),
    2 * (row / (this->Count[1] + more)) + (1 - more) };
}

bool StuffingLattice::IsNear(const LatticePoint& node) const
{
  LatticePoint cell;
  for (std::size_t a = 0; a < 3; ++a)
  {
    cell[a] = std::min(node[a] / 2, this->Count[a] - 1);
  }
  return this->IsNear(this->Cell(cell[0], cell[1], cell[2]));
}

void StuffingLattice::Sample(
  const std::function<double(const Point3&)>& field, const ProgressCallback& progress)
{
  this->Values.resize(static_cast<std::size_t>(this->Nodes()));
  ParallelFor(
    0, this->Nodes(), 4096,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t node = first; node < last; ++node)
      {
        this->Values[static_cast<std::size_t>(node)] = field(this->Position(this->GetPoint(node)));
      }
    },
    Between(progress, 0.0, 0.9));
  this->Near.assign(static_cast<std::size_t>(this->Centers), 0);
  ParallelFor(0, this->Count[2], 1,
    [&](std::int64_t first, std::int64_t last)
    {
      for (std::int64_t k = first; k < last; ++k)
      {
        this->MarkCrossed(k);
      }
    });
  this->Dilate();
  this->Dilate();
  Report(progress, 1.0);
}

void StuffingLattice::MarkCrossed(std::int64_t k)
{
  for (std::int64_t j = 0; j < this->Count[1]; ++j)
  {
    for (std::int64_t i = 0; i < this->Count[0]; ++i)
    {
      const bool inside = this->IsInside(this->Corners + this->Cell(i, j, k));
      bool crossed = false;
      for (int corner = 0; corner < 8; ++corner)
      {
        const LatticePoint p{ 2 * (i + (corner & 1)), 2 * (j + (corner >> 1 & 1)),
          2 * (k + (corner >> 2)) };
        crossed |= this->IsInside(this->Node(p)) != inside;
      }
      this->Near[static_cast<std::size_t>(this->Cell(i, j, k))] = crossed ? 1 : 0;
    }
  }
}

/// The marks grow by one cell to all sides, one axis after the other.
void StuffingLattice::Dilate()
{
  const std::array<std::int64_t, 3> stride{ 1, this->Count[0], this->Count[0] * this->Count[1] };
  for (std::size_t a = 0; a < 3; ++a)
  {
    std::vector<unsigned char> grown(this->Near.size());
    ParallelFor(0, this->Centers, 1 << 16,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t c = first; c < last; ++c)
        {
          const std::int64_t at = c / stride[a] % this->Count[a];
          const auto mark = [&](std::int64_t cell)
          { return this->Near[static_cast<std::size_t>(cell)] != 0; };
          grown[static_cast<std::size_t>(c)] = mark(c) || (at > 0 && mark(c - stride[a])) ||
              (at + 1 < this->Count[a] && mark(c + stride[a]))
            ? 1
            : 0;
        }
      });
    this->Near.swap(grown);
  }
}

namespace
{

/// One flag for each block of cells of one size.
struct Blocks
{
  std::array<std::int64_t, 3> Count;
  std::vector<unsigned char> Flags;

  std::size_t At(const LatticePoint& b) const
  {
    return static_cast<std::size_t>(b[0] + this->Count[0] * (b[1] + this->Count[1] * b[2]));
  }
  bool Has(const LatticePoint& b) const { return this->Flags[this->At(b)] != 0; }
};

template <typename Visit>
void ForEachBlock(const std::array<std::int64_t, 3>& count, Visit&& visit)
{
  for (std::int64_t k = 0; k < count[2]; ++k)
  {
    for (std::int64_t j = 0; j < count[1]; ++j)
    {
      for (std::int64_t i = 0; i < count[0]; ++i)
      {
        visit(LatticePoint{ i, j, k });
      }
    }
  }
}

/// Blocks twice as large all of whose eight children are flagged.
Blocks Parents(const Blocks& children)
{
  Blocks parents;
  for (std::size_t a = 0; a < 3; ++a)
  {
    parents.Count[a] = children.Count[a] / 2;
  }
  parents.Flags.resize(
    static_cast<std::size_t>(parents.Count[0] * parents.Count[1] * parents.Count[2]));
  ForEachBlock(parents.Count,
    [&](const LatticePoint& b)
    {
      bool all = true;
      for (int c = 0; c < 8; ++c)
      {
        all =
          all && children.Has({ 2 * b[0] + (c & 1), 2 * b[1] + (c >> 1 & 1), 2 * b[2] + (c >> 2) });
      }
      parents.Flags[parents.At(b)] = all ? 1 : 0;
    });
  return parents;
}

/// Flags of those whose up to 26 neighbours are flagged, too: none of them is smaller by two
/// levels.
Blocks BalanceBlocks(const Blocks& blocks)
{
  Blocks result = blocks;
  ForEachBlock(blocks.Count,
    [&](const LatticePoint& b)
    {
      for (int n = 0; n < 27; ++n)
      {
        const LatticePoint other{ b[0] + n % 3 - 1, b[1] + n / 3 % 3 - 1, b[2] + n / 9 - 1 };
        bool exists = true;
        for (std::size_t a = 0; a < 3; ++a)
        {
          exists = exists && other[a] >= 0 && other[a] < blocks.Count[a];
        }
        if (exists && !blocks.Has(other))
        {
          result.Flags[result.At(b)] = 0;
        }
      }
    });
  return result;
}

}

void StuffingLattice::Grade(int levels)
{
  if (levels == 0)
  {
    return;
  }
  this->Levels.assign(this->Near.size(), 0);
  Blocks blocks{ this->Count, this->Near };
  for (unsigned char& flag : blocks.Flags)
  {
    flag = flag ? 0 : 1;
  }
  for (int level = 1; level <= levels; ++level)
  {
    // Neighbours differ by one level at most: the tetrahedra between others have no bounds.
    blocks = BalanceBlocks(Parents(blocks));
    const std::int64_t size = std::int64_t{ 1 } << level;
    ForEachBlock(this->Count,
      [&](const LatticePoint& c)
      {
        if (blocks.Has({ c[0] / size, c[1] / size, c[2] / size }))
        {
          this->Levels[static_cast<std::size_t>(this->Cell(c[0], c[1], c[2]))] =
            static_cast<unsigned char>(level);
        }
      });
  }
}

/// Whether one of the cells around the edge belongs to an octant below `level`.
bool StuffingBackground::IsSplit(const LatticePoint& a, const LatticePoint& b, int level) const
{
  if (level == 0)
  {
    return false;
  }
  std::size_t along = 0;
  while (a[along] == b[along])
  {
    ++along;
  }
  const std::size_t u = (along + 1) % 3, v = (along + 2) % 3;
  const auto& n = this->Lattice.Cells();
  LatticePoint cell;
  cell[along] = std::min(a[along], b[along]) / 2;
  for (int side = 0; side < 4; ++side)
  {
    cell[u] = a[u] / 2 - (side & 1);
    cell[v] = a[v] / 2 - (side >> 1);
    const bool exists = cell[u] >= 0 && cell[u] < n[u] && cell[v] >= 0 && cell[v] < n[v];
    if (exists && this->Lattice.Level(cell) < level)
    {
      return true;
    }
  }
  return false;
}

void StuffingBackground::AppendFan(
  const Octant& octant, const Face& face, std::vector<LatticeTetrahedron>& out) const
{
  const LatticePoint center = octant.Center();
  LatticePoint middle;
  for (std::size_t a = 0; a < 3; ++a)
  {
    middle[a] = (face[0][a] + face[2][a]) / 2;
  }
  for (std::size_t e = 0; e < 4; ++e)
  {
    this->ForEachPart(face[e], face[(e + 1) % 4], octant.Level,
      [&](const LatticePoint& a, const LatticePoint& b) {
        out.push_back({ center, middle, a, b });
      });
  }
}

void StuffingBackground::AppendHalves(const Octant& octant, const Octant& larger, const Face& face,
  std::vector<LatticeTetrahedron>& out) const
{
  const LatticePoint center = octant.Center();
  const LatticePoint other = larger.Center();
  // The middle of the larger face is the corner of this one that lies beside the larger center.
  std::size_t q = 0;
  const auto near = [&](std::size_t corner)
  {
    int equal = 0;
    for (std::size_t a = 0; a < 3; ++a)
    {
      equal += face[corner][a] == other[a] ? 1 : 0;
    }
    return equal;
  };
  for (std::size_t corner = 1; corner < 4; ++corner)
  {
    q = near(corner) > near(q) ? corner : q;
  }
  out.push_back({ center, face[q], face[(q + 1) % 4], face[(q + 2) % 4] });
  out.push_back({ center, face[q], face[(q + 2) % 4], face[(q + 3) % 4] });
}

void StuffingBackground::Append(const Octant& octant, std::vector<LatticeTetrahedron>& out) const
{
  const std::int64_t side = octant.Side();
  const LatticePoint center = octant.Center();
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const bool up : { false, true })
    {
      Face face;
      const LatticePoint first{ 2 * octant.First[0], 2 * octant.First[1], 2 * octant.First[2] };
      for (std::size_t c = 0; c < 4; ++c)
      {
        face[c] = first;
        face[c][axis] += up ? 2 * side : 0;
        face[c][u] += c == 1 || c == 2 ? 2 * side : 0;
        face[c][v] += c >= 2 ? 2 * side : 0;
      }
      LatticePoint beyond = octant.First;
      beyond[axis] += up ? side : -1;
      const bool outside = beyond[axis] < 0 || beyond[axis] >= this->Lattice.Cells()[axis];
      const int level = outside ? -1 : this->Lattice.Level(beyond);
      if (outside || level < octant.Level)
      {
        this->AppendFan(octant, face, out);
      }
      else if (level > octant.Level)
      {
        const std::int64_t mask = ~((std::int64_t{ 1 } << level) - 1);
        const Octant larger{ { beyond[0] & mask, beyond[1] & mask, beyond[2] & mask }, level };
        this->AppendHalves(octant, larger, face, out);
      }
      else if (up)
      {
        LatticePoint next = center;
        next[axis] += 2 * side;
        for (std::size_t e = 0; e < 4; ++e)
        {
          this->ForEachPart(face[e], face[(e + 1) % 4], octant.Level,
            [&](const LatticePoint& a, const LatticePoint& b) {
              out.push_back({ center, next, a, b });
            });
        }
      }
    }
  }
}

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
        const LatticePoint p = this->Lattice.GetPoint(node);
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
  // Always from the same end, so that all tetrahedra around the edge get the same point.
  const bool swap = b < a;
  const LatticePoint& low = swap ? b : a;
  const LatticePoint& high = swap ? a : b;
  // Crossings nearer to an end would have moved that point if the angles had allowed it: they are
  // shifted to alpha, where the bounds hold.
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
