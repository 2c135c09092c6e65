#include "Surfaces/SurfaceCoarsening.h"

#include "Core/Index.h"
#include "Core/ParallelFor.h"
#include "Surfaces/TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace isthmus
{
namespace
{

using Id = std::int32_t;

/// Cosine of the largest angle by which a collapse may turn a triangle.
constexpr double LeastTurn = 0.5;

/// The least ratio of twice a new triangle's area to its squared longest edge, unless the triangle
/// that it replaces is worse.
constexpr double LeastShape = 0.15;

/// Points where more edges meet stay.
constexpr std::size_t MostNeighbours = 24;

/// Edges collapse in the order of these parts of the size, so that points thin out evenly.
constexpr std::array<double, 5> Stages{ 0.25, 0.4, 0.6, 0.8, 1.0 };

/// Slabs with about the same number of points, processed in parallel; points near a neighbouring
/// slab follow on one thread. The number is fixed, since the result depends on it.
constexpr std::size_t Slabs = 4;

std::size_t U(Id i)
{
  return static_cast<std::size_t>(i);
}

/// The mesh while its edges collapse. Half edge 3 t + k runs from corner k of triangle t to the
/// next one.
class CollapsingMesh
{
public:
  CollapsingMesh(const SurfaceView& surface, const std::vector<double>& size,
    const std::vector<double>& tolerance);

  void Run(const ProgressCallback& progress);
  CoarseSurface Result() const;

private:
  class Remover;

  static Id Next(Id h) { return h % 3 == 2 ? h - 2 : h + 1; }
  static Id Previous(Id h) { return h % 3 == 0 ? h + 2 : h - 1; }
  Id From(Id h) const { return this->Corner[U(h)]; }
  Id To(Id h) const { return this->Corner[U(Next(h))]; }
  /// The next half edge that leaves the same point.
  Id Turn(Id h) const { return this->Opposite[U(Previous(h))]; }
  const Point3& Place(Id p) const { return this->Surface.Points[U(p)]; }

  void Connect();
  void AssignSlabs();
  std::vector<char> NearOtherSlabs() const;

  SurfaceView Surface;
  const std::vector<double>& Size;
  const std::vector<double>& Tolerance;
  std::vector<Id> Corner, Opposite; ///< by half edge; Corner is -1 when the triangle is removed
  std::vector<Id> Leaving;          ///< by point: a half edge that leaves it; -1: removed
  std::vector<Id> FirstRemoved;     ///< by triangle: the first removed point assigned to it, or -1
  std::vector<Id> NextRemoved;      ///< by point: the next one of the same triangle, or -1
  std::vector<char> Slab;           ///< by point
};

CollapsingMesh::CollapsingMesh(
  const SurfaceView& surface, const std::vector<double>& size, const std::vector<double>& tolerance)
  : Surface(surface)
  , Size(size)
  , Tolerance(tolerance)
  , Corner(3 * surface.Triangles.size())
  , Opposite(3 * surface.Triangles.size(), -1)
  , Leaving(surface.Points.size(), -1)
  , FirstRemoved(surface.Triangles.size(), -1)
  , NextRemoved(surface.Points.size(), -1)
  , Slab(surface.Points.size(), 0)
{
  for (std::size_t t = 0; t < surface.Triangles.size(); ++t)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      this->Corner[3 * t + k] = static_cast<Id>(surface.Triangles[t][k]);
      this->Leaving[At(surface.Triangles[t][k])] = static_cast<Id>(3 * t + k);
    }
  }
  this->Connect();
  this->AssignSlabs();
}

