#include "Pockets/MolecularPockets.h"

#include "Atoms/PointBins.h"
#include "Core/DisjointSets.h"
#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Pockets/CellAccessibility.h"
#include "Pockets/CellProgress.h"
#include "Pockets/EmptySpace.h"
#include "Pockets/PeriodicSpace.h"
#include "Pockets/PocketScore.h"
#include "Pockets/PocketSites.h"
#include "Pockets/SiteCopies.h"
#include "Pockets/SiteDescriptors.h"
#include "Pockets/SiteModel.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

/// A pocket, from 0 in the order of their first tetrahedra.
using PocketNumber = Handle<struct PocketKind, std::int32_t>;
using PocketByCell = HandleVector<TetrahedronId, PocketNumber>;

/// Empty space around a pocket that one of the paths has reached.
struct Path
{
  double Width;
  TetrahedronId Cell;
  PocketNumber Pocket;

  bool operator<(const Path& other) const
  {
    if (this->Width != other.Width)
    {
      return this->Width < other.Width;
    }
    // Ties by number, so that equally wide paths do not depend on the order of the queue.
    return this->Cell != other.Cell ? this->Cell > other.Cell : this->Pocket > other.Pocket;
  }
};

/// The pocket of each tetrahedron: tetrahedra with room for the inner ball that the outer one does
/// not reach, joined through triangles that let the inner one pass. O(n).
PocketByCell PocketCores(
  const CellFiltration& c, const CellAccessibility& access, const PocketOptions& options)
{
  const auto inside = [&](TetrahedronId cell)
  {
    return cell.Exists() && access.CellClearance[cell] > options.InnerRadius &&
      access.Access[cell] < options.OuterRadius;
  };
  DisjointSets<TetrahedronId> sets(c.Tetrahedra.size());
  for (const TriangleId t : c.Triangles())
  {
    const auto sides = c.TriangleSides(t);
    if (access.TriangleClearance[t] > options.InnerRadius && inside(sides[0]) && inside(sides[1]))
    {
      sets.Join(sides[0], sides[1]);
    }
  }
  PocketByCell numbers(c.Tetrahedra.size(), PocketNumber::None());
  PocketByCell labels(c.Tetrahedra.size(), PocketNumber::None());
  std::size_t count = 0;
  for (const TetrahedronId cell : labels.Keys())
  {
    if (inside(cell))
    {
      PocketNumber& number = numbers[sets.Find(cell)];
      number = number.Exists() ? number : PocketNumber::At(count++);
      labels[cell] = number;
    }
  }
  return labels;
}

/**
 * Assigns crevices to pockets: empty tetrahedra that are too narrow for the inner ball but that the
 * probe reaches from a pocket belong to the pocket with the widest path. A void therefore contains
 * all of its space. O(n log n).
 */
PocketByCell AddCrevices(const CellFiltration& c, const FacesByCell& faces,
  const CellAccessibility& access, double outer, const PocketByCell& cores,
  const ProgressCallback& progress)
{
  PocketByCell labels = cores;
  std::size_t reached = 0;
  std::priority_queue<Path> paths;
  const auto leave = [&](TetrahedronId cell)
  {
    for (const TriangleId face : faces[cell])
    {
      const TetrahedronId next = c.Across(face, cell);
      if (next.Exists() && !labels[next].Exists() && c.TriangleValue[face] > 0.0 &&
        access.Access[next] < outer)
      {
        paths.push({ access.TriangleClearance[face], next, labels[cell] });
      }
    }
  };
  for (const TetrahedronId cell : cores.Keys())
  {
    if (cores[cell].Exists())
    {
      ReportCells(progress, reached++, c.Tetrahedra.size());
      leave(cell);
    }
  }
  while (!paths.empty())
  {
    const Path path = paths.top();
    paths.pop();
    // The queue holds the widest path first, so the first that arrives is the widest.
    if (!labels[path.Cell].Exists())
    {
      labels[path.Cell] = path.Pocket;
      ReportCells(progress, reached++, c.Tetrahedra.size());
      leave(path.Cell);
    }
  }
  return labels;
}

/// Area of a triangle that is not covered by the balls at its corners.
double OpenArea(const RegularFiltration& f, const std::array<SimplexId, 3>& t)
{
  std::array<Point3, 3> corners;
  std::array<double, 3> radii{};
  for (std::size_t k = 0; k < 3; ++k)
  {
    corners[k] = f.Complex.Points[At(t[k])];
    radii[k] = f.VertexValue[At(t[k])] <= 0.0 ? f.Radii[At(t[k])] : 0.0;
  }
  return MeasureOpenArea(corners, radii);
}

