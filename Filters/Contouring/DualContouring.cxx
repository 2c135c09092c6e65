#include "Contouring/DualContouring.h"

#include "Contouring/ContourClusters.h"
#include "Contouring/HermiteGrid.h"
#include "Core/Geometry.h"
#include "Core/Index.h"
#include "Core/RangeChecks.h"
#include "Remeshing/SelfIntersections.h"
#include "Surfaces/HausdorffDistance.h"

#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <stdexcept>

namespace isthmus
{

namespace
{

/**
 * The coarsest contour of a hierarchy that is manifold, within the tolerance and free of crossings.
 *
 * Clusters are first chosen by their own errors; polygons that violate a condition then have their
 * clusters split, until none is violated. That ends, since the uniform contour is manifold. The
 * conditions, in this order:
 * 1. the polygons around each point form one ring of three or more (a chain at the grid's border);
 * 2. no corner, middle of an edge or middle of a triangle of this surface or the uniform one is
 *    farther than the tolerance from the other;
 * 3. with FreeOfCrossings, no two triangles cross. Where none of their points is a cluster, their
 *    quadrilaterals are cut (ContourClusters.h); where they still cross, their points move to the
 *    mean of their crossings. Triangles around such a point stay in the hull of its crossings,
 *    which is apart from those of the other points of its cell.
 *
 * O(n log n) per round; a few rounds. @throws Cancelled
 */
class Refinement
{
public:
  Refinement(const UniformContour& contour, const DualContouringParameters& parameters,
    const ProgressCallback& progress)
    : Contour(contour)
    , Parameters(parameters)
    , Clusters(contour, parameters, Between(progress, 0.0, 0.3))
    , IsAtBorder(contour.Points.size(), 0)
  {
    for (std::size_t p = 0; p < contour.Points.size(); ++p)
    {
      for (std::size_t a = 0; a < 3; ++a)
      {
        const std::int64_t i = contour.Cells[p][a];
        if (i == 0 || i + 2 == contour.Shape.Dimensions[a])
        {
          this->IsAtBorder[p] = 1;
        }
      }
    }
  }

  DualContour Run(const ProgressCallback& progress)
  {
    this->Extract();
    if (this->Parameters.Tolerance > 0.0)
    {
      this->MakeFine();
    }
    double done = 0.3;
    while (
      (this->Parameters.Tolerance > 0.0 && (this->SplitNonManifoldPoints() || this->SplitFar())) ||
      (this->Parameters.FreeOfCrossings && this->SplitCrossing()))
    {
      done += 0.1 * (1.0 - done);
      Report(progress, done);
      this->Clusters.Choose();
      this->Extract();
    }
    return this->MakeCompactContour();
  }

private:
  void Extract()
  {
    this->Polygons = BuildPolygons(this->Contour, this->Clusters, !this->Parameters.Quadrilaterals,
      this->Cuts ? &*this->Cuts : nullptr);
    this->IsOpen.assign(At(this->Clusters.Size()), 0);
    for (std::size_t p = 0; p < this->IsAtBorder.size(); ++p)
    {
      char& isOpen = this->IsOpen[At(this->Clusters.Tops()[p])];
      isOpen = this->IsAtBorder[p] ? 1 : isOpen;
    }
  }

  void MakeFine()
  {
    DualContouringParameters noClusters = this->Parameters;
    noClusters.Tolerance = 0.0;
    const ContourClusters points(this->Contour, noClusters, {});
    const ContourPolygons polygons =
      BuildPolygons(this->Contour, points, !this->Parameters.Quadrilaterals, nullptr);
    this->Fine = Triangulate(polygons, points, this->EdgeOfFine);
  }

  /// Splits all clusters among the points of a crossed edge.
  bool SplitAround(std::int64_t edge)
  {
    bool any = false;
    for (const std::int64_t point : this->Contour.Edges[At(edge)].Around)
    {
      any = this->Clusters.Split(this->Clusters.Tops()[At(point)]) || any;
    }
    return any;
  }

  bool SplitNonManifoldPoints()
  {
    bool any = false;
    const NonManifoldPoints bad = FindNonManifoldPoints(this->Polygons, this->IsOpen);
    for (const std::int64_t edge : bad.Edges)
    {
      any = this->SplitAround(edge) || any;
    }
    for (const std::int64_t top : this->Clusters.Tops())
    {
      any = (top >= 0 && !bad.IsThere[At(top)] && this->Clusters.Split(top)) || any;
    }
    return any;
  }

