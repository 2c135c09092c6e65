#include "Tetrahedra/IsosurfaceStuffing.h"

#include "Core/RangeChecks.h"
#include "Core/TetrahedralMesh.h"
#include "Tetrahedra/MeshQuality.h"
#include "Tetrahedra/StuffingLattice.h"

#include <stdexcept>
#include <string>
#include <unordered_map>
#include <vector>

namespace isthmus
{

//--------------------------------------------------------------------------------------------------
// The parts of a lattice tetrahedron on both sides of the surface.

/// A lattice point (both the same), or the crossing of the surface with the edge between two.
struct StuffingCorner
{
  LatticePoint From;
  LatticePoint To;

  bool IsCrossing() const { return this->From != this->To; }
};

using StuffingPiece = std::array<StuffingCorner, 4>;

/**
 * Appends the tetrahedra of `t` on `side` (1 or -1) to `out`; their orientation is not fixed.
 *
 * Each side of a cut tetrahedron is a tetrahedron, a pyramid or a prism. Quadrilaterals in faces of
 * the lattice are cut by a diagonal that the face alone decides, so that both its tetrahedra agree:
 * to the crossing on the long edge where a long and a short edge are crossed; else from the end of
 * the long edge that lies to an even number of positive sides of the third corner (the paper's
 * parity rule). The quadrilateral on the surface then has one diagonal left, the same for both
 * sides.
 */
void CutTetrahedron(
  const StuffingWarp& warp, const LatticeTetrahedron& t, int side, std::vector<StuffingPiece>& out);

Point3 ComputePosition(const StuffingWarp& warp, const StuffingCorner& corner);

//--------------------------------------------------------------------------------------------------
// Ensures that no tetrahedron of isosurface stuffing violates the bounds on angles.

/**
 * Measures every tetrahedron near the surface, on both sides. Where one would have an angle out of
 * bounds, or all four corners on the surface (the surface turns within a cell; the paper leaves
 * such tetrahedra out, which would be gaps between the two sides), the corner that is moved
 * farthest stays where it was, until none is left. This ends, since tetrahedra none of whose
 * corners are moved are well within the bounds.
 */
void KeepAngles(
  const StuffingLattice& lattice, StuffingWarp& warp, const ProgressCallback& progress);

//--------------------------------------------------------------------------------------------------
// Gathers the tetrahedra of isosurface stuffing into a mesh of shared points.

class StuffingOutput
{
public:
  StuffingOutput(const StuffingWarp& warp, MeshedSide side)
    : Warp(warp)
    , Wanted(side)
  {
  }

  /// The parts of `t` on the requested sides of the surface.
  void AddCut(const LatticeTetrahedron& t);
  /// A tetrahedron that the surface does not come near, on the side given (1 or -1).
  void AddWhole(const LatticeTetrahedron& t, int side);

  bool Wants(int side) const
  {
    return this->Wanted == MeshedSide::Both || (side > 0) == (this->Wanted == MeshedSide::Inside);
  }
  const std::vector<bool>& OnSurface() const { return this->Surface; }
  TetrahedralMesh& Mesh() { return this->Result; }

private:
  void Insert(const StuffingPiece& piece, int side);
  std::int64_t PointId(const StuffingCorner& corner);