/// A triangle through which a ball can leave a pocket.
struct OpenTriangle
{
  std::array<SimplexId, 3> Points; ///< ascending, at the side of the pocket
  double Clearance;
};

/// The open triangles of one pocket, in their order, with the group of each.
std::vector<PocketMouth> Group(const RegularFiltration& f, const std::vector<OpenTriangle>& open)
{
  DisjointSets<std::size_t> sets(open.size());
  std::map<std::pair<SimplexId, SimplexId>, std::size_t> firstAt;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    const auto& t = open[i].Points;
    for (const auto& edge : { std::pair(t[0], t[1]), std::pair(t[0], t[2]), std::pair(t[1], t[2]) })
    {
      sets.Join(firstAt.emplace(edge, i).first->second, i);
    }
  }
  std::map<std::size_t, std::size_t> numberOf;
  std::vector<PocketMouth> mouths;
  for (std::size_t i = 0; i < open.size(); ++i)
  {
    const auto number = numberOf.emplace(sets.Find(i), mouths.size());
    if (number.second)
    {
      mouths.emplace_back();
    }
    PocketMouth& mouth = mouths[number.first->second];
    const auto& t = open[i].Points;
    mouth.Radius = std::max(mouth.Radius, open[i].Clearance);
    mouth.Area += OpenArea(f, t);
    mouth.Triangles.push_back({ t[0], t[1], t[2] });
    mouth.Clearance.push_back(open[i].Clearance);
  }
  std::stable_sort(mouths.begin(), mouths.end(),
    [](const PocketMouth& a, const PocketMouth& b) { return a.Radius > b.Radius; });
  return mouths;
}

/// The points of a triangle, ascending, as corners of the tetrahedron `cell`: in a crystal, those
/// of the tetrahedron on its other side may be copies.
std::array<SimplexId, 3> PointsOfFace(
  const CellFiltration& c, const FacesByCell& faces, TetrahedronId cell, TriangleId triangle)
{
  const auto& own = faces[cell];
  const auto corner =
    static_cast<std::size_t>(std::find(own.begin(), own.end(), triangle) - own.begin());
  const auto& t = c.Tetrahedra[cell];
  std::array<SimplexId, 3> points{ t[(corner + 1) % 4], t[(corner + 2) % 4], t[(corner + 3) % 4] };
  std::sort(points.begin(), points.end());
  return points;
}

/**
 * Adds to each pocket the triangles wider than `inner` that lead out of it (`labels`: the pocket of
 * each tetrahedron; with `outOfAll`, out of all pockets); those that share an edge are one mouth.
 * O(n log n).
 */
void AddMouths(const RegularFiltration& f, const FacesByCell& faces,
  const CellAccessibility& access, const PocketByCell& labels, double inner, bool outOfAll,
  std::vector<Pocket>& pockets, const ProgressCallback& progress)
{
  HandleVector<PocketNumber, std::vector<OpenTriangle>> open(pockets.size());
  const auto pocketOf = [&labels](TetrahedronId cell)
  { return cell.Exists() ? labels[cell] : PocketNumber::None(); };
  for (const TriangleId t : f.Complex.Triangles())
  {
    ReportCells(progress, t.Index(), f.Complex.TriangleCount());
    const auto sides = f.Complex.TriangleSides(t);
    const PocketNumber a = pocketOf(sides[0]);
    const PocketNumber b = pocketOf(sides[1]);
    const bool leads = outOfAll ? a.Exists() != b.Exists() : a != b;
    if (leads && access.TriangleClearance[t] > inner)
    {
      for (const TetrahedronId side : sides)
      {
        const PocketNumber pocket = pocketOf(side);
        if (pocket.Exists())
        {
          open[pocket].push_back(
            { PointsOfFace(f.Complex, faces, side, t), access.TriangleClearance[t] });
        }
      }
    }
  }
  for (std::size_t i = 0; i < pockets.size(); ++i)
  {
    pockets[i].Mouths = Group(f, open[PocketNumber::At(i)]);
  }
}