// Each half edge finds its opposite among those that leave its end.
void CollapsingMesh::Connect()
{
  std::vector<Id> first(this->Surface.Points.size() + 1, 0);
  for (const Id p : this->Corner)
  {
    ++first[U(p) + 1];
  }
  for (std::size_t i = 1; i < first.size(); ++i)
  {
    first[i] += first[i - 1];
  }
  std::vector<Id> leaving(this->Corner.size());
  std::vector<Id> next(first.begin(), first.end() - 1);
  for (std::size_t h = 0; h < this->Corner.size(); ++h)
  {
    leaving[U(next[U(this->Corner[h])]++)] = static_cast<Id>(h);
  }
  ParallelFor(0, static_cast<std::int64_t>(this->Corner.size()), 1 << 16,
    [&](std::int64_t begin, std::int64_t end)
    {
      for (auto h = static_cast<Id>(begin); h < end; ++h)
      {
        const auto* const from = leaving.data() + first[U(this->To(h))];
        const auto* const to = leaving.data() + first[U(this->To(h)) + 1];
        const auto* const found =
          std::find_if(from, to, [&](Id other) { return this->To(other) == this->From(h); });
        this->Opposite[U(h)] = *found;
      }
    });
}

// By rank along the longest side of the bounding box.
void CollapsingMesh::AssignSlabs()
{
  Bounds3 box{ this->Place(0), this->Place(0) };
  for (const Point3& p : this->Surface.Points)
  {
    box.Add(p);
  }
  const Point3 width = box.Max - box.Min;
  const auto axis =
    static_cast<std::size_t>(std::max_element(width.begin(), width.end()) - width.begin());
  std::vector<double> values;
  values.reserve(this->Surface.Points.size());
  for (const Point3& p : this->Surface.Points)
  {
    values.push_back(p[axis]);
  }
  for (std::size_t i = 1; i < Slabs; ++i)
  {
    const auto at = static_cast<std::ptrdiff_t>(i * values.size() / Slabs);
    std::nth_element(values.begin(), values.begin() + at, values.end());
    const double limit = values[static_cast<std::size_t>(at)];
    for (std::size_t p = 0; p < values.size(); ++p)
    {
      this->Slab[p] = this->Surface.Points[p][axis] > limit ? static_cast<char>(i) : this->Slab[p];
    }
  }
}

// Two edges from the points of another slab. Points farther away never get a neighbour next to
// another slab: a collapse only connects points that have a common neighbour which is as far away.
std::vector<char> CollapsingMesh::NearOtherSlabs() const
{
  std::vector<char> isNear(this->Slab.size(), 0);
  const auto mark = [&](const auto& isMarked)
  {
    std::vector<char> marked = isNear;
    for (std::size_t h = 0; h < this->Corner.size(); ++h)
    {
      if (this->Corner[h] >= 0 &&
        isMarked(this->From(static_cast<Id>(h)), this->To(static_cast<Id>(h))))
      {
        marked[U(this->Corner[h])] = 1;
      }
    }
    isNear.swap(marked);
  };
  mark([this](Id from, Id to) { return this->Slab[U(from)] != this->Slab[U(to)]; });
  mark([&isNear](Id, Id to) { return isNear[U(to)] != 0; });
  return isNear;
}

/// Removes points, one after the other. Several work at the same time in different slabs.
class CollapsingMesh::Remover
{
public:
  explicit Remover(CollapsingMesh& mesh)
    : Mesh(mesh)
  {
  }

  /// Removes u along the edge that leaves the shortest new edges, if this is allowed.
  void TryPoint(Id u, double part);

private:
  /// A triangle from the point that stays to two consecutive neighbours of the removed one.
  struct Replacement
  {
    Id Triangle;
    Point3 A, B;         ///< the neighbours
    Point3 Normal;       ///< of twice the area's length
    Point3 OverA, OverB; ///< a point p from the common corner projects inside where p * OverA >= 0,
                         ///< p * OverB >= 0, and their sum is at most the square of Normal
  };

  std::size_t FindCandidates(Id u, double part);
  bool ReplaceTriangles(Id u, std::size_t along);
  bool IsLinkIntact(std::size_t along) const;
  bool MovePoints(Id u, Id v);
  void Apply(Id u, std::size_t along);

