#include "Contouring/ContourClusters.h"

#include "Contouring/HermiteGrid.h"

#include <algorithm>
#include <numeric>

namespace isthmus
{

namespace
{

std::int64_t FindRoot(std::vector<std::int64_t>& roots, std::int64_t id)
{
  const auto at = [&roots](std::int64_t i) -> std::int64_t&
  { return roots[static_cast<std::size_t>(i)]; };
  while (at(id) != id)
  {
    at(id) = at(at(id));
    id = at(id);
  }
  return id;
}

/// The cell of an octree, 2^depth grid cells each way, that has `index` in it.
Bounds3 OctreeCellBounds(
  const UniformContour& contour, UniformContour::Index index, int depth, double reach)
{
  for (std::int64_t& i : index)
  {
    i = i >> depth << depth;
  }
  return CellBox(contour.Shape, index, std::int64_t{ 1 } << depth, reach);
}

}

ContourClusters::ContourClusters(const UniformContour& contour,
  const DualContouringParameters& parameters, const ProgressCallback& progress)
  : NumberOfPoints(static_cast<std::int64_t>(contour.Points.size()))
  , Points(contour.Points)
  , Parent(contour.Points.size(), -1)
  , MayStand(contour.Points.size(), 1)
{
  if (parameters.Tolerance > 0.0)
  {
    Level level = this->Fine(contour);
    const auto& n = contour.Shape.Dimensions;
    const std::int64_t most = *std::max_element(n.begin(), n.end());
    int depth = 1;
    while (most >> (depth - 1) > 0 && this->AddLevel(level, depth, contour, parameters))
    {
      Report(progress, 1.0 - std::pow(0.3, depth));
      ++depth;
    }
  }
  this->Choose();
}

ContourClusters::Level ContourClusters::Fine(const UniformContour& contour) const
{
  Level level;
  for (std::int64_t p = 0; p < this->NumberOfPoints; ++p)
  {
    level.Clusters.push_back({ p, contour.Errors[At(p)] });
  }
  for (const UniformContour::Edge& edge : contour.Edges)
  {
    level.Edges.push_back(edge.Around);
    for (std::size_t i = 0; i < 4; ++i)
    {
      const std::int64_t a = edge.Around[i], b = edge.Around[(i + 1) % 4];
      level.Sides.push_back({ std::min(a, b), std::max(a, b) });
    }
  }
  std::sort(level.Sides.begin(), level.Sides.end());
  level.Sides.erase(std::unique(level.Sides.begin(), level.Sides.end()), level.Sides.end());
  level.Cells = contour.Cells;
  level.Euler.assign(contour.Points.size(), 1);
  return level;
}

/// Roots of clusters joined by sides inside a cell of this depth; these sides and the edges inside
/// such cells are counted for the Euler number of the root, and removed.
std::vector<std::int64_t> ContourClusters::JoinRoots(Level& level, int depth) const
{
  const auto isSame = [&level, depth](std::int64_t a, std::int64_t b)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (level.Cells[At(a)][axis] >> depth != level.Cells[At(b)][axis] >> depth)
      {
        return false;
      }
    }
    return true;
  };
  std::vector<std::int64_t> roots(this->Points.size());
  std::iota(roots.begin(), roots.end(), std::int64_t{ 0 });
  const auto outside = std::stable_partition(level.Sides.begin(), level.Sides.end(),
    [&](const auto& side) { return !isSame(side[0], side[1]); });
  std::for_each(outside, level.Sides.end(),
    [&](const auto& side)
    {
      const std::int64_t a = FindRoot(roots, side[0]), b = FindRoot(roots, side[1]);
      // The lowest number is the root, whatever the order of the sides.
      roots[At(std::max(a, b))] = std::min(a, b);
    });
  std::vector<int> more(this->Points.size(), 0);
  std::for_each(
    outside, level.Sides.end(), [&](const auto& side) { --more[At(FindRoot(roots, side[0]))]; });
  level.Sides.erase(outside, level.Sides.end());
  const auto inside = [&](const std::array<std::int64_t, 4>& edge)
  {
    const bool is =
      isSame(edge[0], edge[1]) && isSame(edge[0], edge[2]) && isSame(edge[0], edge[3]);
    more[At(FindRoot(roots, edge[0]))] += is ? 1 : 0;
    return is;
  };
  level.Edges.erase(
    std::remove_if(level.Edges.begin(), level.Edges.end(), inside), level.Edges.end());
  for (std::size_t i = 0; i < more.size(); ++i)
  {
    roots[i] = FindRoot(roots, static_cast<std::int64_t>(i));
    level.Euler[i] += more[i];
  }
  return roots;
}