/// The atoms sorted by position, which does not depend on their order in the file.
std::vector<std::size_t> CanonicalOrder(const std::vector<Ball>& atoms)
{
  std::vector<std::size_t> order(atoms.size());
  std::iota(order.begin(), order.end(), std::size_t{ 0 });
  std::stable_sort(order.begin(), order.end(),
    [&](std::size_t a, std::size_t b)
    {
      return atoms[a].Center != atoms[b].Center ? atoms[a].Center < atoms[b].Center
                                                : atoms[a].Radius < atoms[b].Radius;
    });
  return order;
}

/// The atoms in that order. @throws std::invalid_argument for a negative radius.
std::vector<Ball> OrderedAtoms(
  const std::vector<Ball>& atoms, const std::vector<std::size_t>& order)
{
  std::vector<Ball> ordered;
  for (const std::size_t i : order)
  {
    if (atoms[i].Radius < 0.0)
    {
      throw std::invalid_argument("Atom " + std::to_string(i) + " has the radius " +
        FormatNumber(atoms[i].Radius) + ", but a radius must not be negative.");
    }
    ordered.push_back(atoms[i]);
  }
  return ordered;
}

RegularFiltration EnlargedFiltration(
  const std::vector<Ball>& atoms, const PocketOptions& options, const ProgressCallback& progress)
{
  std::vector<Point3> centers;
  std::vector<double> radii;
  for (const Ball& atom : atoms)
  {
    centers.push_back(atom.Center);
    radii.push_back(atom.Radius + options.ProbeRadius);
  }
  return MakeRegularFiltration(std::move(centers), std::move(radii), progress, options.Predicted);
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
          empty[cell] = MeasureEmptySpace(f, faces, cell);
        }
      }
    },
    progress);
  return empty;
}

/// The data from which all pockets are computed.
struct Space
{
  RegularFiltration Filtration;
  CellAccessibility Access;
  HandleVector<TetrahedronId, EmptyCell> Empty;
  PocketByCell Cores; ///< of each tetrahedron with room for the inner ball
  PocketByCell Labels;
};

/// Whether a tetrahedron has less than 1e-4 of the volume that its edges could enclose. Whether
/// such tetrahedra exist at a flat side of the hull depends on the last bits of the coordinates.
bool IsFlat(const CellFiltration& c, const std::array<SimplexId, 4>& t)
{
  constexpr double flat = 1e-4;
  const Point3& p = c.Points[At(t[0])];
  const Point3 u = c.Points[At(t[1])] - p, v = c.Points[At(t[2])] - p, w = c.Points[At(t[3])] - p;
  return std::fabs(Dot(u, Cross(v, w))) < flat * Length(u) * Length(v) * Length(w);
}

double TetrahedronVolume(const CellFiltration& c, const std::array<SimplexId, 4>& t)
{
  const Point3& p = c.Points[At(t[0])];
  return std::fabs(
           Dot(c.Points[At(t[1])] - p, Cross(c.Points[At(t[2])] - p, c.Points[At(t[3])] - p))) /
    6.0;
}

/// All but Burial.
void FillCells(const Space& space, std::vector<Pocket>& pockets)
{
  const CellFiltration& c = space.Filtration.Complex;
  for (const TetrahedronId cell : space.Labels.Keys())
  {
    if (space.Labels[cell].Exists())
    {
      const auto& t = c.Tetrahedra[cell];
      pockets[space.Labels[cell].Index()].Cells.push_back({ { t[0], t[1], t[2], t[3] },
        space.Filtration.Centers[cell], space.Access.CellClearance[cell], space.Access.Access[cell],
        space.Empty[cell].Volume, 0, TetrahedronVolume(c, t), IsFlat(c, t), 0.0 });
    }
  }
}

/// O(cells x atoms near).
void FillBurial(const CellFiltration& c, double reach, std::vector<Pocket>& pockets,
  const ProgressCallback& progress)
{
  std::vector<PocketCell*> cells;
  for (Pocket& pocket : pockets)
  {
    for (PocketCell& cell : pocket.Cells)
    {
      cells.push_back(&cell);
    }
  }
  const PointBins bins(c.Points, 0.5 * reach);
  ParallelFor(
    0, static_cast<std::int64_t>(cells.size()), 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = begin; i < end; ++i)
      {
        PocketCell& cell = *cells[static_cast<std::size_t>(i)];
        bins.Near(cell.Center, reach, [&](std::int64_t, double) { ++cell.Burial; });
      }
    },
    progress);
}

