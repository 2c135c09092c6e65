#include "Atoms/MoleculeCartoon.h"
#include "Core/RangeChecks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

namespace isthmus
{
namespace
{

constexpr double ArrowFactor = 1.6;      ///< width of an arrow's head over that of its strand
constexpr double NucleotideFactor = 1.8; ///< diameter of a nucleic acid's tube over that of coil
constexpr double StrandExponent = 6.0;

Point3 NormalizedOr(const Point3& v, const Point3& otherwise)
{
  const double length = Length(v);
  return length > 1e-6 ? (1.0 / length) * v : otherwise;
}

/// Some unit vector perpendicular to the unit vector `t`.
Point3 AnyNormal(const Point3& t)
{
  const Point3 axis = std::abs(t[0]) < 0.7 ? Point3{ 1.0, 0.0, 0.0 } : Point3{ 0.0, 1.0, 0.0 };
  return NormalizedOr(Cross(t, axis), { 0.0, 0.0, 1.0 });
}

/// `v` without its part along the unit vector `t`; `otherwise` if nothing is left.
Point3 PerpendicularTo(const Point3& t, const Point3& v, const Point3& otherwise)
{
  return NormalizedOr(v - Dot(v, t) * t, otherwise);
}

/// Half axes and exponent of the superellipse.
struct Section
{
  double Wide;
  double Thin;
  double Exponent = 2.0;
};

Section Blend(const Section& a, const Section& b, double t)
{
  const double s = t * t * (3.0 - 2.0 * t);
  return { a.Wide + s * (b.Wide - a.Wide), a.Thin + s * (b.Thin - a.Thin),
    a.Exponent + s * (b.Exponent - a.Exponent) };
}

/// A place on the curve, with unit tangent and unit vector along the section's long axis.
struct Frame
{
  Point3 Place;
  Point3 Tangent;
  Point3 Side;
};

class Builder
{
public:
  Builder(CartoonMesh& mesh, std::int64_t sides)
    : Mesh(mesh)
    , Sides(std::max<std::int64_t>(3, sides))
  {
  }

  void AddPolygon(std::initializer_list<std::int64_t> corners, std::int64_t item)
  {
    this->Mesh.Corners.insert(this->Mesh.Corners.end(), corners);
    this->Mesh.Offsets.push_back(static_cast<std::int64_t>(this->Mesh.Corners.size()));
    this->Mesh.Items.push_back(item);
  }

  std::int64_t AddPoint(const Point3& place, const Point3& normal)
  {
    this->Mesh.Points.push_back(place);
    this->Mesh.Normals.push_back(normal);
    return static_cast<std::int64_t>(this->Mesh.Points.size()) - 1;
  }

  /// Its first point; the others follow.
  std::int64_t AddRing(const Frame& frame, const Section& section)
  {
    const auto first = static_cast<std::int64_t>(this->Mesh.Points.size());
    const Point3 other = Cross(frame.Tangent, frame.Side);
    const double power = 2.0 / section.Exponent;
    for (std::int64_t k = 0; k < this->Sides; ++k)
    {
      // Shifted by half a step, so that a strand's flat faces have an edge on each side.
      const double angle =
        2.0 * Pi * (static_cast<double>(k) + 0.5) / static_cast<double>(this->Sides);
      const double c = std::cos(angle);
      const double s = std::sin(angle);
      const double x = std::copysign(std::pow(std::abs(c), power), c);
      const double y = std::copysign(std::pow(std::abs(s), power), s);
      const double steep = section.Exponent - 1.0; // the gradient of the superellipse
      const double nx = std::copysign(std::pow(std::abs(x), steep), x) / section.Wide;
      const double ny = std::copysign(std::pow(std::abs(y), steep), y) / section.Thin;
      this->AddPoint(frame.Place + (section.Wide * x) * frame.Side + (section.Thin * y) * other,
        NormalizedOr(nx * frame.Side + ny * other, other));
    }
    return first;
  }

  void Join(std::int64_t ring, std::int64_t next, std::int64_t item)
  {
    for (std::int64_t k = 0; k < this->Sides; ++k)
    {
      const std::int64_t after = (k + 1) % this->Sides;
      this->AddPolygon({ ring + k, ring + after, next + after, next + k }, item);
    }
  }