  const StuffingWarp& Warp;
  MeshedSide Wanted;
  TetrahedralMesh Result;
  std::vector<bool> Surface; ///< for each point, whether it is on the level set
  std::unordered_map<std::uint64_t, std::int64_t> Ids;
  std::vector<StuffingPiece> Pieces;
};

namespace
{

bool IsLongEdge(const LatticePoint& a, const LatticePoint& b)
{
  return ((a[0] ^ b[0]) & 1) == 0;
}

/// Whether the parity rule lets the diagonal begin at `a`, seen from the third corner `c`.
bool IsEven(const LatticePoint& a, const LatticePoint& c)
{
  const bool isCorner = (a[0] & 1) == 0;
  int positive = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    positive += (isCorner ? a[axis] - c[axis] : c[axis] - a[axis]) > 0 ? 1 : 0;
  }
  return positive % 2 == 0;
}

/// Whether the diagonal of the quadrilateral a, b, crossing(b c), crossing(a c) runs from a to
/// crossing(b c).
bool StartsAtFirst(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
{
  return IsLongEdge(a, b) ? IsEven(a, c) : IsLongEdge(b, c);
}

/// The four corners of a tetrahedron sorted by side, the one in question first.
struct Parts
{
  std::array<LatticePoint, 4> Own, Zero, Other;
  std::size_t Owns = 0, Zeros = 0, Others = 0;

  Parts(const StuffingWarp& warp, const LatticeTetrahedron& t, int side)
  {
    for (const LatticePoint& p : t)
    {
      const int its = warp.Side(p);
      if (its == side)
      {
        this->Own[this->Owns++] = p;
      }
      else if (its == 0)
      {
        this->Zero[this->Zeros++] = p;
      }
      else
      {
        this->Other[this->Others++] = p;
      }
    }
  }
};

StuffingCorner CornerAt(const LatticePoint& p)
{
  return { p, p };
}

void AppendTip(const Parts& parts, std::vector<StuffingPiece>& out)
{
  StuffingPiece piece{ CornerAt(parts.Own[0]) };
  std::size_t next = 1;
  for (std::size_t i = 0; i < parts.Zeros; ++i)
  {
    piece[next++] = CornerAt(parts.Zero[i]);
  }
  for (std::size_t i = 0; i < parts.Others; ++i)
  {
    piece[next++] = { parts.Own[0], parts.Other[i] };
  }
  out.push_back(piece);
}

void AppendPyramid(const Parts& parts, std::vector<StuffingPiece>& out)
{
  const LatticePoint &a = parts.Own[0], &b = parts.Own[1], &c = parts.Other[0];
  const StuffingCorner apex = CornerAt(parts.Zero[0]), ac{ a, c }, bc{ b, c };
  const StuffingCorner from = StartsAtFirst(a, b, c) ? CornerAt(a) : CornerAt(b);
  const StuffingCorner to = StartsAtFirst(a, b, c) ? bc : ac;
  out.push_back({ apex, from, to, StartsAtFirst(a, b, c) ? CornerAt(b) : CornerAt(a) });
  out.push_back({ apex, from, to, StartsAtFirst(a, b, c) ? ac : bc });
}

/// Prism of the triangles p0 p1 p2 and p3 p4 p5; the diagonal between rails i and i + 1 rises from
/// p_i to the far end of rail i + 1, or else falls. @pre not all three the same.
void AppendPrism(const std::array<StuffingCorner, 6>& p, const std::array<bool, 3>& rises,
  std::vector<StuffingPiece>& out)
{
  // The rail at whose lower end two diagonals meet: the one before it falls, the one after rises.
  std::size_t r = 0;
  while (!(rises[r] && !rises[(r + 2) % 3]))
  {
    ++r;
  }
  const std::size_t s = (r + 1) % 3, q = (r + 2) % 3;
  out.push_back({ p[r], p[r + 3], p[s + 3], p[q + 3] });
  // What is left is a pyramid over the quadrilateral between the other two rails.
  const bool up = rises[s];
  const StuffingCorner &from = up ? p[s] : p[q], &to = up ? p[q + 3] : p[s + 3];
  out.push_back({ p[r], from, to, up ? p[q] : p[s] });
  out.push_back({ p[r], from, to, up ? p[s + 3] : p[q + 3] });
}

void AppendThreeToOne(const Parts& parts, std::vector<StuffingPiece>& out)
{
  const LatticePoint& c = parts.Other[0];
  std::array<StuffingCorner, 6> corners;
  std::array<bool, 3> rises;
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[i] = CornerAt(parts.Own[i]);
    corners[i + 3] = { parts.Own[i], c };
    rises[i] = StartsAtFirst(parts.Own[i], parts.Own[(i + 1) % 3], c);
  }
  AppendPrism(corners, rises, out);
}

void AppendTwoToTwo(const Parts& parts, std::vector<StuffingPiece>& out)
{
  const LatticePoint &a = parts.Own[0], &b = parts.Own[1];
  const LatticePoint &c = parts.Other[0], &d = parts.Other[1];
  // Rails a b, (a c)(b c), (a d)(b d). One face's diagonal starts at a, the other's at b, so that
  // the third one, on the surface, is what keeps the prism from being cut in a circle.
  const bool toC = StartsAtFirst(a, b, c);
  const bool toD = StartsAtFirst(a, b, d);
  AppendPrism(
    { CornerAt(a), { a, c }, { a, d }, CornerAt(b), { b, c }, { b, d } }, { toC, !toC, !toD }, out);
}

}

