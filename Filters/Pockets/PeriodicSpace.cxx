#include "Pockets/PeriodicSpace.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Pockets/CellProgress.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>

namespace isthmus
{
namespace
{

/// Multiples of 2^-32 angstrom: sums of them and of whole cells are exact, as far as 1e6 angstrom.
Point3 RoundForSums(const Point3& p)
{
  constexpr double grain = 1.0 / 4294967296.0;
  Point3 rounded{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    rounded[k] = grain * std::nearbyint(p[k] / grain);
  }
  return rounded;
}

PeriodicCell RoundForSums(const PeriodicCell& cell)
{
  std::vector<Point3> vectors;
  for (const Point3& vector : cell.GetVectors())
  {
    vectors.push_back(RoundForSums(vector));
  }
  return PeriodicCell(vectors);
}

/// The atoms' places in the cell. Those at a face may be on either side of it, so a place just
/// below the upper face is moved to the lower one, where a copy in the file would be.
std::vector<Point3> PlacesInCell(const std::vector<Ball>& atoms, const PeriodicCell& cell)
{
  constexpr double slack = 1e-9;
  std::vector<Point3> places;
  for (const Ball& atom : atoms)
  {
    const Point3 rounded = RoundForSums(atom.Center);
    const Point3 f = cell.Fractions(rounded);
    const CellShift into{ -static_cast<int>(std::floor(f[0] + slack)),
      -static_cast<int>(std::floor(f[1] + slack)), -static_cast<int>(std::floor(f[2] + slack)) };
    places.push_back(rounded + cell.Vector(into));
  }
  return places;
}

/// One of the atoms at each place, the largest; ascending.
std::vector<std::size_t> DistinctAtoms(
  const std::vector<Ball>& atoms, const std::vector<Point3>& places)
{
  std::map<Point3, std::size_t> at;
  for (std::size_t i = 0; i < atoms.size(); ++i)
  {
    const auto [found, isNew] = at.emplace(places[i], i);
    if (!isNew && atoms[found->second].Radius < atoms[i].Radius)
    {
      found->second = i;
    }
  }
  std::vector<std::size_t> distinct;
  distinct.reserve(at.size());
  for (const auto& [place, atom] : at)
  {
    distinct.push_back(atom);
  }
  std::sort(distinct.begin(), distinct.end());
  return distinct;
}

/// The atoms and their images within a margin around the cell, triangulated.
struct ImageBlock
{
  double Margin = 0.0;
  std::vector<AtomImage> Images;
  RegularFiltration Filtration;
};

ImageBlock TriangulateBlock(const std::vector<Ball>& atoms, const std::vector<Point3>& places,
  const std::vector<std::size_t>& distinct, const PeriodicCell& cell, double probe, double margin,
  const std::function<void(double)>& predicted, const ProgressCallback& progress)
{
  ImageBlock block;
  block.Margin = margin;
  Point3 beyond{};
  CellShift most{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    beyond[k] = margin / cell.Height(k);
    most[k] = static_cast<int>(std::ceil(beyond[k]));
  }
  std::vector<Point3> centers;
  std::vector<double> radii;
  for (const std::size_t atom : distinct)
  {
    const Point3 f = cell.Fractions(places[atom]);
    const auto isNear = [&](std::size_t k, int shift)
    { return f[k] + shift >= -beyond[k] && f[k] + shift <= 1.0 + beyond[k]; };
    CellShift s{};
    for (s[0] = -most[0]; s[0] <= most[0]; ++s[0])
    {
      for (s[1] = -most[1]; s[1] <= most[1] && isNear(0, s[0]); ++s[1])
      {
        for (s[2] = -most[2]; s[2] <= most[2] && isNear(1, s[1]); ++s[2])
        {
          if (s == NoCellShift || isNear(2, s[2]))
          {
            block.Images.push_back({ atom, s });
            centers.push_back(places[atom] + cell.Vector(s));
            radii.push_back(atoms[atom].Radius + probe);
          }
        }
      }
    }
  }
  block.Filtration =
    MakeRegularFiltration(std::move(centers), std::move(radii), progress, predicted);
  return block;
}

/// A tetrahedron modulo the cell: its atoms, sorted, with their shifts from the first one.
struct PeriodicTetrahedron
{
  std::array<AtomImage, 4> Corners;