/// `isSites`: negative contributions of the rest of a pocket (EmptySpace.h) are ignored.
void FillLining(
  const Space& space, bool isSites, std::vector<Pocket>& pockets, const ProgressCallback& progress)
{
  std::vector<std::map<std::int64_t, double>> areas(pockets.size());
  for (const TetrahedronId cell : space.Labels.Keys())
  {
    ReportCells(progress, cell.Index(), space.Labels.size());
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
      pockets[i].Area += isSites ? std::max(0.0, area) : area;
      if (area > rounding)
      {
        pockets[i].Lining.push_back({ atom, area });
      }
    }
  }
}

/// Atoms sorted by position.
std::vector<SiteAtom> SortAtoms(std::vector<SiteAtom> atoms)
{
  std::stable_sort(atoms.begin(), atoms.end(),
    [](const SiteAtom& a, const SiteAtom& b) { return a.Place < b.Place; });
  return atoms;
}

/// Fills in SiteProbability and returns the places; flat tetrahedra are skipped.
std::vector<SitePlace> FillSiteProbabilities(
  const PocketOptions& options, std::vector<Pocket>& pockets, const ProgressCallback& progress)
{
  std::vector<PocketCell*> cells;
  for (Pocket& pocket : pockets)
  {
    for (PocketCell& cell : pocket.Cells)
    {
      if (!cell.IsFlat)
      {
        cells.push_back(&cell);
      }
    }
  }
  const SiteDescriptorTable table = DescribeSites(SortAtoms(*options.SiteAtoms),
    { cells.begin(), cells.end() }, options.KeepDescriptors, Between(progress, 0.0, 0.8));
  const auto width = static_cast<std::int64_t>(SiteDescriptorNames().size());
  const auto residues = static_cast<std::int64_t>(SiteResidueNames().size());
  std::vector<SitePlace> places(cells.size());
  ParallelFor(
    0, static_cast<std::int64_t>(cells.size()), 64,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto i = begin; i < end; ++i)
      {
        PocketCell& cell = *cells[static_cast<std::size_t>(i)];
        SitePlace& place = places[static_cast<std::size_t>(i)];
        const float* row = table.Descriptors.data() + i * width;
        cell.SiteProbability = PlaceProbability(row);
        place.Center = cell.Center;
        place.Probability = cell.SiteProbability;
        if (options.KeepDescriptors)
        {
          place.Descriptors.assign(row, row + width);
          const float* near = table.Residues.data() + i * residues;
          place.Descriptors.insert(place.Descriptors.end(), near, near + residues);
        }
      }
    },
    Between(progress, 0.8, 1.0));
  return places;
}

/// The cell of a pocket to which a place of the site model belongs.
struct CellPlace
{
  std::size_t Pocket, Cell;
  TetrahedronId Tetrahedron;
};

/// Places of all tetrahedra but flat ones, in the order of the pockets' cells.
std::vector<CellPlace> CollectPlaces(const PocketByCell& labels, const std::vector<Pocket>& pockets)
{
  std::vector<std::size_t> next(pockets.size(), 0);
  std::vector<CellPlace> places;
  for (const TetrahedronId cell : labels.Keys())
  {
    if (labels[cell].Exists())
    {
      const std::size_t pocket = labels[cell].Index();
      const std::size_t k = next[pocket]++;
      if (!pockets[pocket].Cells[k].IsFlat)
      {
        places.push_back({ pocket, k, cell });
      }
    }
  }
  return places;
}

/// The more probable tetrahedra of a site: at least a quarter of its most probable one.
std::vector<std::size_t> LikelyPlaces(
  const PocketSite& site, const std::vector<double>& probabilities)
{
  double most = 0.0;
  for (const std::size_t i : site.Places)
  {
    most = std::max(most, probabilities[i]);
  }
  std::vector<std::size_t> likely;
  std::copy_if(site.Places.begin(), site.Places.end(), std::back_inserter(likely),
    [&](std::size_t i) { return probabilities[i] >= 0.25 * most; });
  return likely;
}