void CutTetrahedron(
  const StuffingWarp& warp, const LatticeTetrahedron& t, int side, std::vector<StuffingPiece>& out)
{
  const Parts parts(warp, t, side);
  if (parts.Owns == 0)
  {
    return;
  }
  if (parts.Others == 0)
  {
    out.push_back({ CornerAt(t[0]), CornerAt(t[1]), CornerAt(t[2]), CornerAt(t[3]) });
  }
  else if (parts.Owns == 1)
  {
    AppendTip(parts, out);
  }
  else if (parts.Owns == 3)
  {
    AppendThreeToOne(parts, out);
  }
  else if (parts.Zeros == 0)
  {
    AppendTwoToTwo(parts, out);
  }
  else
  {
    AppendPyramid(parts, out);
  }
}

Point3 ComputePosition(const StuffingWarp& warp, const StuffingCorner& corner)
{
  return corner.IsCrossing() ? warp.Crossing(corner.From, corner.To) : warp.Position(corner.From);
}

namespace
{

bool IsMoved(const StuffingWarp& warp, const LatticePoint& p)
{
  return warp.Side(p) == 0;
}

class Straightener
{
public:
  Straightener(const StuffingLattice& lattice, StuffingWarp& warp)
    : Lattice(lattice)
    , Warp(warp)
    , Background(lattice)
  {
  }

  /// Processes all tetrahedra near the surface once; returns whether some points were released.
  bool Pass(const ProgressCallback& progress)
  {
    const std::int64_t before = this->Warp.NumberOfUnmoved();
    const std::int64_t layers = this->Lattice.Cells()[2];
    for (std::int64_t k = 0; k < layers; ++k)
    {
      Report(progress, static_cast<double>(k) / static_cast<double>(layers));
      this->Background.ForEachOctant(k, [&](const Octant& octant) { this->Visit(octant); });
    }
    return this->Warp.NumberOfUnmoved() > before;
  }

private:
  void Visit(const Octant& octant)
  {
    const LatticePoint& c = octant.First;
    if (octant.Level > 0 || !this->Lattice.IsNear(this->Lattice.Cell(c[0], c[1], c[2])))
    {
      return;
    }
    this->Tetrahedra.clear();
    this->Background.Append(octant, this->Tetrahedra);
    for (const LatticeTetrahedron& t : this->Tetrahedra)
    {
      while (this->IsBad(t))
      {
        this->ReleasePoints(t);
      }
    }
  }

  bool IsBad(const LatticeTetrahedron& t)
  {
    const auto moved = std::count_if(
      t.begin(), t.end(), [this](const LatticePoint& p) { return IsMoved(this->Warp, p); });
    if (moved == 0 || moved == 4)
    {
      return moved == 4;
    }
    this->Pieces.clear();
    CutTetrahedron(this->Warp, t, 1, this->Pieces);
    CutTetrahedron(this->Warp, t, -1, this->Pieces);
    for (const StuffingPiece& piece : this->Pieces)
    {
      const CellAngles angles = MeasureTetrahedron(ComputePosition(this->Warp, piece[0]),
        ComputePosition(this->Warp, piece[1]), ComputePosition(this->Warp, piece[2]),
        ComputePosition(this->Warp, piece[3]));
      if (angles.Smallest < StuffingSmallestAngle || angles.Largest > StuffingLargestAngle)
      {
        return true;
      }
    }
    return false;
  }

  void ReleasePoints(const LatticeTetrahedron& t)
  {
    const LatticePoint* farthest = nullptr;
    for (const LatticePoint& p : t)
    {
      if (IsMoved(this->Warp, p) &&
        (!farthest || this->Warp.MoveLength(p) > this->Warp.MoveLength(*farthest)))
      {
        farthest = &p;
      }
    }
    this->Warp.Keep(*farthest);
  }

  const StuffingLattice& Lattice;
  StuffingWarp& Warp;
  const StuffingBackground Background;
  std::vector<LatticeTetrahedron> Tetrahedra;
  std::vector<StuffingPiece> Pieces;
};

}

void KeepAngles(
  const StuffingLattice& lattice, StuffingWarp& warp, const ProgressCallback& progress)
{
  Straightener straightener(lattice, warp);
  double from = 0.0;
  bool again = true;
  while (again)
  {
    // Each pass takes half of the remaining progress.
    again = straightener.Pass(Between(progress, from, 0.5 * (1.0 + from)));
    from = 0.5 * (1.0 + from);
  }
}

