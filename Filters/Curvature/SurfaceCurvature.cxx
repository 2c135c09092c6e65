#include "Curvature/SurfaceCurvature.h"

#include "Core/DisjointSets.h"
#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Curvature/CurvatureDescriptors.h"
#include "Curvature/EdgeTensor.h"
#include "Curvature/NormalFit.h"
#include "Surfaces/SurfaceCorrection.h"
#include "Surfaces/TriangleStars.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

/// The triangle (v, v + toA, v + toB) with the cotangents of its three angles.
struct Corner
{
  Vector3d ToA;
  Vector3d ToB;
  double TwiceArea;
  double CotV;
  double CotA;
  double CotB;
};

/// Part of the triangle's area that belongs to v.
double DualAreaPart(const Corner& corner, DualArea rule)
{
  const double area = 0.5 * corner.TwiceArea;
  if (rule == DualArea::Barycentric)
  {
    return area / 3.0;
  }
  if (rule == DualArea::Mixed && std::min({ corner.CotV, corner.CotA, corner.CotB }) < 0.0)
  {
    return corner.CotV < 0.0 ? area / 2.0 : area / 4.0;
  }
  return (corner.CotB * corner.ToA.squaredNorm() + corner.CotA * corner.ToB.squaredNorm()) / 8.0;
}

/// Sums over the triangles around a point; see the header for the formulas.
struct StarSums
{
  double Angle = 0.0;
  double Area = 0.0;
  Eigen::Vector3d Normal = Eigen::Vector3d::Zero();    ///< weighted with areas, not normalised
  Eigen::Vector3d Cotangent = Eigen::Vector3d::Zero(); ///< 4 A H n
  bool Degenerate = false; ///< a triangle has no area, within rounding; it is skipped
};

StarSums SumStar(
  const SurfaceView& mesh, const TriangleStars& stars, vtkIdType point, DualArea rule)
{
  StarSums sums;
  const PointMap v(mesh.Point(point).data());
  const MeshTriangle* const triangles = stars.Triangles(point);
  for (vtkIdType i = 0; i < stars.Size(point); ++i)
  {
    const auto [a, b] = stars.OppositeEdge(triangles[i], point);
    Corner corner;
    corner.ToA = PointMap(mesh.Point(a).data()) - v;
    corner.ToB = PointMap(mesh.Point(b).data()) - v;
    const Vector3d opposite = corner.ToB - corner.ToA;
    const Vector3d normal = corner.ToA.cross(corner.ToB);
    corner.TwiceArea = normal.norm();
    const double longest =
      std::max({ corner.ToA.squaredNorm(), corner.ToB.squaredNorm(), opposite.squaredNorm() });
    // Cotangents of a triangle without area are infinite.
    if (!(corner.TwiceArea > 1e-14 * longest))
    {
      sums.Degenerate = true;
      continue;
    }
    const double cosine = corner.ToA.dot(corner.ToB);
    corner.CotV = cosine / corner.TwiceArea;
    corner.CotA = -corner.ToA.dot(opposite) / corner.TwiceArea;
    corner.CotB = corner.ToB.dot(opposite) / corner.TwiceArea;
    // atan2 and not acos, which loses half of the digits at small angles.
    sums.Angle += std::atan2(corner.TwiceArea, cosine);
    sums.Area += DualAreaPart(corner, rule);
    sums.Normal += normal;
    sums.Cotangent -= corner.CotA * corner.ToB + corner.CotB * corner.ToA;
  }
  return sums;
}

constexpr double TwoPi = 6.28318530717958647692;

/// +1 where triangles are counter-clockwise seen from outside, -1 where clockwise.
double ComputeOrientation(
  const SurfaceView& mesh, const std::vector<StarKind>& kinds, SurfaceOrientation orientation)
{
  const auto open = [](StarKind kind)
  { return kind == StarKind::Boundary || kind == StarKind::Irregular; };
  if (orientation != SurfaceOrientation::Automatic ||
    // An open surface has no inside: its triangles define its orientation.
    std::any_of(kinds.begin(), kinds.end(), open) || mesh.NumberOfTriangles() == 0)
  {
    return orientation == SurfaceOrientation::Reversed ? -1.0 : 1.0;
  }
  // Relative to a point of the surface, so that a distant surface does not lose digits.
  const Vector3d origin = PointMap(mesh.Point(mesh.Corners(0)[0]).data());
  const double sixVolumes = ParallelReduce(mesh.NumberOfTriangles(), 16384, 0.0,
    [&](double& sum, std::int64_t first, std::int64_t last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        const Triangle& corner = mesh.Corners(t);
        const Vector3d a = PointMap(mesh.Point(corner[0]).data()) - origin;
        const Vector3d b = PointMap(mesh.Point(corner[1]).data()) - origin;
        const Vector3d c = PointMap(mesh.Point(corner[2]).data()) - origin;
        sum += a.dot(b.cross(c));
      }
    });
  return sixVolumes < 0.0 ? -1.0 : 1.0;
}

