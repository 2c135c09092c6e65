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
  this->Centres = this->Count[0] * this->Count[1] * this->Count[2];
  MemoryBudget::OfBytes(parameters.MaximumBytes)
    .Require(this->Bytes(),
      "A lattice of " + std::to_string(this->Centres) + " cells (cell size " +
        FormatNumber(this->Size) + ")",
      "choose a larger cell size");
}

double StuffingLattice::Bytes() const
{
  // A value and a warp a node; the marks of a cell, one of them twice while they grow, its level.
  return 9.0 * static_cast<double>(this->Nodes()) + 3.0 * static_cast<double>(this->Centres);
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

LatticePoint StuffingLattice::PointOf(std::int64_t node) const
{
  const bool centre = node >= this->Corners;
  const std::int64_t more = centre ? 0 : 1;
  const std::int64_t id = centre ? node - this->Corners : node;
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
        this->Values[static_cast<std::size_t>(node)] = field(this->Position(this->PointOf(node)));
      }
    },
    Between(progress, 0.0, 0.9));
  this->Near.assign(static_cast<std::size_t>(this->Centres), 0);
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
    ParallelFor(0, this->Centres, 1 << 16,
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

}