  CollapsingMesh& Mesh;
  std::vector<Id> Ring;              ///< half edges that leave the point
  std::vector<Point3> Around;        ///< their ends
  std::vector<Replacement> Replaced; ///< all triangles but two
  std::vector<Id> Moved;             ///< removed points of the triangles, and the point itself
  std::vector<Id> NewTriangle;       ///< of these
  std::array<std::pair<double, std::size_t>, MostNeighbours> Candidates;
};

std::size_t CollapsingMesh::Remover::FindCandidates(Id u, double part)
{
  std::size_t found = 0;
  const Point3& place = this->Mesh.Place(u);
  for (std::size_t i = 0; i < this->Ring.size(); ++i)
  {
    const double size = this->Mesh.Size[U(this->Mesh.To(this->Ring[i]))];
    if (Distance(place, this->Around[i]) > part * std::min(this->Mesh.Size[U(u)], size))
    {
      continue;
    }
    double longest2 = 0.0; // in parts of the size
    for (std::size_t j = 0; j < this->Ring.size(); ++j)
    {
      const Point3 d = this->Around[j] - this->Around[i];
      const double limit = std::min(size, this->Mesh.Size[U(this->Mesh.To(this->Ring[j]))]);
      longest2 = std::max(longest2, Dot(d, d) / (limit * limit));
    }
    if (longest2 <= std::min(1.0, 2.5 * part * part))
    {
      this->Candidates[found++] = { longest2, i };
    }
  }
  std::sort(
    this->Candidates.begin(), this->Candidates.begin() + static_cast<std::ptrdiff_t>(found));
  return found;
}

/// Fills Replaced; false if a triangle would turn or get too thin.
bool CollapsingMesh::Remover::ReplaceTriangles(Id u, std::size_t along)
{
  this->Replaced.clear();
  const std::size_t count = this->Ring.size();
  const Point3& from = this->Mesh.Place(u);
  const Point3& to = this->Around[along];
  for (std::size_t i = 0; i < count; ++i)
  {
    if (i == along || (i + 1) % count == along)
    {
      continue;
    }
    const Point3& a = this->Around[i];
    const Point3& b = this->Around[(i + 1) % count];
    const Point3 before = Cross(a - from, b - from);
    const Point3 e = a - to, f = b - to, g = b - a;
    const Point3 after = Cross(e, f);
    const double oldArea = Length(before), newArea = Length(after);
    if (!(Dot(before, after) > LeastTurn * oldArea * newArea))
    {
      return false;
    }
    const double side2 = Dot(g, g);
    const double shape = newArea / std::max({ Dot(e, e), Dot(f, f), side2 });
    if (shape < LeastShape &&
      shape < oldArea / std::max({ Dot(a - from, a - from), Dot(b - from, b - from), side2 }))
    {
      return false;
    }
    this->Replaced.push_back({ this->Ring[i] / 3, a, b, after, Cross(after, e), Cross(f, after) });
  }
  return !this->Replaced.empty();
}

/// The ends of the edge have exactly two common neighbours, which keep three triangles each.
bool CollapsingMesh::Remover::IsLinkIntact(std::size_t along) const
{
  const CollapsingMesh& mesh = this->Mesh;
  const Id start = mesh.Leaving[U(mesh.To(this->Ring[along]))];
  std::size_t common = 0;
  std::size_t valence = 0;
  Id h = start;
  do
  {
    const Id w = mesh.To(h);
    const bool isCommon = std::any_of(
      this->Ring.begin(), this->Ring.end(), [&](Id other) { return mesh.To(other) == w; });
    if (isCommon)
    {
      ++common;
      const Id back = mesh.Opposite[U(h)];
      if (mesh.Turn(mesh.Turn(mesh.Turn(back))) == back)
      {
        return false;
      }
    }
    ++valence;
    h = mesh.Turn(h);
  } while (h != start && valence <= MostNeighbours);
  return common == 2 && h == start;
}