/// Whether all triangles are connected through their points.
bool IsOnePiece(const SurfaceView& mesh)
{
  DisjointSets<vtkIdType> pieces(mesh.Points.size());
  for (const Triangle& corners : mesh.Triangles)
  {
    pieces.Join(pieces.Join(corners[0], corners[1]), corners[2]);
  }
  return std::all_of(mesh.Triangles.begin(), mesh.Triangles.end(),
    [&](const Triangle& corners)
    { return pieces.Find(corners[0]) == pieces.Find(mesh.Triangles[0][0]); });
}

double MeanEdgeLength(const SurfaceView& mesh)
{
  const double sum = ParallelReduce(mesh.NumberOfTriangles(), 16384, 0.0,
    [&](double& partial, std::int64_t first, std::int64_t last)
    {
      for (vtkIdType t = first; t < last; ++t)
      {
        const Triangle& corner = mesh.Corners(t);
        for (int k = 0; k < 3; ++k)
        {
          partial += (PointMap(mesh.Point(corner[(k + 1) % 3]).data()) -
            PointMap(mesh.Point(corner[k]).data()))
                       .norm();
        }
      }
    });
  return sum / static_cast<double>(std::max<vtkIdType>(3 * mesh.NumberOfTriangles(), 1));
}

/// Why a point has no curvature.
enum class PointStatus : unsigned char
{
  Valid,
  Isolated,
  Boundary,
  Irregular,
  Degenerate,
  AreaNotPositive
};

class Estimator
{
public:
  Estimator(const SurfaceView& mesh, const SurfaceCurvatureOptions& options)
    : Mesh(mesh)
    , Options(options)
    , Stars(mesh)
    , Kinds(StarKinds(mesh, this->Stars))
    , Side(ComputeOrientation(mesh, this->Kinds, options.Orientation))
    , Verdicts(mesh.Points.size(), PointStatus::Isolated)
  {
  }

  SurfaceCurvatureResult Run(const ProgressCallback& progress);

private:
  void Allocate();
  void EstimateByDefect(vtkIdType first, vtkIdType last);
  void EstimateByTensor(vtkIdType first, vtkIdType last);
  void EstimateByFit(vtkIdType first, vtkIdType last);
  template <typename Estimate>
  void ForEachClassified(vtkIdType first, vtkIdType last, Estimate&& estimate);
  void StoreFrame(std::size_t point, const PrincipalFrame& frame, const Vector3d& normal);
  TensorSums IntegrateNeighbourhood(vtkIdType point, EdgeTensorIntegrator& patch) const;
  PointStatus ClassifyPoint(std::size_t point, const StarSums& sums) const;
  bool IsWide() const;
  void Count();
  void AverageTinyStars();

  static Eigen::Map<Vector3d> VectorAt(std::vector<double>& vectors, std::size_t point)
  {
    return Eigen::Map<Vector3d>(vectors.data() + 3 * point);
  }
  void StoreNormals(std::size_t point, const Vector3d& normal, const Vector3d& meanNormal)
  {
    if (this->Options.Normals)
    {
      VectorAt(this->Result.Normal, point) = normal;
      VectorAt(this->Result.MeanNormal, point) = meanNormal;
    }
  }

  const SurfaceView Mesh;
  const SurfaceCurvatureOptions Options;
  const TriangleStars Stars;
  const std::vector<StarKind> Kinds;
  const double Side;
  std::unique_ptr<DihedralAngles> Dihedrals; ///< for EdgeTensor
  std::unique_ptr<PointNormals> Normals;     ///< for NormalFit
  double Radius = 0.0;
  std::vector<PointStatus> Verdicts;
  SurfaceCurvatureResult Result;
};