  /// Corners of quadrilaterals 0, 1, 2 and 0, 2, 3; the crossed edge each triangle is around.
  static TriangleMesh Triangulate(const ContourPolygons& polygons, const ContourClusters& clusters,
    std::vector<std::int64_t>& edges)
  {
    TriangleMesh mesh;
    for (std::int64_t id = 0; id < clusters.Size(); ++id)
    {
      mesh.Points.push_back(clusters.GetPoint(id));
    }
    mesh.Points.insert(mesh.Points.end(), polygons.More.begin(), polygons.More.end());
    for (std::size_t i = 0; i < polygons.Corners.size(); ++i)
    {
      const auto& q = polygons.Corners[i];
      mesh.Triangles.push_back({ q[0], q[1], q[2] });
      edges.push_back(polygons.Edge[i]);
      if (q[3] >= 0)
      {
        mesh.Triangles.push_back({ q[0], q[2], q[3] });
        edges.push_back(polygons.Edge[i]);
      }
    }
    return mesh;
  }

  bool SplitFar()
  {
    std::vector<std::int64_t> edges;
    const TriangleMesh mesh = Triangulate(this->Polygons, this->Clusters, edges);
    bool any = false;
    for (const std::int64_t t : TrianglesFartherThan(mesh, this->Fine, this->Parameters.Tolerance))
    {
      any = this->SplitAround(edges[At(t)]) || any;
    }
    for (const std::int64_t t : TrianglesFartherThan(this->Fine, mesh, this->Parameters.Tolerance))
    {
      any = this->SplitAround(this->EdgeOfFine[At(t)]) || any;
    }
    return any;
  }

  bool SplitCrossing()
  {
    std::vector<std::int64_t> edges;
    TriangleMesh mesh = Triangulate(this->Polygons, this->Clusters, edges);
    this->MoveToWorld(mesh.Points); // rounding there may flip a sliver
    const std::vector<std::int64_t> crossing = SelfIntersections(mesh);
    this->StillCrossing = static_cast<std::int64_t>(crossing.size());
    if (crossing.empty())
    {
      return false;
    }
    if (!this->Cuts)
    {
      this->Cuts.emplace(this->Contour);
      this->IsCentered.assign(this->Contour.Points.size(), 0);
    }
    std::set<std::int64_t> bad;
    for (const std::int64_t t : crossing)
    {
      bad.insert(edges[At(t)]);
    }
    bool any = false;
    for (const std::int64_t edge : bad)
    {
      any = (this->IsFine(edge) ? this->CutOrCenter(edge) : this->SplitAround(edge)) || any;
    }
    this->MoveCentered();
    return this->CutAroundCentered() || any;
  }

  /// Points that left their cells return to them.
  bool ReturnToCells(std::int64_t edge)
  {
    bool any = false;
    for (const std::int64_t point : this->Contour.Edges[At(edge)].Around)
    {
      const Bounds3 box = CellBox(this->Contour.Shape, this->Contour.Cells[At(point)], 1, 0.0);
      const Point3& x = this->Clusters.GetPoint(point);
      bool isHome = true;
      for (std::size_t a = 0; a < 3; ++a)
      {
        isHome = isHome && x[a] >= box.Min[a] && x[a] <= box.Max[a];
      }
      if (!isHome)
      {
        this->Clusters.Move(
          point, this->Contour.Errors[At(point)].Least(box, this->Parameters.FeatureThreshold));
        any = true;
      }
    }
    return any;
  }

  bool CutOrCenter(std::int64_t edge)
  {
    if (this->ReturnToCells(edge))
    {
      return true;
    }
    if (!this->Cuts->Has(edge))
    {
      this->Cuts->Cut(edge);
      return true;
    }
    return this->Center(edge);
  }

  bool IsFine(std::int64_t edge) const
  {
    const auto& around = this->Contour.Edges[At(edge)].Around;
    return std::all_of(around.begin(), around.end(),
      [this](std::int64_t point) { return this->Clusters.Tops()[At(point)] == point; });
  }

  bool Center(std::int64_t edge)
  {
    bool any = false;
    for (const std::int64_t point : this->Contour.Edges[At(edge)].Around)
    {
      any = any || !this->IsCentered[At(point)];
      this->IsCentered[At(point)] = 1;
    }
    return any;
  }

  void MoveCentered()
  {
    std::map<std::int64_t, std::pair<Point3, int>> sums;
    for (const UniformContour::Edge& edge : this->Contour.Edges)
    {
      for (const std::int64_t point : edge.Around)
      {
        if (this->IsCentered[At(point)])
        {
          auto& [sum, count] = sums[point];
          sum = sum + edge.Crossing;
          ++count;
        }
      }
    }
    for (const auto& [point, sum] : sums)
    {
      this->Clusters.Move(point, (1.0 / sum.second) * sum.first);
    }
  }