  /// A flat cap over the section, facing along `direction` (1 or -1) times the tangent.
  void AddLid(const Frame& frame, const Section& section, double direction, std::int64_t item)
  {
    const Point3 normal = direction * frame.Tangent;
    const std::int64_t ring = this->AddRing(frame, section);
    for (std::int64_t k = 0; k < this->Sides; ++k)
    {
      this->Mesh.Normals[static_cast<std::size_t>(ring + k)] = normal;
    }
    const std::int64_t center = this->AddPoint(frame.Place, normal);
    for (std::int64_t k = 0; k < this->Sides; ++k)
    {
      const std::int64_t after = (k + 1) % this->Sides;
      if (direction > 0.0)
      {
        this->AddPolygon({ center, ring + k, ring + after }, item);
      }
      else
      {
        this->AddPolygon({ center, ring + after, ring + k }, item);
      }
    }
  }

  /// A cylinder without lids.
  void AddStick(const Point3& from, const Point3& to, double radius, std::int64_t item)
  {
    const Point3 along = to - from;
    if (!(Length(along) > 1e-6))
    {
      return;
    }
    const Point3 tangent = NormalizedOr(along, along);
    const Point3 side = AnyNormal(tangent);
    const Section round{ radius, radius };
    const std::int64_t ring = this->AddRing({ from, tangent, side }, round);
    this->Join(ring, this->AddRing({ to, tangent, side }, round), item);
  }

  void AddBall(const Point3& center, double radius, std::int64_t item)
  {
    if (this->UnitBall.Points.empty())
    {
      this->MakeUnitBall();
    }
    const auto first = static_cast<std::int64_t>(this->Mesh.Points.size());
    for (const Point3& p : this->UnitBall.Points)
    {
      this->AddPoint(center + radius * p, p);
    }
    for (std::size_t c = 0; c < this->UnitBall.Corners.size(); c += 3)
    {
      this->AddPolygon({ first + this->UnitBall.Corners[c], first + this->UnitBall.Corners[c + 1],
                         first + this->UnitBall.Corners[c + 2] },
        item);
    }
  }

private:
  /// An icosahedron, each triangle divided once, or twice where sections have many sides.
  void MakeUnitBall()
  {
    const double g = 0.5 * (1.0 + std::sqrt(5.0));
    const std::array<Point3, 12> corners{ { { -1, g, 0 }, { 1, g, 0 }, { -1, -g, 0 }, { 1, -g, 0 },
      { 0, -1, g }, { 0, 1, g }, { 0, -1, -g }, { 0, 1, -g }, { g, 0, -1 }, { g, 0, 1 },
      { -g, 0, -1 }, { -g, 0, 1 } } };
    for (const Point3& corner : corners)
    {
      this->UnitBall.Points.push_back(NormalizedOr(corner, corner));
    }
    this->UnitBall.Corners = { 0, 11, 5, 0, 5, 1, 0, 1, 7, 0, 7, 10, 0, 10, 11, 1, 5, 9, 5, 11, 4,
      11, 10, 2, 10, 7, 6, 7, 1, 8, 3, 9, 4, 3, 4, 2, 3, 2, 6, 3, 6, 8, 3, 8, 9, 4, 9, 5, 2, 4, 11,
      6, 2, 10, 8, 6, 7, 9, 8, 1 };
    this->DivideUnitBall();
    if (this->Sides > 8)
    {
      this->DivideUnitBall();
    }
  }

  void DivideUnitBall()
  {
    std::map<std::pair<std::int64_t, std::int64_t>, std::int64_t> middles;
    std::vector<Point3>& points = this->UnitBall.Points;
    const auto middle = [&](std::int64_t a, std::int64_t b)
    {
      const auto [at, isNew] = middles.try_emplace(
        { std::min(a, b), std::max(a, b) }, static_cast<std::int64_t>(points.size()));
      if (isNew)
      {
        const Point3 sum =
          points[static_cast<std::size_t>(a)] + points[static_cast<std::size_t>(b)];
        points.push_back(NormalizedOr(sum, sum));
      }
      return at->second;
    };
    std::vector<std::int64_t> divided;
    const std::vector<std::int64_t>& whole = this->UnitBall.Corners;
    for (std::size_t c = 0; c < whole.size(); c += 3)
    {
      const std::int64_t a = whole[c];
      const std::int64_t b = whole[c + 1];
      const std::int64_t d = whole[c + 2];
      const std::int64_t ab = middle(a, b);
      const std::int64_t bd = middle(b, d);
      const std::int64_t da = middle(d, a);
      divided.insert(divided.end(), { a, ab, da, ab, b, bd, da, bd, d, ab, bd, da });
    }
    this->UnitBall.Corners = std::move(divided);
  }