  friend bool operator<(const PeriodicTetrahedron& a, const PeriodicTetrahedron& b)
  {
    return std::lexicographical_compare(
      a.Corners.begin(), a.Corners.end(), b.Corners.begin(), b.Corners.end());
  }
};

/// The tetrahedron modulo the cell, and its shift from the copy whose first corner is in the cell.
std::pair<PeriodicTetrahedron, CellShift> Reduce(const ImageBlock& block, TetrahedronId cell)
{
  PeriodicTetrahedron reduced{};
  const auto& corners = block.Filtration.Complex.Tetrahedra[cell];
  for (std::size_t k = 0; k < 4; ++k)
  {
    reduced.Corners[k] = block.Images[At(corners[k])];
  }
  std::sort(reduced.Corners.begin(), reduced.Corners.end());
  const CellShift shift = reduced.Corners[0].Shift;
  for (AtomImage& corner : reduced.Corners)
  {
    corner.Shift = Add(corner.Shift, Negative(shift));
  }
  return { reduced, shift };
}

/// Copies of the tetrahedra of the crystal in a block, one of each.
class PeriodicCopies
{
public:
  PeriodicCopies(const ImageBlock& block, const PeriodicCell& cell, double least)
    : Block(block)
  {
    const RegularFiltration& f = block.Filtration;
    const double largest =
      f.Radii.empty() ? 0.0 : *std::max_element(f.Radii.begin(), f.Radii.end());
    this->Needed = block.Margin;
    for (const TetrahedronId id : f.Complex.Tetrahedra.Keys())
    {
      const auto [reduced, shift] = Reduce(block, id);
      if (shift == NoCellShift)
      {
        this->Numbers.emplace(reduced, TetrahedronId::At(this->Copies.size()));
        this->Copies.push_back(id);
        // An atom outside the block changes the tetrahedron only if its ball comes nearer than
        // orthogonal to the sphere.
        const double reach = std::max(
          least, std::sqrt(std::max(0.0, f.Complex.TetrahedronValue[id] + largest * largest)));
        const Point3 at = cell.Fractions(f.Centers[id]);
        for (std::size_t k = 0; k < 3; ++k)
        {
          this->Needed =
            std::max(this->Needed, reach + cell.Height(k) * std::max(-at[k], at[k] - 1.0));
        }
      }
    }
  }

  /// The margin with which the spheres of all copies would lie in the block.
  double NeededMargin() const { return this->Needed; }

  std::size_t Count() const { return this->Copies.size(); }
  TetrahedronId Copy(TetrahedronId id) const { return this->Copies[id.Index()]; }