  /// All quadrilaterals at a point that was moved, so that its triangles stay in its cell.
  bool CutAroundCentered()
  {
    bool any = false;
    for (std::int64_t e = 0; e < static_cast<std::int64_t>(this->Contour.Edges.size()); ++e)
    {
      const auto& around = this->Contour.Edges[At(e)].Around;
      if (this->Cuts->Has(e) ||
        std::none_of(around.begin(), around.end(),
          [this](std::int64_t point) { return this->IsCentered[At(point)] != 0; }))
      {
        continue;
      }
      if (this->IsFine(e))
      {
        this->Cuts->Cut(e);
        any = true;
      }
      else
      {
        any = this->SplitAround(e) || any;
      }
    }
    return any;
  }

  void MoveToWorld(std::vector<Point3>& points) const
  {
    if (this->Parameters.ToWorld)
    {
      this->Parameters.ToWorld(points);
    }
  }

  /// Only the points that are used.
  DualContour MakeCompactContour() const
  {
    DualContour result;
    std::vector<std::int64_t> ids(At(this->Clusters.Size()) + this->Polygons.More.size(), -1);
    for (std::array<std::int64_t, 4> q : this->Polygons.Corners)
    {
      for (std::int64_t& id : q)
      {
        if (id < 0)
        {
          continue;
        }
        std::int64_t& known = ids[At(id)];
        if (known < 0)
        {
          known = static_cast<std::int64_t>(result.Points.size());
          result.Points.push_back(id < this->Clusters.Size()
              ? this->Clusters.GetPoint(id)
              : this->Polygons.More[At(id - this->Clusters.Size())]);
        }
        id = known;
      }
      result.Polygons.push_back(q);
    }
    this->MoveToWorld(result.Points);
    result.Crossing = this->StillCrossing;
    return result;
  }

  const UniformContour& Contour;
  const DualContouringParameters& Parameters;
  ContourClusters Clusters;
  ContourPolygons Polygons;
  std::optional<ContourCuts> Cuts;
  std::vector<char> IsAtBorder; ///< of each point of the uniform contour
  std::vector<char> IsOpen;     ///< of each point or cluster that stands for one at the border
  std::vector<char> IsCentered; ///< of each point: moved to the mean of its crossings
  TriangleMesh Fine;            ///< the uniform contour
  std::vector<std::int64_t> EdgeOfFine; ///< crossed edge of each of its triangles
  std::int64_t StillCrossing = 0;
};

}

void Check(const DualContouringParameters& parameters)
{
  RequireRange("FeatureThreshold", parameters.FeatureThreshold, 0.0, 1.0);
  RequireRange("Reach", parameters.Reach, 0.0, 1.0, "It is in grid spacings.");
  RequireRange("Tolerance", parameters.Tolerance, 0.0, Unlimited,
    "It is a length; 0 stands for the surface of all cells.");
  if (parameters.FreeOfCrossings)
  {
    RequireThat(parameters.Reach == 0.0, "Reach", parameters.Reach,
      "FreeOfCrossings needs points that stay in their cells: set it to 0");
    RequireThat(!parameters.Quadrilaterals, "Quadrilaterals", 1.0,
      "FreeOfCrossings needs triangles: switch it off");
  }
}

namespace
{

/// Share of the crossings that lie, with one of an almost parallel plane, on the same edge. The two
/// sides of a sharp edge or corner are less parallel; cavities may face either way.
double ShareInThinWalls(const std::vector<GridCrossing>& crossings)
{
  constexpr double parallel = 0.7;
  std::size_t walls = 0;
  for (std::size_t i = 0; i + 1 < crossings.size(); ++i)
  {
    const GridCrossing& a = crossings[i];
    const GridCrossing& b = crossings[i + 1];
    walls +=
      a.Node == b.Node && a.Axis == b.Axis && std::abs(Dot(a.Normal, b.Normal)) > parallel ? 2 : 0;
  }
  return crossings.empty() ? 0.0
                           : static_cast<double>(walls) / static_cast<double>(crossings.size());
}

}

DualContour DualContouring(const HermiteGrid& grid, const DualContouringParameters& parameters,
  const ProgressCallback& progress)
{
  Check(parameters);
  const auto& n = grid.Shape.Dimensions;
  if (n[0] < 2 || n[1] < 2 || n[2] < 2)
  {
    throw std::invalid_argument("The grid has fewer than two nodes along an axis.");
  }
  const UniformContour uniform = MakeUniformContour(grid, parameters, Between(progress, 0.0, 0.5));
  Report(progress, 0.5);
  const ProgressCallback rest = Between(progress, 0.5, 1.0);
  DualContour contour = Refinement(uniform, parameters, rest).Run(rest);
  contour.ThinWalls = ShareInThinWalls(grid.Crossings);
  Report(progress, 1.0);
  return contour;
}

}