bool ContourClusters::AddLevel(Level& level, int depth, const UniformContour& contour,
  const DualContouringParameters& parameters)
{
  const std::vector<std::int64_t> roots = this->JoinRoots(level, depth);
  constexpr auto none = static_cast<std::size_t>(-1);
  std::vector<int> members(roots.size(), 0);
  std::vector<std::size_t> place(roots.size(), none); // of a root's cluster among those that follow
  for (const Open& open : level.Clusters)
  {
    ++members[At(roots[At(open.Id)])];
  }
  std::vector<Open> next;
  const std::int64_t first = this->Size();
  for (const Open& open : level.Clusters)
  {
    const std::size_t root = At(roots[At(open.Id)]);
    if (members[root] == 1)
    {
      next.push_back(open);
      continue;
    }
    if (place[root] == none)
    {
      place[root] = next.size();
      next.push_back({ this->Size(), {} });
      this->Points.emplace_back();
      this->Parent.push_back(-1);
      level.Cells.push_back(UniformContour::Index(level.Cells[root]));
      level.Euler.push_back(0);
    }
    Open& cluster = next[place[root]];
    cluster.Errors.Add(open.Errors);
    level.Euler[At(cluster.Id)] += level.Euler[At(open.Id)];
    this->Parent[At(open.Id)] = cluster.Id;
  }
  this->MayStand.resize(this->Points.size(), 0);
  bool any = false;
  for (const Open& open : next)
  {
    if (open.Id >= first)
    {
      const bool near = this->Place(open,
        OctreeCellBounds(contour, level.Cells[At(open.Id)], depth, parameters.Reach), parameters);
      // Only a disc may shrink to a point: others would close a hole or join two sheets.
      this->MayStand[At(open.Id)] = near && level.Euler[At(open.Id)] == 1 ? 1 : 0;
      any = any || near;
    }
  }
  level.Clusters.swap(next);
  this->Relabel(level);
  return any;
}

/// Places a cluster at the point that fits its planes best; true if they fit well enough.
bool ContourClusters::Place(
  const Open& open, const Bounds3& box, const DualContouringParameters& parameters)
{
  Point3& x = this->Points[At(open.Id)];
  x = open.Errors.Least(box, parameters.FeatureThreshold);
  const auto count = static_cast<double>(open.Errors.NumberOfPlanes());
  return open.Errors.At(x) <= count * parameters.Tolerance * parameters.Tolerance;
}

void ContourClusters::Relabel(Level& level) const
{
  const auto relabel = [this](std::int64_t& id)
  { id = this->Parent[At(id)] < 0 ? id : this->Parent[At(id)]; };
  for (auto& side : level.Sides)
  {
    std::for_each(side.begin(), side.end(), relabel);
  }
  for (auto& edge : level.Edges)
  {
    std::for_each(edge.begin(), edge.end(), relabel);
  }
}

bool ContourClusters::Split(std::int64_t id)
{
  const bool did = this->IsCluster(id) && this->MayStand[At(id)];
  this->MayStand[At(id)] = this->IsCluster(id) ? 0 : 1;
  return did;
}

void ContourClusters::Choose()
{
  this->Top.assign(this->Points.size(), -1);
  for (std::int64_t id = this->Size() - 1; id >= 0; --id)
  {
    const std::int64_t parent = this->Parent[At(id)];
    const std::int64_t above = parent < 0 ? -1 : this->Top[At(parent)];
    this->Top[At(id)] = above >= 0 ? above : this->MayStand[At(id)] ? id : -1;
  }
}