  /// The tetrahedron across a face, with its shift and the corner that is opposite to the face
  /// there; None: it is not among the copies.
  std::pair<PeriodicFace, CellShift> Across(TetrahedronId id, std::size_t corner) const
  {
    const CellFiltration& c = this->Block.Filtration.Complex;
    const TetrahedronId copy = this->Copy(id);
    const TetrahedronId next = c.Neighbours[copy][corner];
    constexpr std::pair<PeriodicFace, CellShift> none{ { TetrahedronId::None(), 0 }, NoCellShift };
    if (!next.Exists())
    {
      return none;
    }
    const auto [reduced, shift] = Reduce(this->Block, next);
    const auto number = this->Numbers.find(reduced);
    if (number == this->Numbers.end())
    {
      return none;
    }
    const auto& back = c.Neighbours[next];
    const auto at =
      static_cast<std::size_t>(std::find(back.begin(), back.end(), copy) - back.begin());
    const AtomImage& image = this->Block.Images[At(c.Tetrahedra[next][at])];
    const AtomImage opposite{ image.Atom, Add(image.Shift, Negative(shift)) };
    const auto& corners = c.Tetrahedra[this->Copy(number->second)];
    const auto isOpposite = [&](SimplexId p)
    {
      const AtomImage& other = this->Block.Images[At(p)];
      return other.Atom == opposite.Atom && other.Shift == opposite.Shift;
    };
    const auto place = std::find_if(corners.begin(), corners.end(), isOpposite);
    return { { number->second, static_cast<std::size_t>(place - corners.begin()) }, shift };
  }

private:
  const ImageBlock& Block;
  std::map<PeriodicTetrahedron, TetrahedronId> Numbers;
  std::vector<TetrahedronId> Copies;
  double Needed;
};

/// The space without its access; nothing where a neighbour is missing.
std::optional<PeriodicSpace> Identify(
  const ImageBlock& block, const PeriodicCopies& copies, const PeriodicCell& cell)
{
  const RegularFiltration& from = block.Filtration;
  const FacesByCell blockFaces = FacesOfCells(from.Complex);
  PeriodicSpace space(cell);
  CellFiltration& c = space.Filtration.Complex;
  c.Points = from.Complex.Points;
  space.Filtration.Radii = from.Radii;
  space.Images = block.Images;
  const std::size_t count = copies.Count();
  constexpr std::array<TriangleId, 4> noFaces{ TriangleId::None(), TriangleId::None(),
    TriangleId::None(), TriangleId::None() };
  c.Neighbours.resize(count);
  space.Steps.resize(count);
  space.Empty.resize(count);
  space.Faces.resize(count, noFaces);
  for (std::size_t i = 0; i < count; ++i)
  {
    const TetrahedronId id = TetrahedronId::At(i);
    const TetrahedronId copy = copies.Copy(id);
    c.Tetrahedra.push_back(from.Complex.Tetrahedra[copy]);
    c.TetrahedronValue.push_back(from.Complex.TetrahedronValue[copy]);
    space.Filtration.Centers.push_back(from.Centers[copy]);
    for (std::size_t k = 0; k < 4; ++k)
    {
      const auto [across, shift] = copies.Across(id, k);
      if (!across.Cell.Exists())
      {
        return std::nullopt;
      }
      c.Neighbours[id][k] = across.Cell;
      space.Steps[id][k] = shift;
      if (!space.Faces[id][k].Exists())
      {
        const TriangleId triangle = TriangleId::At(c.TriangleFaces.size());
        c.TriangleFaces.push_back(static_cast<SimplexId>(4 * i + k));
        c.TriangleValue.push_back(from.Complex.TriangleValue[blockFaces[copy][k]]);
        space.Faces[id][k] = triangle;
        space.Faces[across.Cell][across.Corner] = triangle;
      }
    }
  }
  ParallelFor(0, static_cast<std::int64_t>(count), 256,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TetrahedronId id : HandleRange<TetrahedronId>(begin, end))
      {
        if (c.TetrahedronValue[id] > 0.0)
        {
          space.Empty[id] = MeasureEmptySpace(from, blockFaces, copies.Copy(id));
        }
      }
    });
  // At the border of the block an atom may be hidden or attached that is not in the crystal.
  std::map<std::size_t, double> value;
  for (std::size_t i = 0; i < block.Images.size(); ++i)
  {
    if (block.Images[i].Shift == NoCellShift)
    {
      value[block.Images[i].Atom] = from.VertexValue[i];
    }
  }
  for (std::size_t i = 0; i < block.Images.size(); ++i)
  {
    space.Filtration.VertexValue.push_back(value[block.Images[i].Atom]);
    space.NumberOfImage.emplace(block.Images[i], static_cast<SimplexId>(i));
  }
  return space;
}