void Estimator::Allocate()
{
  const auto points = this->Mesh.Points.size();
  for (std::vector<double>* values : { &this->Result.Gaussian, &this->Result.Mean,
         &this->Result.HalfDifference, &this->Result.Area })
  {
    values->resize(points, 0.0);
  }
  this->Result.Valid.resize(points, 0);
  if (this->Options.Normals)
  {
    this->Result.Normal.resize(3 * points, 0.0);
    this->Result.MeanNormal.resize(3 * points, 0.0);
  }
  if (this->Options.Method != CurvatureEstimate::AngleDefect)
  {
    this->Result.Direction1.resize(3 * points, 0.0);
    this->Result.Direction2.resize(3 * points, 0.0);
  }
}

SurfaceCurvatureResult Estimator::Run(const ProgressCallback& progress)
{
  this->Allocate();
  void (Estimator::*estimate)(vtkIdType, vtkIdType) = &Estimator::EstimateByDefect;
  std::int64_t grain = 4096;
  if (this->Options.Method != CurvatureEstimate::AngleDefect)
  {
    // Over about three edges the irregularity of a mesh averages out.
    this->Radius =
      this->Options.Radius > 0.0 ? this->Options.Radius : 3.0 * MeanEdgeLength(this->Mesh);
    // Each piece of the loop clears stamps for the whole mesh, so there are few pieces.
    grain = std::max<std::int64_t>(512, this->Mesh.NumberOfPoints() / 256);
  }
  if (this->Options.Method == CurvatureEstimate::EdgeTensor)
  {
    this->Dihedrals = std::make_unique<DihedralAngles>(this->Mesh, this->Stars);
    estimate = &Estimator::EstimateByTensor;
  }
  else if (this->Options.Method == CurvatureEstimate::NormalFit)
  {
    this->Normals = std::make_unique<PointNormals>(this->Mesh, this->Stars, this->Kinds);
    estimate = &Estimator::EstimateByFit;
  }
  ParallelFor(
    0, this->Mesh.NumberOfPoints(), grain,
    [&](std::int64_t first, std::int64_t last) { (this->*estimate)(first, last); }, progress);
  this->Count();
  if (!this->IsWide())
  {
    this->AverageTinyStars();
  }
  return std::move(this->Result);
}

/// Whether the estimate uses more than the triangles around a point.
bool Estimator::IsWide() const
{
  return this->Options.Method == CurvatureEstimate::NormalFit ||
    (this->Options.Method == CurvatureEstimate::EdgeTensor &&
      this->Options.Neighbourhood != CurvatureNeighbourhood::OneRing);
}

PointStatus Estimator::ClassifyPoint(std::size_t point, const StarSums& sums) const
{
  switch (this->Kinds[point])
  {
    case StarKind::Isolated:
      return PointStatus::Isolated;
    case StarKind::Irregular:
      return PointStatus::Irregular;
    case StarKind::Boundary:
      if (!this->IsWide())
      {
        return PointStatus::Boundary;
      }
      break;
    case StarKind::Interior:
      break;
  }
  if (sums.Degenerate && this->Options.Method != CurvatureEstimate::NormalFit)
  {
    return PointStatus::Degenerate;
  }
  return this->Options.Method != CurvatureEstimate::AngleDefect || sums.Area > 0.0
    ? PointStatus::Valid
    : PointStatus::AreaNotPositive;
}

TensorSums Estimator::IntegrateNeighbourhood(vtkIdType point, EdgeTensorIntegrator& patch) const
{
  switch (this->Options.Neighbourhood)
  {
    case CurvatureNeighbourhood::Ball:
      return patch.IntegrateOverBall(point);
    case CurvatureNeighbourhood::GeodesicDisc:
      return patch.IntegrateOverDisc(point);
    case CurvatureNeighbourhood::OneRing:
      break;
  }
  TensorSums sums;
  const MeshTriangle* const star = this->Stars.Triangles(point);
  for (vtkIdType i = 0; i < this->Stars.Size(point); ++i)
  {
    const Triangle& id = this->Mesh.Corners(star[i].Value);
    sums.Area += this->Dihedrals->Area(star[i]);
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const PointMap a(this->Mesh.Point(id[edge]).data());
      const PointMap b(this->Mesh.Point(id[(edge + 1) % 3]).data());
      this->Dihedrals->AddEdge(star[i], edge, (b - a).norm(), sums);
    }
  }
  return sums;
}

