#include "Tetrahedra/StuffingStencils.h"

namespace isthmus
{
namespace
{

bool IsLongEdge(const LatticePoint& a, const LatticePoint& b)
{
  return ((a[0] ^ b[0]) & 1) == 0;
}

/// Does the parity rule let the diagonal begin at `a`, seen from the third corner `c`?
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

/// Of the quadrilateral a, b, crossing(b c), crossing(a c): is its diagonal a to crossing(b c)?
bool StartsAtFirst(const LatticePoint& a, const LatticePoint& b, const LatticePoint& c)
{
  return IsLongEdge(a, b) ? IsEven(a, c) : IsLongEdge(b, c);
}

/// The four corners of a tetrahedron sorted by side, the one looked at first.
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

StuffingCorner At(const LatticePoint& p)
{
  return { p, p };
}

void AppendTip(const Parts& parts, std::vector<StuffingPiece>& out)
{
  StuffingPiece piece{ At(parts.Own[0]) };
  std::size_t next = 1;
  for (std::size_t i = 0; i < parts.Zeros; ++i)
  {
    piece[next++] = At(parts.Zero[i]);
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
  const StuffingCorner apex = At(parts.Zero[0]), ac{ a, c }, bc{ b, c };
  const StuffingCorner from = StartsAtFirst(a, b, c) ? At(a) : At(b);
  const StuffingCorner to = StartsAtFirst(a, b, c) ? bc : ac;
  out.push_back({ apex, from, to, StartsAtFirst(a, b, c) ? At(b) : At(a) });
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
    corners[i] = At(parts.Own[i]);
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
  AppendPrism({ At(a), { a, c }, { a, d }, At(b), { b, c }, { b, d } }, { toC, !toC, !toD }, out);
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
    out.push_back({ At(t[0]), At(t[1]), At(t[2]), At(t[3]) });
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

Point3 PositionOf(const StuffingWarp& warp, const StuffingCorner& corner)
{
  return corner.IsCrossing() ? warp.Crossing(corner.From, corner.To) : warp.Position(corner.From);
}

}