CellShift CrossShifts(const CellShift& a, const CellShift& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

/// The displacements between copies of a place that paths connect: up to three independent ones.
class Displacements
{
public:
  void Add(const CellShift& shift)
  {
    const CellShift zero{};
    const auto& own = this->Basis;
    const bool isNew = own.empty() ? shift != zero
      : own.size() == 1            ? CrossShifts(own[0], shift) != zero
      : own.size() == 2            ? this->Outside(shift) != 0
                                   : false;
    if (isNew)
    {
      this->Basis.push_back(shift);
    }
  }

  void Add(const Displacements& other)
  {
    for (const CellShift& shift : other.Basis)
    {
      this->Add(shift);
    }
  }

  bool Any() const { return !this->Basis.empty(); }

  /// Whether they add up to one along vector `axis` of the cell alone.
  bool Contain(std::size_t axis) const
  {
    CellShift along{};
    along[axis] = 1;
    return this->Basis.size() == 3 || (this->Basis.size() == 2 && this->Outside(along) == 0) ||
      (this->Basis.size() == 1 && CrossShifts(this->Basis[0], along) == CellShift{});
  }

private:
  /// 0 in the plane of the first two.
  int Outside(const CellShift& shift) const
  {
    const CellShift normal = CrossShifts(this->Basis[0], this->Basis[1]);
    return normal[0] * shift[0] + normal[1] * shift[1] + normal[2] * shift[2];
  }

  std::vector<CellShift> Basis;
};

/// Sets of tetrahedra joined by paths, with the displacement of each along the path.
class DisplacedSets
{
public:
  explicit DisplacedSets(std::size_t count)
    : Parents(count)
    , Members(count)
    , Periods(count)
  {
    for (std::size_t i = 0; i < count; ++i)
    {
      this->Parents[i] = { i, NoCellShift };
      this->Members[i] = { i };
    }
  }

  struct Place
  {
    std::size_t Root;
    CellShift Shift; ///< from the root
  };

  Place Find(std::size_t member)
  {
    const Place above = this->Parents[member];
    if (above.Root == member)
    {
      return above;
    }
    const Place place = this->Find(above.Root);
    this->Parents[member] = { place.Root, Add(above.Shift, place.Shift) };
    return this->Parents[member];
  }

  /// Connects `a` with the copy of `b` that is moved by `step`. Calls `leads` for all members that
  /// are connected with copies of themselves now and were not before. Returns the displacements
  /// between such copies.
  template <typename Leads>
  const Displacements& Connect(
    std::size_t a, std::size_t b, const CellShift& step, const Leads& leads)
  {
    const Place first = this->Find(a);
    const Place second = this->Find(b);
    const CellShift across = Add(Add(first.Shift, step), Negative(second.Shift));
    const bool swap = this->Members[first.Root].size() < this->Members[second.Root].size();
    const std::size_t root = swap ? second.Root : first.Root;
    const std::size_t under = swap ? first.Root : second.Root;
    Displacements joined = this->Periods[root];
    joined.Add(this->Periods[under]);
    if (root == under)
    {
      joined.Add(across);
    }
    for (const std::size_t part : { root, under })
    {
      if (joined.Any() && !this->Periods[part].Any())
      {
        std::for_each(this->Members[part].begin(), this->Members[part].end(), leads);
      }
    }
    this->Periods[root] = joined;
    if (root != under)
    {
      this->Parents[under] = { root, swap ? Negative(across) : across };
      auto& members = this->Members[root];
      members.insert(members.end(), this->Members[under].begin(), this->Members[under].end());
      this->Members[under] = {};
    }
    return this->Periods[root];
  }

private:
  std::vector<Place> Parents;
  std::vector<std::vector<std::size_t>> Members; ///< of roots
  std::vector<Displacements> Periods;            ///< of roots
};

/// Access and passages: triangles open from the widest to the narrowest.
void FindPassages(PeriodicSpace& space, double probe, const ProgressCallback& progress)
{
  const CellFiltration& c = space.Filtration.Complex;
  space.Access = MeasureClearance(space.Filtration, probe);
  const auto& width = space.Access.TriangleClearance;
  std::vector<TriangleId> order;
  for (const TriangleId t : c.Triangles())
  {
    order.push_back(t);
  }
  std::sort(order.begin(), order.end(),
    [&](TriangleId a, TriangleId b)
    { return width[a] != width[b] ? width[a] > width[b] : c.EntersLater(a, b); });
  DisplacedSets sets(c.Tetrahedra.size());
  std::array<bool, 3> isFound{};
  std::size_t done = 0;
  for (const TriangleId t : order)
  {
    ReportCells(progress, done++, order.size());
    const auto face = static_cast<std::uint32_t>(c.TriangleFaces[t]);
    const PeriodicFace side{ TetrahedronId::At(face / 4), face % 4 };
    const Displacements& periods = sets.Connect(side.Cell.Index(),
      c.Neighbours[side.Cell][side.Corner].Index(), space.Steps[side.Cell][side.Corner],
      [&](std::size_t member)
      {
        const TetrahedronId cell = TetrahedronId::At(member);
        space.Access.Access[cell] = std::min(width[t], space.Access.CellClearance[cell]);
      });
    for (std::size_t k = 0; k < 3; ++k)
    {
      if (!isFound[k] && periods.Contain(k))
      {
        isFound[k] = true;
        space.Passages[k] = { width[t], side };
      }
    }
  }
}

}

