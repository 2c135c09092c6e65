#include "Pockets/MolecularPockets.h"

#include "Atoms/PointBins.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RangeGuard.h"
#include "Pockets/CellAccess.h"
#include "Pockets/EmptySpace.h"
#include "Pockets/PocketLabels.h"
#include "Pockets/PocketMouths.h"

#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

void CheckLength(const char* name, double value)
{
  if (!(value > 0.0 && value <= 1000.0))
  {
    throw std::invalid_argument(std::string(name) + " is " + Shown(value) +
      ", but it is a length: give a positive number of angstrom, at most 1000.");
  }
}

void CheckOptions(const PocketOptions& options)
{
  CheckLength("InnerRadius", options.InnerRadius);
  CheckLength("OuterRadius", options.OuterRadius);
  CheckLength("BurialRadius", options.BurialRadius);
  if (!(options.ProbeRadius >= 0.0 && options.ProbeRadius <= options.InnerRadius))
  {
    throw std::invalid_argument("ProbeRadius is " + Shown(options.ProbeRadius) +
      ", but it must lie between 0 and InnerRadius, " + Shown(options.InnerRadius) + ".");
  }
  if (!(options.OuterRadius > options.InnerRadius))
  {
    throw std::invalid_argument("OuterRadius is " + Shown(options.OuterRadius) +
      ", but it must be larger than InnerRadius, " + Shown(options.InnerRadius) +
      ": a pocket is where the inner ball has room and the outer one does not come.");
  }
  if (!(options.MinimumVolume >= 0.0) || std::isinf(options.MinimumVolume))
  {
    throw std::invalid_argument("MinimumVolume is " + Shown(options.MinimumVolume) +
      ", but it must be a finite number and not negative.");
  }
}

/// The atoms by their place in space, which no order of a file changes.
std::vector<std::size_t> CanonicalOrder(const std::vector<Ball>& atoms)
{
  std::vector<std::size_t> order(atoms.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      return atoms[a].Centre != atoms[b].Centre ? atoms[a].Centre < atoms[b].Centre
                                                : atoms[a].Radius < atoms[b].Radius;
    });
  return order;
}

RegularFiltration Enlarged(const std::vector<Ball>& atoms, const std::vector<std::size_t>& order,
  double probe, const ProgressCallback& progress)
{
  std::vector<Point3> centres;
  std::vector<double> radii;
  for (const std::size_t i : order)
  {
    if (atoms[i].Radius < 0.0)
    {
      throw std::invalid_argument("Atom " + std::to_string(i) + " has the radius " +
        Shown(atoms[i].Radius) + ", but a radius is not negative.");
    }
    centres.push_back(atoms[i].Centre);
    radii.push_back(atoms[i].Radius + probe);
  }
  return MakeRegularFiltration(std::move(centres), std::move(radii), progress);
}

HandleVector<TetrahedronId, EmptyCell> EmptyCells(
  const RegularFiltration& f, const FacesByCell& faces, const ProgressCallback& progress)
{
  HandleVector<TetrahedronId, EmptyCell> empty(f.Complex.Tetrahedra.size());
  ParallelFor(
    0, static_cast<std::int64_t>(empty.size()), 1024,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (const TetrahedronId cell : HandleRange<TetrahedronId>(begin, end))
      {
        if (f.Complex.TetrahedronValue[cell] > 0.0)
        {
          empty[cell] = EmptySpaceOf(f, faces, cell);
        }
      }
    },
    progress);
  return empty;
}

/// What all pockets are made from.
struct Space
{
  RegularFiltration Filtration;
  CellAccess Access;
  HandleVector<TetrahedronId, EmptyCell> Empty;
  PocketByCell Cores; ///< of each tetrahedron with room for the inner ball
  PocketByCell Labels;
};

void FillCells(const Space& space, const PocketOptions& options, std::vector<Pocket>& pockets)
{
  const CellFiltration& c = space.Filtration.Complex;
  for (const TetrahedronId cell : space.Labels.Keys())
  {
    if (space.Labels[cell].Exists())
    {
      const auto& t = c.Tetrahedra[cell];
      pockets[space.Labels[cell].Index()].Cells.push_back({ { t[0], t[1], t[2], t[3] },
        space.Filtration.Centres[cell], space.Access.CellClearance[cell], space.Access.Access[cell],
        space.Empty[cell].Volume, 0 });
    }
  }
  const PointBins bins(c.Points, 0.5 * options.BurialRadius);
  ParallelFor(0, static_cast<std::int64_t>(pockets.size()), 1,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = begin; i < end; ++i)
      {
        for (PocketCell& cell : pockets[static_cast<std::size_t>(i)].Cells)
        {
          bins.Near(
            cell.Centre, options.BurialRadius, [&](std::int64_t, double) { ++cell.Burial; });
        }
      }
    });
}