std::int64_t StuffingOutput::PointId(const StuffingCorner& corner)
{
  // Points and middles of edges, in quarters of a cell, all differ: 21 bits for each number.
  std::uint64_t key = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    key |= static_cast<std::uint64_t>(corner.From[axis] + corner.To[axis]) << (21 * axis);
  }
  const auto [known, isNew] =
    this->Ids.emplace(key, static_cast<std::int64_t>(this->Result.Points.size()));
  if (isNew)
  {
    this->Result.Points.push_back(ComputePosition(this->Warp, corner));
    this->Surface.push_back(corner.IsCrossing() || this->Warp.Side(corner.From) == 0);
  }
  return known->second;
}

void StuffingOutput::Insert(const StuffingPiece& piece, int side)
{
  Tetrahedron t;
  for (std::size_t c = 0; c < 4; ++c)
  {
    t[c] = this->PointId(piece[c]);
  }
  const auto at = [&](std::size_t c)
  { return this->Result.Points[static_cast<std::size_t>(t[c])]; };
  if (Dot(Cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0)) < 0.0)
  {
    std::swap(t[2], t[3]);
  }
  this->Result.Tetrahedra.push_back(t);
  this->Result.Regions.push_back(side > 0 ? 1 : 0);
}

void StuffingOutput::AddWhole(const LatticeTetrahedron& t, int side)
{
  this->Insert({ { { t[0], t[0] }, { t[1], t[1] }, { t[2], t[2] }, { t[3], t[3] } } }, side);
}

void StuffingOutput::AddCut(const LatticeTetrahedron& t)
{
  for (const int side : { 1, -1 })
  {
    if (this->Wants(side))
    {
      this->Pieces.clear();
      CutTetrahedron(this->Warp, t, side, this->Pieces);
      for (const StuffingPiece& piece : this->Pieces)
      {
        this->Insert(piece, side);
      }
    }
  }
}

void Check(const StuffingParameters& parameters)
{
  RequireChoice("Side", parameters.Side, MeshedSide::Both);
  RequireRange("CellSize", parameters.CellSize, 0.0, Unlimited, "It is a length.");
  RequireRange("GradingLevels", parameters.GradingLevels, 0, 8);
  RequireRange("Margin", parameters.Margin, 0.0, Unlimited, "It is a length.");
}

namespace
{

void AddOctant(const StuffingLattice& lattice, const StuffingBackground& background,
  const Octant& octant, StuffingOutput& output, std::vector<LatticeTetrahedron>& scratch)
{
  const LatticePoint& c = octant.First;
  const bool isNear = octant.Level == 0 && lattice.IsNear(lattice.Cell(c[0], c[1], c[2]));
  const int side = lattice.IsInside(lattice.Node(octant.Center())) ? 1 : -1;
  if (!isNear && !output.Wants(side))
  {
    return;
  }
  scratch.clear();
  background.Append(octant, scratch);
  for (const LatticeTetrahedron& t : scratch)
  {
    if (isNear)
    {
      output.AddCut(t);
    }
    else
    {
      output.AddWhole(t, side);
    }
  }
}

}

IsosurfaceStuffingResult IsosurfaceStuffing(const std::function<double(const Point3&)>& field,
  const Bounds3& bounds, const StuffingParameters& parameters, const ProgressCallback& progress)
{
  Check(parameters);
  RequireAbove("CellSize", parameters.CellSize, 0.0, Unlimited, "It is a length.");
  StuffingLattice lattice(bounds, parameters);
  lattice.Sample(field, Between(progress, 0.0, 0.4));
  lattice.Grade(parameters.GradingLevels);
  StuffingWarp warp(lattice, Between(progress, 0.4, 0.5));
  KeepAngles(lattice, warp, Between(progress, 0.5, 0.7));
  const StuffingBackground background(lattice);
  StuffingOutput output(warp, parameters.Side);
  std::vector<LatticeTetrahedron> scratch;
  const std::int64_t layers = lattice.Cells()[2];
  for (std::int64_t k = 0; k < layers; ++k)
  {
    Report(progress, 0.7 + 0.3 * static_cast<double>(k) / static_cast<double>(layers));
    background.ForEachOctant(
      k, [&](const Octant& octant) { AddOctant(lattice, background, octant, output, scratch); });
  }
  IsosurfaceStuffingResult result;
  result.OnSurface = output.OnSurface();
  result.Mesh = std::move(output.Mesh());
  result.Mesh.OriginalPoints.assign(result.Mesh.Points.size(), -1);
  result.KeptPoints = warp.NumberOfUnmoved();
  Report(progress, 1.0);
  return result;
}

}