namespace
{

using Pair = std::array<std::int64_t, 2>;

Pair MakeSortedPair(std::int64_t a, std::int64_t b)
{
  return { std::min(a, b), std::max(a, b) };
}

class Maker
{
public:
  Maker(const UniformContour& contour, const ContourClusters& clusters, bool triangles)
    : Contour(contour)
    , Clusters(clusters)
    , Triangles(triangles)
  {
  }

  /// Points on the faces around the cut polygons.
  void AddFacePoints(const ContourCuts& cuts)
  {
    for (std::size_t e = 0; e < this->Contour.Edges.size(); ++e)
    {
      if (!cuts.Has(static_cast<std::int64_t>(e)))
      {
        continue;
      }
      const UniformContour::Edge& edge = this->Contour.Edges[e];
      for (std::size_t i = 0; i < 4; ++i)
      {
        const std::int64_t a = edge.Around[i], b = edge.Around[(i + 1) % 4];
        const std::int64_t other = cuts.Beyond(static_cast<std::int64_t>(e), a, b);
        if (other >= 0 && this->FacePoints.count(MakeSortedPair(a, b)) == 0)
        {
          const Point3& there = this->Contour.Edges[static_cast<std::size_t>(other)].Crossing;
          this->FacePoints[MakeSortedPair(a, b)] = this->AddPoint(0.5 * (edge.Crossing + there));
        }
      }
    }
  }

  void AddPolygon(std::int64_t e)
  {
    const UniformContour::Edge& edge = this->Contour.Edges[static_cast<std::size_t>(e)];
    std::array<std::int64_t, 4> corners{ -1, -1, -1, -1 };
    std::size_t count = 0;
    for (const std::int64_t point : edge.Around)
    {
      const std::int64_t top = this->Clusters.Tops()[static_cast<std::size_t>(point)];
      if (count == 0 || corners[count - 1] != top)
      {
        corners[count++] = top;
      }
    }
    if (count > 1 && corners[0] == corners[count - 1])
    {
      corners[--count] = -1;
    }
    if (count < 3)
    {
      return;
    }
    // Folded onto itself: its clusters must be split again.
    if (count == 4 && (corners[0] == corners[2] || corners[1] == corners[3]))
    {
      this->Result.Folded.push_back(e);
      return;
    }
    if (!this->FacePoints.empty() && this->AddFan(e, corners, count))
    {
      return;
    }
    if (count == 3 || !this->Triangles)
    {
      this->Add(e, corners);
      return;
    }
    this->AddHalves(e, corners, edge.Normal);
  }

  ContourPolygons Result;

private:
  std::int64_t AddPoint(const Point3& x)
  {
    this->Result.More.push_back(x);
    return this->Clusters.Size() + static_cast<std::int64_t>(this->Result.More.size()) - 1;
  }

  void Add(std::int64_t e, const std::array<std::int64_t, 4>& corners)
  {
    this->Result.Corners.push_back(corners);
    this->Result.Edge.push_back(e);
  }

  /// Triangles around the crossing, if any side has a separate point.
  bool AddFan(std::int64_t e, const std::array<std::int64_t, 4>& corners, std::size_t count)
  {
    std::vector<std::int64_t> border;
    for (std::size_t i = 0; i < count; ++i)
    {
      border.push_back(corners[i]);
      const auto found =
        this->FacePoints.find(MakeSortedPair(corners[i], corners[(i + 1) % count]));
      if (found != this->FacePoints.end())
      {
        border.push_back(found->second);
      }
    }
    if (border.size() == count)
    {
      return false;
    }
    const std::int64_t middle =
      this->AddPoint(this->Contour.Edges[static_cast<std::size_t>(e)].Crossing);
    for (std::size_t i = 0; i < border.size(); ++i)
    {
      this->Add(e, { middle, border[i], border[(i + 1) % border.size()], -1 });
    }
    return true;
  }