void FillLining(const Space& space, std::vector<Pocket>& pockets)
{
  std::vector<std::map<std::int64_t, double>> areas(pockets.size());
  for (const TetrahedronId cell : space.Labels.Keys())
  {
    const PocketNumber pocket = space.Labels[cell];
    for (std::size_t k = 0; pocket.Exists() && k < 4; ++k)
    {
      areas[pocket.Index()][space.Filtration.Complex.Tetrahedra[cell][k]] +=
        space.Empty[cell].Area[k];
    }
  }
  constexpr double rounding = 1e-6; // angstrom^2
  for (std::size_t i = 0; i < pockets.size(); ++i)
  {
    for (const auto& [atom, area] : areas[i])
    {
      pockets[i].Area += area;
      if (area > rounding)
      {
        pockets[i].Lining.push_back({ atom, area });
      }
    }
  }
}

void Measure(Pocket& pocket)
{
  Point3 sum{ 0.0, 0.0, 0.0 };
  for (const PocketCell& cell : pocket.Cells)
  {
    const double share = cell.Volume * BurialWeight(static_cast<double>(cell.Burial));
    pocket.Volume += cell.Volume;
    pocket.Score += share;
    sum = sum + share * cell.Centre;
    pocket.Radius = std::max(pocket.Radius, cell.Clearance);
    pocket.Access = std::max(pocket.Access, cell.Access);
  }
  if (pocket.Score > 0.0)
  {
    pocket.Centre = (1.0 / pocket.Score) * sum;
    return;
  }
  // Only where mouths take more than there is among many atoms: then the room without them counts.
  double weights = 0.0;
  pocket.Score = 0.0;
  for (const PocketCell& cell : pocket.Cells)
  {
    const double weight = std::max(0.0, cell.Volume);
    weights += weight;
    pocket.Centre = pocket.Centre + weight * cell.Centre;
  }
  pocket.Centre = (1.0 / weights) * pocket.Centre;
}

/// Gives back the numbers that the caller's atoms have.
void Renumber(Pocket& pocket, const std::vector<std::size_t>& order)
{
  const auto number = [&](std::int64_t& atom)
  { atom = static_cast<std::int64_t>(order[static_cast<std::size_t>(atom)]); };
  for (PocketCell& cell : pocket.Cells)
  {
    std::for_each(cell.Atoms.begin(), cell.Atoms.end(), number);
  }
  for (PocketMouth& mouth : pocket.Mouths)
  {
    for (auto& triangle : mouth.Triangles)
    {
      std::for_each(triangle.begin(), triangle.end(), number);
    }
  }
  for (LiningAtom& lining : pocket.Lining)
  {
    number(lining.Atom);
  }
  std::sort(pocket.Lining.begin(), pocket.Lining.end(),
    [](const LiningAtom& a, const LiningAtom& b) { return a.Atom < b.Atom; });
}

void MeasureWhole(const Space& space, PocketResult& result)
{
  const CellFiltration& c = space.Filtration.Complex;
  for (const TetrahedronId cell : c.Tetrahedra.Keys())
  {
    const auto& t = c.Tetrahedra[cell];
    const Point3& p = c.Points[At(t[0])];
    const double volume = std::fabs(Dot(c.Points[At(t[1])] - p,
                            Cross(c.Points[At(t[2])] - p, c.Points[At(t[3])] - p))) /
      6.0;
    result.HullVolume += volume;
    const double empty = space.Empty[cell].Volume;
    result.FullVolume += volume - empty;
    (space.Labels[cell].Exists() ? result.PocketVolume : result.RestVolume) += empty;
  }
  const UnionMeasure whole = MeasureUnion(space.Filtration, space.Empty);
  result.UnionVolume = whole.Volume;
  result.UnionArea = whole.Area;
}

}

PocketResult FindPockets(
  const std::vector<Ball>& atoms, const PocketOptions& options, const ProgressCallback& progress)
{
  CheckOptions(options);
  const std::vector<std::size_t> order = CanonicalOrder(atoms);
  Space space;
  space.Filtration = Enlarged(atoms, order, options.ProbeRadius, Between(progress, 0.0, 0.4));
  const CellFiltration& c = space.Filtration.Complex;
  PocketResult result;
  if (c.Tetrahedra.empty())
  {
    return result;
  }
  const auto faces = FacesOfCells(c);
  space.Access = FindAccess(space.Filtration, faces, options.ProbeRadius);
  Report(progress, 0.5);
  space.Empty = EmptyCells(space.Filtration, faces, Between(progress, 0.5, 0.8));
  space.Cores = PocketCores(c, space.Access, options);
  space.Labels = WithCrevices(c, faces, space.Access, options.OuterRadius, space.Cores);
  MeasureWhole(space, result);
  Report(progress, 0.85);
  const PocketNumber last = *std::max_element(space.Labels.begin(), space.Labels.end());
  std::vector<Pocket> pockets(last.Exists() ? last.Index() + 1 : 0);
  FillCells(space, options, pockets);
  FillLining(space, pockets);
  AddMouths(space.Filtration, space.Access, space.Labels, options.InnerRadius, pockets);
  Report(progress, 0.95);
  for (Pocket& pocket : pockets)
  {
    Measure(pocket);
    if (pocket.Volume > 0.0 && pocket.Volume >= options.MinimumVolume)
    {
      Renumber(pocket, order);
      result.Pockets.push_back(std::move(pocket));
    }
  }
  std::stable_sort(result.Pockets.begin(), result.Pockets.end(),
    [](const Pocket& a, const Pocket& b) { return a.Score > b.Score; });
  Report(progress, 1.0);
  return result;
}

}