  CartoonMesh& Mesh;
  std::int64_t Sides;
  CartoonMesh UnitBall;
};

/// A piece of a chain: consecutive linked residues, and their curve.
class ChainPiece
{
public:
  ChainPiece(const std::vector<NamedAtom>& atoms, const std::vector<PolymerResidue>& residues,
    const std::vector<SecondaryStructure>& structure, std::size_t first, std::size_t last)
    : First(first)
    , Count(last - first + 1)
    , IsClosed(this->Count > 2 && AreLinked(atoms, residues[last], residues[first]))
    , IsProtein(residues[first].Kind == ResidueKind::AminoAcid)
    , Structure(structure.begin() + static_cast<std::ptrdiff_t>(first),
        structure.begin() + static_cast<std::ptrdiff_t>(last) + 1)
  {
    for (std::size_t r = first; r <= last; ++r)
    {
      this->Traces.push_back(atoms[static_cast<std::size_t>(residues[r].Trace())].Place);
    }
    this->DropShortRuns();
    this->FindControls();
    this->FindSides(atoms, residues);
  }

  std::size_t Spans() const { return this->IsClosed ? this->Count : this->Count - 1; }
  std::size_t Residue(std::size_t k) const { return this->First + k % this->Count; }
  bool HasLids() const { return !this->IsClosed; }
  const Point3& Control(std::size_t k) const { return this->Controls[k]; }

  /// Whether residue `k` is the last but one of a strand, where the arrow head begins.
  bool BeginsArrow(std::size_t k) const
  {
    return this->IsStrand(k) && k + 1 < this->Count && this->IsStrand(k + 1) &&
      (k + 2 == this->Count ? !this->IsClosed || !this->IsStrand(0) : !this->IsStrand(k + 2));
  }

  bool EndsArrow(std::size_t k) const
  {
    return k > 0 ? this->BeginsArrow(k - 1) : this->IsClosed && this->BeginsArrow(this->Count - 1);
  }

  SecondaryStructure StructureAt(std::size_t k) const { return this->Structure[k % this->Count]; }

  /// The curve at fraction `t` of the way from residue `k` to the next; `before` is the side
  /// before.
  Frame At(std::size_t k, double t, const Point3& before) const
  {
    const std::size_t next = (k + 1) % this->Count;
    const Point3& p = this->Controls[k];
    const Point3& q = this->Controls[next];
    const Point3& m = this->Tangents[k];
    const Point3& n = this->Tangents[next];
    const double tt = t * t;
    const double ttt = tt * t;
    Frame frame;
    frame.Place = (2.0 * ttt - 3.0 * tt + 1.0) * p + (ttt - 2.0 * tt + t) * m +
      (3.0 * tt - 2.0 * ttt) * q + (ttt - tt) * n;
    const Point3 slope = (6.0 * tt - 6.0 * t) * p + (3.0 * tt - 4.0 * t + 1.0) * m +
      (6.0 * t - 6.0 * tt) * q + (3.0 * tt - 2.0 * t) * n;
    frame.Tangent = NormalizedOr(slope, NormalizedOr(q - p, { 1.0, 0.0, 0.0 }));
    // Along the curve the sides of neighbours agree; only a closed one may have to turn at its end.
    const Point3& a = this->Sides[k];
    const Point3 b = Dot(a, this->Sides[next]) < 0.0 ? -1.0 * this->Sides[next] : this->Sides[next];
    frame.Side = PerpendicularTo(frame.Tangent, a + t * (b - a),
      PerpendicularTo(frame.Tangent, before, AnyNormal(frame.Tangent)));
    return frame;
  }

private:
  bool IsStrand(std::size_t k) const { return this->Structure[k] == SecondaryStructure::Strand; }

  /// Helices and strands of one residue are drawn as coil: a ribbon needs a direction.
  void DropShortRuns()
  {
    for (std::size_t k = 0; k < this->Count;)
    {
      std::size_t end = k;
      while (end < this->Count && this->Structure[end] == this->Structure[k])
      {
        ++end;
      }
      const bool isShort = end == k + 1 && this->IsProtein;
      if (isShort)
      {
        this->Structure[k] = SecondaryStructure::Coil;
      }
      k = end;
    }
  }

  void FindControls()
  {
    this->Controls = this->Traces;
    for (std::size_t k = 1; k + 1 < this->Count; ++k)
    {
      if (this->IsStrand(k))
      {
        this->Controls[k] =
          0.25 * (this->Traces[k - 1] + this->Traces[k + 1]) + 0.5 * this->Traces[k];
      }
    }
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      const bool isFirst = k == 0 && !this->IsClosed;
      const bool isLast = k + 1 == this->Count && !this->IsClosed;
      const Point3& before = this->Controls[isFirst ? k : (k + this->Count - 1) % this->Count];
      const Point3& after = this->Controls[isLast ? k : (k + 1) % this->Count];
      this->Tangents.push_back((isFirst || isLast ? 1.0 : 0.5) * (after - before));
    }
  }