  /// Cosine of the angle between triangle and `normal`; -1 for triangles without area, or too thin
  /// for a reliable normal, e.g. of three points on a sharp edge.
  double Agreement(std::int64_t a, std::int64_t b, std::int64_t c, const Point3& normal) const
  {
    const Point3 u = this->Clusters.GetPoint(b) - this->Clusters.GetPoint(a);
    const Point3 v = this->Clusters.GetPoint(c) - this->Clusters.GetPoint(a);
    const Point3 n = Cross(u, v);
    const double length = Length(n);
    constexpr double thin = 1e-6;
    return length > thin * (Dot(u, u) + Dot(v, v)) ? Dot(n, normal) / length : -1.0;
  }

  /// Distance of the midpoint of two corners from the planes that define the four points.
  double DistanceFromPlanes(std::int64_t e, std::int64_t a, std::int64_t b) const
  {
    const Point3 middle = 0.5 * (this->Clusters.GetPoint(a) + this->Clusters.GetPoint(b));
    double sum = 0.0;
    for (const std::int64_t point : this->Contour.Edges[static_cast<std::size_t>(e)].Around)
    {
      sum += this->Contour.Errors[static_cast<std::size_t>(point)].At(middle);
    }
    return sum;
  }

  /// Whether both are points of the uniform contour on sharp edges.
  bool AreSharp(std::int64_t a, std::int64_t b) const
  {
    const auto isSharp = [this](std::int64_t id)
    { return !this->Clusters.IsCluster(id) && this->Contour.IsSharp[At(id)] != 0; };
    return isSharp(a) && isSharp(b);
  }

  /// Cut along the diagonal that keeps a sharp edge, unless a triangle would then face backwards.
  void AddHalves(std::int64_t e, const std::array<std::int64_t, 4>& q, const Point3& normal)
  {
    const double first = std::min(
      this->Agreement(q[0], q[1], q[2], normal), this->Agreement(q[0], q[2], q[3], normal));
    const double second = std::min(
      this->Agreement(q[1], q[2], q[3], normal), this->Agreement(q[1], q[3], q[0], normal));
    const bool firstIsSharp = this->AreSharp(q[0], q[2]);
    const bool isFirst = !(first > 0.0 && second > 0.0) ? first >= second
      : firstIsSharp != this->AreSharp(q[1], q[3])
      ? firstIsSharp
      : this->DistanceFromPlanes(e, q[0], q[2]) <= this->DistanceFromPlanes(e, q[1], q[3]);
    const std::size_t turn = isFirst ? 0 : 1;
    this->Add(e, { q[turn], q[turn + 1], q[turn + 2], -1 });
    this->Add(e, { q[turn], q[turn + 2], q[(turn + 3) % 4], -1 });
  }

  const UniformContour& Contour;
  const ContourClusters& Clusters;
  bool Triangles;
  std::map<Pair, std::int64_t> FacePoints;
};

}

ContourCuts::ContourCuts(const UniformContour& contour)
  : IsCut(contour.Edges.size(), 0)
{
  for (std::size_t e = 0; e < contour.Edges.size(); ++e)
  {
    const auto& around = contour.Edges[e].Around;
    for (std::size_t i = 0; i < 4; ++i)
    {
      this->Sides.push_back(
        { MakeSortedPair(around[i], around[(i + 1) % 4]), static_cast<std::int64_t>(e) });
    }
  }
  std::sort(this->Sides.begin(), this->Sides.end(),
    [](const Side& a, const Side& b)
    { return a.Points != b.Points ? a.Points < b.Points : a.Edge < b.Edge; });
}

std::int64_t ContourCuts::Beyond(std::int64_t edge, std::int64_t a, std::int64_t b) const
{
  const Pair wanted = MakeSortedPair(a, b);
  auto side = std::lower_bound(this->Sides.begin(), this->Sides.end(), wanted,
    [](const Side& s, const Pair& points) { return s.Points < points; });
  for (; side != this->Sides.end() && side->Points == wanted; ++side)
  {
    if (side->Edge != edge)
    {
      return side->Edge;
    }
  }
  return -1;
}