TetrahedronId PeriodicSpace::Widest() const
{
  const auto& clearance = this->Access.CellClearance;
  return TetrahedronId::At(static_cast<std::size_t>(
    std::max_element(clearance.begin(), clearance.end()) - clearance.begin()));
}

void PeriodicSpace::Move(TetrahedronId id, const CellShift& shift)
{
  RegularFiltration& f = this->Filtration;
  for (SimplexId& corner : f.Complex.Tetrahedra[id])
  {
    const AtomImage from = this->Images[At(corner)];
    const AtomImage to{ from.Atom, Add(from.Shift, shift) };
    const auto [found, isNew] =
      this->NumberOfImage.emplace(to, static_cast<SimplexId>(this->Images.size()));
    if (isNew)
    {
      const Point3 place = f.Complex.Points[At(corner)] + this->Cell.Vector(shift);
      const double radius = f.Radii[At(corner)], value = f.VertexValue[At(corner)];
      this->Images.push_back(to);
      f.Complex.Points.push_back(place);
      f.Radii.push_back(radius);
      f.VertexValue.push_back(value);
    }
    corner = found->second;
  }
  f.Centers[id] = f.Centers[id] + this->Cell.Vector(shift);
}

PeriodicSpace MakePeriodicSpace(const std::vector<Ball>& atoms, const PeriodicCell& cell,
  double probe, double reach, const std::function<void(double)>& predicted,
  const ProgressCallback& progress)
{
  if (atoms.empty())
  {
    throw std::invalid_argument("There are no atoms in the cell: check what the reader and the "
                                "filter drop.");
  }
  const PeriodicCell rounded = RoundForSums(cell);
  const std::vector<Point3> places = PlacesInCell(atoms, rounded);
  const std::vector<std::size_t> distinct = DistinctAtoms(atoms, places);
  // No place is farther from an atom's center than half the sum of the vectors.
  double margin = 10.0; // angstrom, enough for most crystals
  while (true)
  {
    Report(progress, 0.0);
    const ImageBlock block = TriangulateBlock(
      atoms, places, distinct, rounded, probe, margin, predicted, Between(progress, 0.0, 0.8));
    const PeriodicCopies copies(block, rounded, reach);
    if (copies.Count() > 0 && copies.NeededMargin() <= margin)
    {
      std::optional<PeriodicSpace> space = Identify(block, copies, rounded);
      if (space)
      {
        FindPassages(*space, probe, Between(progress, 0.8, 1.0));
        return std::move(*space);
      }
    }
    // At the border of a small block, spheres are larger than in the crystal.
    margin = std::min(2.0 * margin, std::max(1.2 * margin, copies.NeededMargin()));
  }
}

}