/// The pocket to which most of these tetrahedra belong, if any.
PocketNumber FindParent(const std::vector<CellPlace>& places, const PocketByCell& pockets)
{
  std::map<PocketNumber, std::size_t> counts;
  for (const CellPlace& place : places)
  {
    if (pockets[place.Tetrahedron].Exists())
    {
      ++counts[pockets[place.Tetrahedron]];
    }
  }
  const auto most = std::max_element(
    counts.begin(), counts.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  return most == counts.end() ? PocketNumber::None() : most->first;
}

/**
 * The sites, the most probable first. `labels`: the region of the site model that each tetrahedron
 * is in, which `regions` are made of; becomes the site. `pockets`: the pocket of each tetrahedron.
 * `judged` becomes all places with their probabilities.
 */
std::vector<Pocket> DivideIntoSites(const CellFiltration& c, const PocketOptions& options,
  std::vector<Pocket> regions, const PocketByCell& pockets, PocketByCell& labels,
  std::vector<SitePlace>& judged, const ProgressCallback& progress)
{
  judged = FillSiteProbabilities(options, regions, Between(progress, 0.0, 0.8));
  const std::vector<CellPlace> places = CollectPlaces(labels, regions);
  std::vector<Point3> centers;
  std::vector<double> probabilities;
  for (const CellPlace& place : places)
  {
    const PocketCell& cell = regions[place.Pocket].Cells[place.Cell];
    centers.push_back(cell.Center);
    probabilities.push_back(cell.SiteProbability);
  }
  const std::vector<CopiedSite> found =
    GroupCopies(SortAtoms(*options.SiteAtoms), FindSites(centers, probabilities));
  double sum = 0.0;
  for (const CopiedSite& site : found)
  {
    sum += site.Site.Density;
  }
  std::fill(labels.begin(), labels.end(), PocketNumber::None());
  std::vector<Pocket> sites;
  std::map<PocketNumber, std::int64_t> parents;
  for (const CopiedSite& copied : found)
  {
    const PocketSite& from = copied.Site;
    Pocket site;
    std::vector<CellPlace> own;
    for (const std::size_t i : LikelyPlaces(from, probabilities))
    {
      own.push_back(places[i]);
      labels[places[i].Tetrahedron] = PocketNumber::At(sites.size());
      site.Cells.push_back(regions[places[i].Pocket].Cells[places[i].Cell]);
    }
    if (own.empty())
    {
      continue;
    }
    const PocketNumber parent = FindParent(own, pockets);
    if (parent.Exists())
    {
      site.Parent =
        parents.emplace(parent, static_cast<std::int64_t>(parents.size()) + 1).first->second;
    }
    site.Center = from.Center;
    site.Group = copied.Group;
    site.Chain = copied.Chain;
    site.Density = from.Density;
    site.Probability = SiteProbability(from.Density, sum > 0.0 ? from.Density / sum : 0.0);
    sites.push_back(std::move(site));
  }
  FillBurial(c, options.BurialRadius, sites, Between(progress, 0.8, 1.0));
  for (Pocket& site : sites)
  {
    ScoreSite(site);
  }
  return sites;
}

/// Restores the atom numbers of the caller.
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

void MeasureWhole(const Space& space, PocketResult& result, const ProgressCallback& progress)
{
  const CellFiltration& c = space.Filtration.Complex;
  const ProgressCallback sums = Between(progress, 0.0, 0.2);
  for (const TetrahedronId cell : c.Tetrahedra.Keys())
  {
    ReportCells(sums, cell.Index(), c.Tetrahedra.size());
    const double volume = TetrahedronVolume(c, c.Tetrahedra[cell]);
    result.HullVolume += volume;
    const double empty = space.Empty[cell].Volume;
    result.FullVolume += volume - empty;
    (space.Labels[cell].Exists() ? result.PocketVolume : result.RestVolume) += empty;
  }
  const UnionMeasure whole =
    MeasureUnion(space.Filtration, space.Empty, Between(progress, 0.2, 1.0));
  result.UnionVolume = whole.Volume;
  result.UnionArea = whole.Area;
}

/// For each tetrahedron of a pocket the shift by which it is connected to the others, through
/// triangles that the probe passes. O(n).
HandleVector<TetrahedronId, CellShift> ConnectPockets(
  const PeriodicSpace& crystal, const PocketByCell& labels)
{
  const CellFiltration& c = crystal.Filtration.Complex;
  HandleVector<TetrahedronId, CellShift> shifts(labels.size(), NoCellShift);
  HandleVector<TetrahedronId, char> isReached(labels.size(), 0);
  for (const TetrahedronId first : labels.Keys())
  {
    std::queue<TetrahedronId> next;
    const auto reach = [&](TetrahedronId cell, const CellShift& shift)
    {
      if (isReached[cell] == 0)
      {
        isReached[cell] = 1;
        shifts[cell] = shift;
        next.push(cell);
      }
    };
    if (labels[first].Exists())
    {
      reach(first, NoCellShift);
    }
    for (; !next.empty(); next.pop())
    {
      const TetrahedronId cell = next.front();
      for (std::size_t k = 0; k < 4; ++k)
      {
        const TetrahedronId other = c.Neighbours[cell][k];
        if (labels[other] == labels[cell] && c.TriangleValue[crystal.Faces[cell][k]] > 0.0)
        {
          reach(other, Add(shifts[cell], crystal.Steps[cell][k]));
        }
      }
    }
  }
  return shifts;
}

/// Volumes in one cell.
void MeasureCrystal(const PeriodicSpace& crystal, const PocketByCell& labels, PocketResult& result)
{
  result.HullVolume = crystal.Cell.Volume();
  for (const TetrahedronId cell : labels.Keys())
  {
    const EmptyCell& empty = crystal.Empty[cell];
    (labels[cell].Exists() ? result.PocketVolume : result.RestVolume) += empty.Volume;
    result.UnionArea += std::accumulate(empty.Area.begin(), empty.Area.end(), 0.0);
  }
  result.FullVolume = result.HullVolume - result.PocketVolume - result.RestVolume;
  result.UnionVolume = result.FullVolume;
}

/// The pockets of a crystal, each once: of a pocket without end, the part that one cell has.
PocketResult FindPocketsOfCrystal(const std::vector<Ball>& atoms,
  const std::vector<std::size_t>& order, const PocketOptions& options,
  const ProgressCallback& progress)
{
  PeriodicSpace crystal = MakePeriodicSpace(atoms, PeriodicCell(options.Cell), options.ProbeRadius,
    options.BurialRadius, options.Predicted, Between(progress, 0.0, 0.8));
  PocketResult result;
  Space space;
  space.Access = crystal.Access;
  space.Empty = crystal.Empty;
  const CellFiltration& c = crystal.Filtration.Complex;
  space.Cores = PocketCores(c, space.Access, options);
  space.Labels = AddCrevices(
    c, crystal.Faces, space.Access, options.OuterRadius, space.Cores, Between(progress, 0.8, 0.85));
  MeasureCrystal(crystal, space.Labels, result);
  const PocketNumber last = *std::max_element(space.Labels.begin(), space.Labels.end());
  std::vector<Pocket> pockets(last.Exists() ? last.Index() + 1 : 0);
  space.Filtration = crystal.Filtration;
  FillCells(space, pockets);
  // Around the tetrahedra as they are stored all atoms are among the images.
  FillBurial(c, options.BurialRadius, pockets, Between(progress, 0.85, 0.92));
  const auto shifts = ConnectPockets(crystal, space.Labels);
  std::vector<std::size_t> done(pockets.size(), 0);
  for (const TetrahedronId cell : space.Labels.Keys())
  {
    if (space.Labels[cell].Exists())
    {
      crystal.Move(cell, shifts[cell]);
      const std::size_t pocket = space.Labels[cell].Index();
      PocketCell& moved = pockets[pocket].Cells[done[pocket]++];
      moved.Center = crystal.Filtration.Centers[cell];
      const auto& corners = c.Tetrahedra[cell];
      std::copy(corners.begin(), corners.end(), moved.Atoms.begin());
    }
  }
  space.Filtration = std::move(crystal.Filtration);
  FillLining(space, false, pockets, Between(progress, 0.92, 0.96));
  AddMouths(space.Filtration, crystal.Faces, space.Access, space.Labels, options.InnerRadius, false,
    pockets, Between(progress, 0.96, 1.0));
  for (std::size_t i = 0; i < crystal.Images.size(); ++i)
  {
    result.Copies.push_back(space.Filtration.Complex.Points[i]);
    result.CopyAtoms.push_back(static_cast<std::int64_t>(order[crystal.Images[i].Atom]));
  }
  for (Pocket& pocket : pockets)
  {
    ScorePocket(pocket);
    if (pocket.Volume > 0.0 && pocket.Volume >= options.MinimumVolume)
    {
      result.Pockets.push_back(std::move(pocket));
    }
  }
  RankPockets(result.Pockets);
  Report(progress, 1.0);
  return result;
}

}