/// Assigns the removed points of the triangles around u to those that replace them; false if one
/// is too far away from all of them.
bool CollapsingMesh::Remover::MovePoints(Id u, Id v)
{
  const CollapsingMesh& mesh = this->Mesh;
  this->Moved.assign(1, u);
  for (const Id h : this->Ring)
  {
    for (Id p = mesh.FirstRemoved[U(h / 3)]; p >= 0; p = mesh.NextRemoved[U(p)])
    {
      this->Moved.push_back(p);
    }
  }
  this->NewTriangle.resize(this->Moved.size());
  const Point3& corner = mesh.Place(v);
  std::size_t guess = 0;
  for (std::size_t i = 0; i < this->Moved.size(); ++i)
  {
    const Id moved = this->Moved[i];
    const double most = std::min(mesh.Tolerance[U(v)], mesh.Tolerance[U(moved)]);
    const Point3 p = mesh.Place(moved) - corner;
    // Any triangle that is near enough will do; the one of the point before often is.
    const auto isNear = [&](const Replacement& t)
    {
      const double overA = Dot(p, t.OverA), overB = Dot(p, t.OverB);
      const double square = Dot(t.Normal, t.Normal), height = Dot(p, t.Normal);
      return overA >= 0.0 && overB >= 0.0 && overA + overB <= square &&
        height * height <= most * most * square;
    };
    std::size_t tried = 0;
    while (tried < this->Replaced.size() && !isNear(this->Replaced[guess % this->Replaced.size()]))
    {
      ++guess;
      ++tried;
    }
    guess %= this->Replaced.size();
    if (tried == this->Replaced.size())
    {
      double best = HUGE_VAL;
      for (std::size_t j = 0; j < this->Replaced.size(); ++j)
      {
        const Replacement& t = this->Replaced[j];
        const double square = SquaredDistanceToTriangle(mesh.Place(moved), { corner, t.A, t.B });
        guess = square < best ? j : guess;
        best = std::min(best, square);
      }
      if (!(best <= most * most))
      {
        return false;
      }
    }
    this->NewTriangle[i] = this->Replaced[guess].Triangle;
  }
  return true;
}

void CollapsingMesh::Remover::Apply(Id u, std::size_t along)
{
  CollapsingMesh& mesh = this->Mesh;
  const Id h = this->Ring[along];
  const Id v = mesh.To(h);
  const Id beside = mesh.Opposite[U(h)];
  for (const Id other : this->Ring)
  {
    mesh.FirstRemoved[U(other / 3)] = -1;
    mesh.Corner[U(other)] = v;
  }
  const auto join = [&mesh](Id a, Id b)
  {
    mesh.Opposite[U(a)] = b;
    mesh.Opposite[U(b)] = a;
    mesh.Leaving[U(mesh.From(a))] = a;
    mesh.Leaving[U(mesh.From(b))] = b;
  };
  join(mesh.Opposite[U(Next(h))], mesh.Opposite[U(Previous(h))]);
  join(mesh.Opposite[U(Next(beside))], mesh.Opposite[U(Previous(beside))]);
  std::fill_n(mesh.Corner.begin() + h / 3 * 3, 3, -1);
  std::fill_n(mesh.Corner.begin() + beside / 3 * 3, 3, -1);
  mesh.Leaving[U(u)] = -1;
  for (std::size_t i = 0; i < this->Moved.size(); ++i)
  {
    Id& first = mesh.FirstRemoved[U(this->NewTriangle[i])];
    mesh.NextRemoved[U(this->Moved[i])] = first;
    first = this->Moved[i];
  }
}

void CollapsingMesh::Remover::TryPoint(Id u, double part)
{
  const CollapsingMesh& mesh = this->Mesh;
  this->Ring.clear();
  this->Around.clear();
  const Id start = mesh.Leaving[U(u)];
  Id h = start;
  do
  {
    this->Ring.push_back(h);
    this->Around.push_back(mesh.Place(mesh.To(h)));
    h = mesh.Turn(h);
  } while (h != start && this->Ring.size() < MostNeighbours);
  if (h != start)
  {
    return;
  }
  const std::size_t found = this->FindCandidates(u, part);
  for (std::size_t i = 0; i < std::min<std::size_t>(found, 3); ++i)
  {
    const std::size_t along = this->Candidates[i].second;
    if (this->ReplaceTriangles(u, along) && this->IsLinkIntact(along) &&
      this->MovePoints(u, mesh.To(this->Ring[along])))
    {
      this->Apply(u, along);
      return;
    }
  }
}

