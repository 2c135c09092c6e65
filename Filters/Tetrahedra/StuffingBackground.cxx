#include "Tetrahedra/StuffingBackground.h"

namespace isthmus
{

/// Does one of the cells around the edge belong to an octant below `level`?
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
  const LatticePoint centre = octant.Centre();
  LatticePoint middle;
  for (std::size_t a = 0; a < 3; ++a)
  {
    middle[a] = (face[0][a] + face[2][a]) / 2;
  }
  for (std::size_t e = 0; e < 4; ++e)
  {
    this->ForEachPart(face[e], face[(e + 1) % 4], octant.Level,
      [&](const LatticePoint& a, const LatticePoint& b) {
        out.push_back({ centre, middle, a, b });
      });
  }
}

void StuffingBackground::AppendHalves(const Octant& octant, const Octant& larger, const Face& face,
  std::vector<LatticeTetrahedron>& out) const
{
  const LatticePoint centre = octant.Centre();
  const LatticePoint other = larger.Centre();
  // The middle of the larger face is the corner of this one that lies beside the larger centre.
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
  out.push_back({ centre, face[q], face[(q + 1) % 4], face[(q + 2) % 4] });
  out.push_back({ centre, face[q], face[(q + 2) % 4], face[(q + 3) % 4] });
}

void StuffingBackground::Append(const Octant& octant, std::vector<LatticeTetrahedron>& out) const
{
  const std::int64_t side = octant.Side();
  const LatticePoint centre = octant.Centre();
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
        LatticePoint next = centre;
        next[axis] += 2 * side;
        for (std::size_t e = 0; e < 4; ++e)
        {
          this->ForEachPart(face[e], face[(e + 1) % 4], octant.Level,
            [&](const LatticePoint& a, const LatticePoint& b) {
              out.push_back({ centre, next, a, b });
            });
        }
      }
    }
  }
}

}