void Check(const PocketOptions& options)
{
  constexpr double longest = 1000.0;
  RequireAbove("InnerRadius", options.InnerRadius, 0.0, longest, "It is in angstrom.");
  RequireAbove("OuterRadius", options.OuterRadius, options.InnerRadius, longest,
    "It is larger than InnerRadius: a pocket has room for the inner ball and is not reached by the "
    "outer one.");
  RequireAbove("BurialRadius", options.BurialRadius, 0.0, longest, "It is in angstrom.");
  RequireRange(
    "ProbeRadius", options.ProbeRadius, 0.0, options.InnerRadius, "It is at most InnerRadius.");
  RequireRange("MinimumVolume", options.MinimumVolume, 0.0, Unlimited, "It is in angstrom^3.");
}

PocketResult FindPockets(
  const std::vector<Ball>& atoms, const PocketOptions& options, const ProgressCallback& progress)
{
  Check(options);
  const std::vector<std::size_t> order = CanonicalOrder(atoms);
  const std::vector<Ball> ordered = OrderedAtoms(atoms, order);
  if (!options.Cell.empty())
  {
    return FindPocketsOfCrystal(ordered, order, options, progress);
  }
  Space space;
  space.Filtration = EnlargedFiltration(ordered, options, Between(progress, 0.0, 0.4));
  const CellFiltration& c = space.Filtration.Complex;
  PocketResult result;
  if (c.Tetrahedra.empty())
  {
    const UnionMeasure whole =
      MeasureFlatUnion(c.Points, space.Filtration.Radii, Between(progress, 0.4, 1.0));
    result.UnionVolume = whole.Volume;
    result.UnionArea = whole.Area;
    return result;
  }
  const auto faces = FacesOfCells(c);
  space.Access =
    FindAccess(space.Filtration, faces, options.ProbeRadius, Between(progress, 0.4, 0.5));
  Report(progress, 0.5);
  space.Empty = EmptyCells(space.Filtration, faces, Between(progress, 0.5, 0.8));
  space.Cores = PocketCores(c, space.Access, options);
  space.Labels = AddCrevices(
    c, faces, space.Access, options.OuterRadius, space.Cores, Between(progress, 0.8, 0.82));
  MeasureWhole(space, result, Between(progress, 0.82, 0.85));
  Report(progress, 0.85);
  const bool sites = options.SiteAtoms && !options.SiteAtoms->empty();
  const PocketByCell whole = space.Labels;
  if (sites)
  {
    PocketOptions region = options;
    region.InnerRadius = SiteInnerRadius;
    region.OuterRadius = SiteOuterRadius;
    space.Labels = AddCrevices(c, faces, space.Access, SiteOuterRadius,
      PocketCores(c, space.Access, region), Between(progress, 0.85, 0.86));
  }
  const PocketNumber last = *std::max_element(space.Labels.begin(), space.Labels.end());
  std::vector<Pocket> pockets(last.Exists() ? last.Index() + 1 : 0);
  FillCells(space, pockets);
  if (sites)
  {
    pockets = DivideIntoSites(c, options, std::move(pockets), whole, space.Labels,
      result.SitePlaces, Between(progress, 0.86, 0.92));
  }
  else
  {
    FillBurial(c, options.BurialRadius, pockets, Between(progress, 0.86, 0.92));
  }
  FillLining(space, sites, pockets, Between(progress, 0.92, 0.935));
  AddMouths(space.Filtration, faces, space.Access, space.Labels, options.InnerRadius, sites,
    pockets, Between(progress, 0.935, 0.95));
  Report(progress, 0.95);
  if (sites)
  {
    for (Pocket& pocket : pockets)
    {
      Renumber(pocket, order);
      for (PocketMouth& mouth : pocket.Mouths)
      {
        mouth.Area = std::max(0.0, mouth.Area);
      }
    }
    result.Pockets = std::move(pockets);
    Report(progress, 1.0);
    return result;
  }
  for (Pocket& pocket : pockets)
  {
    ScorePocket(pocket);
    if (pocket.Volume > 0.0 && pocket.Volume >= options.MinimumVolume)
    {
      Renumber(pocket, order);
      result.Pockets.push_back(std::move(pocket));
    }
  }
  RankPockets(result.Pockets);
  Report(progress, 1.0);
  return result;
}

}