/// estimate(point, sums over its star) for each point that has an estimate.
template <typename Estimate>
void Estimator::ForEachClassified(vtkIdType first, vtkIdType last, Estimate&& estimate)
{
  for (vtkIdType point = first; point < last; ++point)
  {
    const auto p = static_cast<std::size_t>(point);
    const StarSums star = SumStar(this->Mesh, this->Stars, point, this->Options.DualArea);
    this->Result.Area[p] = star.Area;
    this->Verdicts[p] = this->ClassifyPoint(p, star);
    if (this->Verdicts[p] == PointStatus::Valid)
    {
      estimate(point, star);
    }
  }
}

void Estimator::EstimateByDefect(vtkIdType first, vtkIdType last)
{
  this->ForEachClassified(first, last,
    [&](vtkIdType point, const StarSums& sums)
    {
      const auto p = static_cast<std::size_t>(point);
      const double gaussian = (TwoPi - sums.Angle) / sums.Area;
      const double magnitude = sums.Cotangent.norm() / (4.0 * sums.Area);
      // Positive where the surface bends away from its outward normal.
      const double mean = this->Side * std::copysign(magnitude, sums.Cotangent.dot(sums.Normal));
      this->Result.Gaussian[p] = gaussian;
      this->Result.Mean[p] = mean;
      this->Result.HalfDifference[p] = HalfDifference(gaussian, mean);
      this->StoreNormals(
        p, this->Side * sums.Normal.normalized(), sums.Cotangent / (4.0 * sums.Area));
    });
}

void Estimator::EstimateByTensor(vtkIdType first, vtkIdType last)
{
  EdgeTensorIntegrator patch(this->Mesh, this->Stars, *this->Dihedrals, this->Radius);
  this->ForEachClassified(first, last,
    [&](vtkIdType point, const StarSums& star)
    {
      const TensorSums sums = this->IntegrateNeighbourhood(point, patch);
      const PrincipalFrame frame =
        ComputePrincipalFrame(this->Side / sums.Area * sums.Tensor, star.Normal);
      this->StoreFrame(
        static_cast<std::size_t>(point), frame, this->Side * star.Normal.normalized());
    });
}

void Estimator::EstimateByFit(vtkIdType first, vtkIdType last)
{
  NormalFit fit(this->Mesh, this->Stars, *this->Normals, this->Radius);
  this->ForEachClassified(first, last,
    [&](vtkIdType point, const StarSums&)
    {
      const auto p = static_cast<std::size_t>(point);
      std::optional<PrincipalFrame> frame = fit.Fit(point);
      if (!frame)
      {
        this->Verdicts[p] = PointStatus::Degenerate;
        return;
      }
      if (this->Side < 0.0)
      {
        std::swap(frame->Maximum, frame->Minimum);
        std::swap(frame->Direction1, frame->Direction2);
        frame->Maximum = -frame->Maximum;
        frame->Minimum = -frame->Minimum;
      }
      this->StoreFrame(p, *frame, this->Side * this->Normals->Normals[p]);
    });
}

void Estimator::StoreFrame(std::size_t p, const PrincipalFrame& frame, const Vector3d& normal)
{
  this->Result.Gaussian[p] = frame.Maximum * frame.Minimum;
  this->Result.Mean[p] = 0.5 * (frame.Maximum + frame.Minimum);
  this->Result.HalfDifference[p] = 0.5 * (frame.Maximum - frame.Minimum);
  VectorAt(this->Result.Direction1, p) = frame.Direction1;
  VectorAt(this->Result.Direction2, p) = frame.Direction2;
  this->StoreNormals(p, normal, this->Result.Mean[p] * normal);
}