  /// The side between residue `k` and the next: in the peptide plane, or the binormal.
  Point3 SideOfSpan(const std::vector<NamedAtom>& atoms,
    const std::vector<PolymerResidue>& residues, std::size_t k) const
  {
    const Point3 a = this->Traces[(k + 1) % this->Count] - this->Traces[k];
    const std::int64_t oxygen = residues[this->First + k].O;
    if (this->IsProtein && oxygen >= 0)
    {
      const Point3 b = atoms[static_cast<std::size_t>(oxygen)].Place - this->Traces[k];
      const Point3 side = Cross(Cross(a, b), a);
      if (Length(side) > 1e-3)
      {
        return NormalizedOr(side, side);
      }
    }
    const Point3 back = k > 0 ? this->Traces[k] - this->Traces[k - 1]
      : this->Count > 2       ? this->Traces[2] - this->Traces[1]
                              : Point3{ 0.0, 0.0, 0.0 };
    return NormalizedOr(Cross(back, a), AnyNormal(NormalizedOr(a, { 1.0, 0.0, 0.0 })));
  }

  void FindSides(const std::vector<NamedAtom>& atoms, const std::vector<PolymerResidue>& residues)
  {
    std::vector<Point3> spans;
    for (std::size_t k = 0; k < this->Spans(); ++k)
    {
      Point3 side = this->SideOfSpan(atoms, residues, k);
      if (k > 0 && Dot(side, spans.back()) < 0.0)
      {
        side = -1.0 * side;
      }
      spans.push_back(side);
    }
    for (std::size_t k = 0; k < this->Count; ++k)
    {
      const Point3& after = spans[std::min(k, spans.size() - 1)];
      const Point3& before = spans[k > 0 ? k - 1 : 0];
      this->Sides.push_back(NormalizedOr(before + after, after));
    }
    this->SmoothStrandSides();
  }

  void SmoothStrandSides()
  {
    const std::vector<Point3> rough = this->Sides;
    for (std::size_t k = 1; k + 1 < this->Count; ++k)
    {
      if (this->IsStrand(k))
      {
        this->Sides[k] = NormalizedOr(rough[k - 1] + 2.0 * rough[k] + rough[k + 1], rough[k]);
      }
    }
  }

  std::size_t First;
  std::size_t Count;
  bool IsClosed;
  bool IsProtein;
  std::vector<SecondaryStructure> Structure;
  std::vector<Point3> Traces;
  std::vector<Point3> Controls;
  std::vector<Point3> Tangents;
  std::vector<Point3> Sides;
};

Section GetSection(SecondaryStructure structure, const CartoonShape& shape)
{
  const double thin = 0.5 * shape.RibbonThickness;
  const double wide = 0.5 * shape.RibbonWidth;
  if (IsHelix(structure))
  {
    return { wide, thin };
  }
  if (structure == SecondaryStructure::Strand)
  {
    return { wide, thin, StrandExponent };
  }
  const double radius =
    structure == SecondaryStructure::NucleicAcid ? NucleotideFactor * thin : thin;
  return { radius, radius };
}

/// Section at residue `k`; where an arrow ends, that of coil.
Section SectionAt(const ChainPiece& piece, std::size_t k, const CartoonShape& shape)
{
  return GetSection(piece.EndsArrow(k) ? SecondaryStructure::Coil : piece.StructureAt(k), shape);
}

void DrawPiece(const ChainPiece& piece, const CartoonShape& shape, Builder& builder)
{
  const std::int64_t steps = std::max<std::int64_t>(2, shape.StepsPerResidue / 2 * 2);
  const auto item = [&piece](std::size_t k) { return static_cast<std::int64_t>(piece.Residue(k)); };
  Frame frame = piece.At(0, 0.0, {});
  Section section = SectionAt(piece, 0, shape);
  if (piece.HasLids())
  {
    builder.AddLid(frame, section, -1.0, item(0));
  }
  std::int64_t ring = builder.AddRing(frame, section);
  for (std::size_t k = 0; k < piece.Spans(); ++k)
  {
    const bool isArrow = piece.BeginsArrow(k);
    const Section next =
      SectionAt(piece, piece.HasLids() ? k + 1 : piece.Residue(k + 1) - piece.Residue(0), shape);
    Section from = section;
    if (isArrow)
    {
      from.Wide *= ArrowFactor;
      builder.AddLid(frame, from, -1.0, item(k));
      ring = builder.AddRing(frame, from);
    }
    for (std::int64_t step = 1; step <= steps; ++step)
    {
      const double t = static_cast<double>(step) / static_cast<double>(steps);
      frame = piece.At(k, t, frame.Side);
      section = Blend(from, next, t);
      if (isArrow)
      {
        section.Wide = from.Wide + t * (next.Wide - from.Wide); // straight edges
      }
      const std::int64_t following = builder.AddRing(frame, section);
      builder.Join(ring, following, item(2 * step <= steps ? k : k + 1));
      ring = following;
    }
  }
  if (piece.HasLids())
  {
    builder.AddLid(frame, section, 1.0, item(piece.Spans()));
  }
}

/// Sticks from the curve to where the bases face the other strand.
void DrawBases(const std::vector<NamedAtom>& atoms, const std::vector<PolymerResidue>& residues,
  const CartoonShape& shape, Builder& builder)
{
  const double radius = 1.5 * shape.StickRadius;
  for (std::size_t r = 0; r < residues.size(); ++r)
  {
    if (residues[r].Kind == ResidueKind::Nucleotide && residues[r].BaseEnd >= 0)
    {
      const Point3& from = atoms[static_cast<std::size_t>(residues[r].Trace())].Place;
      const Point3& to = atoms[static_cast<std::size_t>(residues[r].BaseEnd)].Place;
      builder.AddStick(from, to, radius, static_cast<std::int64_t>(r));
      builder.AddBall(to, radius, static_cast<std::int64_t>(r));
    }
  }
}

}