ContourPolygons BuildPolygons(const UniformContour& contour, const ContourClusters& clusters,
  bool triangles, const ContourCuts* cuts)
{
  Maker maker(contour, clusters, triangles);
  if (cuts)
  {
    maker.AddFacePoints(*cuts);
  }
  for (std::size_t e = 0; e < contour.Edges.size(); ++e)
  {
    maker.AddPolygon(static_cast<std::int64_t>(e));
  }
  return std::move(maker.Result);
}

namespace
{

/// The corner of a polygon, and the ones after and before it.
struct Wedge
{
  std::int64_t Corner, Next, Before, Edge;
  bool operator<(const Wedge& o) const
  {
    return this->Corner != o.Corner ? this->Corner < o.Corner : this->Next < o.Next;
  }
};

using Wedges = std::vector<Wedge>;

/// All wedges of one corner, ordered by Next.
struct Around
{
  Wedges::const_iterator First, Last;

  std::size_t Size() const { return static_cast<std::size_t>(this->Last - this->First); }
  /// The wedge beyond the side towards Before; Size() when there is none.
  std::size_t After(std::size_t wedge) const
  {
    const std::int64_t side = this->First[static_cast<std::ptrdiff_t>(wedge)].Before;
    const auto found = std::lower_bound(
      this->First, this->Last, side, [](const Wedge& w, std::int64_t id) { return w.Next < id; });
    return found != this->Last && found->Next == side
      ? static_cast<std::size_t>(found - this->First)
      : this->Size();
  }
};

bool IsRing(const Around& around, bool mayBeOpen)
{
  const std::size_t count = around.Size();
  const auto sameNext = [](const Wedge& a, const Wedge& b) { return a.Next == b.Next; };
  if (std::adjacent_find(around.First, around.Last, sameNext) != around.Last)
  {
    return false;
  }
  std::vector<char> isReached(count, 0);
  for (std::size_t w = 0; w < count; ++w)
  {
    if (around.After(w) < count)
    {
      isReached[around.After(w)] = 1;
    }
  }
  const auto start =
    static_cast<std::size_t>(std::find(isReached.begin(), isReached.end(), 0) - isReached.begin());
  const bool isChain = start < count;
  const std::size_t first = isChain ? start : 0;
  std::size_t steps = 1;
  for (std::size_t w = around.After(first); w < count && w != first && steps <= count; ++steps)
  {
    w = around.After(w);
  }
  return steps == count && (isChain ? mayBeOpen : count >= 3);
}

Wedges CollectWedges(const ContourPolygons& polygons)
{
  Wedges wedges;
  for (std::size_t i = 0; i < polygons.Corners.size(); ++i)
  {
    const auto& q = polygons.Corners[i];
    const std::size_t count = q[3] < 0 ? 3 : 4;
    for (std::size_t c = 0; c < count; ++c)
    {
      wedges.push_back({ q[c], q[(c + 1) % count], q[(c + count - 1) % count], polygons.Edge[i] });
    }
  }
  std::sort(wedges.begin(), wedges.end());
  return wedges;
}

}

NonManifoldPoints FindNonManifoldPoints(
  const ContourPolygons& polygons, const std::vector<char>& mayBeOpen)
{
  NonManifoldPoints bad{ polygons.Folded, std::vector<char>(mayBeOpen.size(), 0) };
  const Wedges wedges = CollectWedges(polygons);
  for (auto first = wedges.begin(), last = first; first != wedges.end(); first = last)
  {
    const std::int64_t corner = first->Corner;
    last =
      std::find_if(first, wedges.end(), [corner](const Wedge& w) { return w.Corner != corner; });
    const auto at = static_cast<std::size_t>(corner);
    const bool isMore = at >= mayBeOpen.size();
    if (!isMore)
    {
      bad.IsThere[at] = 1;
    }
    if (!IsRing({ first, last }, isMore || mayBeOpen[at] != 0))
    {
      std::for_each(first, last, [&bad](const Wedge& w) { bad.Edges.push_back(w.Edge); });
    }
  }
  return bad;
}

}