void CollapsingMesh::Run(const ProgressCallback& progress)
{
  for (std::size_t stage = 0; stage < Stages.size(); ++stage)
  {
    Report(progress, static_cast<double>(stage) / static_cast<double>(Stages.size()));
    const std::vector<char> isNear = this->NearOtherSlabs();
    const auto count = static_cast<Id>(this->Surface.Points.size());
    const auto remove = [&](const auto& isMine)
    {
      Remover remover(*this);
      for (Id u = 0; u < count; ++u)
      {
        if (isMine(U(u)) && this->Leaving[U(u)] >= 0)
        {
          remover.TryPoint(u, Stages[stage]);
        }
      }
    };
    ParallelFor(0, Slabs, 1,
      [&](std::int64_t begin, std::int64_t end)
      {
        for (std::int64_t slab = begin; slab < end; ++slab)
        {
          remove([&](std::size_t u) { return this->Slab[u] == slab && !isNear[u]; });
        }
      });
    remove([&](std::size_t u) { return isNear[u] != 0; });
  }
}

CoarseSurface CollapsingMesh::Result() const
{
  CoarseSurface result;
  std::vector<vtkIdType> renamed(this->Surface.Points.size(), -1);
  for (std::size_t p = 0; p < renamed.size(); ++p)
  {
    if (this->Leaving[p] >= 0)
    {
      renamed[p] = static_cast<vtkIdType>(result.Mesh.Points.size());
      result.Mesh.Points.push_back(this->Surface.Points[p]);
      result.Origin.push_back(static_cast<std::int64_t>(p));
    }
  }
  result.Nearest.assign(renamed.size(), -1);
  std::vector<double> own(result.Mesh.Points.size(), 0.0);
  for (std::size_t t = 0; t < this->FirstRemoved.size(); ++t)
  {
    if (this->Corner[3 * t] < 0)
    {
      continue;
    }
    Triangle corners;
    std::array<Point3, 3> places;
    for (std::size_t k = 0; k < 3; ++k)
    {
      corners[k] = renamed[U(this->Corner[3 * t + k])];
      places[k] = this->Place(this->Corner[3 * t + k]);
    }
    const auto triangle = static_cast<std::int64_t>(result.Mesh.Triangles.size());
    result.Mesh.Triangles.push_back(corners);
    double farthest2 = 0.0;
    for (Id p = this->FirstRemoved[t]; p >= 0; p = this->NextRemoved[U(p)])
    {
      farthest2 = std::max(farthest2, SquaredDistanceToTriangle(this->Place(p), places));
      result.Nearest[U(p)] = triangle;
    }
    for (std::size_t k = 0; k < 3; ++k)
    {
      result.Nearest[U(this->Corner[3 * t + k])] = triangle;
    }
    for (const vtkIdType p : corners)
    {
      own[At(p)] = std::max(own[At(p)], std::sqrt(farthest2));
    }
  }
  result.Deviation = own;
  for (const Triangle& t : result.Mesh.Triangles)
  {
    const double most = std::max({ own[At(t[0])], own[At(t[1])], own[At(t[2])] });
    for (const vtkIdType p : t)
    {
      result.Deviation[At(p)] = std::max(result.Deviation[At(p)], most);
    }
  }
  return result;
}

}

CoarseSurface CoarsenSurface(const SurfaceView& surface, const std::vector<double>& size,
  const std::vector<double>& tolerance, const ProgressCallback& progress)
{
  if (surface.Points.empty())
  {
    return {};
  }
  CollapsingMesh mesh(surface, size, tolerance);
  mesh.Run(progress);
  return mesh.Result();
}

}