void Check(const CartoonShape& shape)
{
  constexpr double largest = 1e6; // larger than any molecule
  RequireAbove("RibbonWidth", shape.RibbonWidth, 0.0, largest, "It is in angstrom.");
  RequireAbove("RibbonThickness", shape.RibbonThickness, 0.0, largest, "It is in angstrom.");
  RequireAbove("StickRadius", shape.StickRadius, 0.0, largest, "It is in angstrom.");
  RequireRange("BallScale", shape.BallScale, 0.0, largest, "It multiplies radii.");
  RequireRange("Sides", static_cast<double>(shape.Sides), 3, 64);
}

void DrawCartoon(const std::vector<NamedAtom>& atoms, const std::vector<PolymerResidue>& residues,
  const std::vector<SecondaryStructure>& structure, const CartoonShape& shape, CartoonMesh& mesh,
  const ProgressCallback& progress)
{
  Check(shape);
  Builder builder(mesh, shape.Sides);
  for (std::size_t first = 0; first < residues.size();)
  {
    std::size_t last = first;
    while (residues[last].IsLinked)
    {
      ++last;
    }
    if (last > first)
    {
      DrawPiece(ChainPiece(atoms, residues, structure, first, last), shape, builder);
    }
    else if (residues[first].Kind != ResidueKind::Other)
    {
      builder.AddBall(atoms[static_cast<std::size_t>(residues[first].Trace())].Place,
        shape.RibbonThickness, static_cast<std::int64_t>(first));
    }
    first = last + 1;
    Report(progress, static_cast<double>(first) / static_cast<double>(residues.size()));
  }
  DrawBases(atoms, residues, shape, builder);
}

void DrawBallsAndSticks(const std::vector<NamedAtom>& atoms, const std::vector<DrawnBall>& balls,
  const std::vector<std::array<std::int64_t, 2>>& bonds, const CartoonShape& shape,
  CartoonMesh& mesh, const ProgressCallback& progress)
{
  Check(shape);
  constexpr std::size_t atOnce = 1024;
  Builder builder(mesh, shape.Sides);
  const double work = static_cast<double>(balls.size() + bonds.size());
  for (std::size_t b = 0; b < balls.size(); ++b)
  {
    if (b % atOnce == 0)
    {
      Report(progress, static_cast<double>(b) / work);
    }
    builder.AddBall(
      atoms[static_cast<std::size_t>(balls[b].Atom)].Place, balls[b].Radius, balls[b].Atom);
  }
  for (std::size_t b = 0; b < bonds.size(); ++b)
  {
    if (b % atOnce == 0)
    {
      Report(progress, static_cast<double>(balls.size() + b) / work);
    }
    const Point3& from = atoms[static_cast<std::size_t>(bonds[b][0])].Place;
    const Point3& to = atoms[static_cast<std::size_t>(bonds[b][1])].Place;
    const Point3 middle = 0.5 * (from + to);
    builder.AddStick(from, middle, shape.StickRadius, bonds[b][0]);
    builder.AddStick(middle, to, shape.StickRadius, bonds[b][1]);
  }
}

}