/// Where a node of a volume lies almost at the level, its isosurface has a pyramid much smaller
/// than the spacing, whose slope is that of the triangles around it: curvature, slope per length,
/// grows without limit as the pyramid shrinks. Points with a tiny area get the mean of the
/// triangles around them, and these get it too, which keeps the integrals over the surface.
void Estimator::AverageTinyStars()
{
  constexpr double tiny = 1.0 / 32.0; // of the largest area of a neighbour
  const SurfaceCurvatureResult& r = this->Result;
  std::vector<double> largest(r.Area.size(), 0.0);
  const auto forEachPair = [this](auto&& use)
  {
    for (const Triangle& t : this->Mesh.Triangles)
    {
      for (std::size_t c = 0; c < 6; ++c)
      {
        const auto p = t[c % 3], q = t[(c % 3 + 1 + c / 3) % 3];
        if (this->Result.Valid[At(p)] && this->Result.Valid[At(q)])
        {
          use(p, q);
        }
      }
    }
  };
  forEachPair(
    [&](vtkIdType p, vtkIdType q) { largest[At(p)] = std::max(largest[At(p)], r.Area[At(q)]); });
  DisjointSets<vtkIdType> groups(r.Area.size());
  bool any = false;
  forEachPair(
    [&](vtkIdType p, vtkIdType q)
    {
      if (r.Area[At(p)] < tiny * largest[At(p)])
      {
        groups.Join(p, q);
        any = true;
      }
    });
  if (!any)
  {
    return;
  }
  struct Sums
  {
    int Points = 0;
    double Area = 0.0, Gaussian = 0.0, Mean = 0.0;
    Vector3d MeanNormal = Vector3d::Zero();
  };
  std::vector<Sums> sums(r.Area.size());
  const auto points = this->Mesh.NumberOfPoints();
  for (vtkIdType point = 0; point < points; ++point)
  {
    const std::size_t p = At(point);
    if (r.Valid[p])
    {
      Sums& of = sums[At(groups.Find(point))];
      ++of.Points;
      of.Area += r.Area[p];
      of.Gaussian += r.Area[p] * r.Gaussian[p];
      of.Mean += r.Area[p] * r.Mean[p];
      if (this->Options.Normals)
      {
        of.MeanNormal += r.Area[p] * VectorAt(this->Result.MeanNormal, p);
      }
    }
  }
  for (vtkIdType point = 0; point < points; ++point)
  {
    const std::size_t p = At(point);
    const Sums& of = sums[At(groups.Find(point))];
    if (r.Valid[p] && of.Points > 1 && of.Area > 0.0)
    {
      this->Result.Gaussian[p] = of.Gaussian / of.Area;
      this->Result.Mean[p] = of.Mean / of.Area;
      this->Result.HalfDifference[p] = HalfDifference(r.Gaussian[p], r.Mean[p]);
      if (this->Options.Normals)
      {
        VectorAt(this->Result.MeanNormal, p) = of.MeanNormal / of.Area;
      }
    }
  }
}

void Estimator::Count()
{
  for (std::size_t point = 0; point < this->Verdicts.size(); ++point)
  {
    const PointStatus verdict = this->Verdicts[point];
    this->Result.Valid[point] = verdict == PointStatus::Valid;
    this->Result.BoundaryPoints += this->Kinds[point] == StarKind::Boundary;
    this->Result.IrregularPoints += verdict == PointStatus::Irregular;
    this->Result.DegeneratePoints += verdict == PointStatus::Degenerate;
    this->Result.AreaNotPositive += verdict == PointStatus::AreaNotPositive;
  }
}

}

void Check(const SurfaceCurvatureOptions& options)
{
  RequireChoice("Method", options.Method, CurvatureEstimate::NormalFit);
  RequireChoice("DualArea", options.DualArea, DualArea::Mixed);
  RequireChoice("Neighbourhood", options.Neighbourhood, CurvatureNeighbourhood::GeodesicDisc);
  RequireChoice("Orientation", options.Orientation, SurfaceOrientation::Reversed);
  RequireRange("Radius", options.Radius, 0.0, Unlimited, "0 stands for three mean edge lengths.");
  Check(static_cast<const CurvatureDescriptorOptions&>(options));
}

SurfaceCurvatureResult ComputeSurfaceCurvature(
  const SurfaceView& mesh, const SurfaceCurvatureOptions& options, const ProgressCallback& progress)
{
  Check(options);
  if (options.Orientation != SurfaceOrientation::Automatic || IsOnePiece(mesh))
  {
    return Estimator(mesh, options).Run(progress);
  }
  const std::vector<Triangle> corners = OrientOutward(mesh);
  SurfaceCurvatureOptions outward = options;
  outward.Orientation = SurfaceOrientation::AsWound;
  return Estimator({ mesh.Points, corners }, outward).Run(progress);
}

}
