#include "Curvature/SurfaceCurvature.h"

#include "Core/ParallelFor.h"
#include "Core/RangeChecks.h"
#include "Curvature/CurvatureDescriptors.h"
#include "Curvature/EdgeBends.h"
#include "Curvature/StarCurvature.h"
#include "Curvature/SurfacePatch.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>

namespace isthmus
{
namespace
{

using Eigen::Vector3d;
using PointMap = Eigen::Map<const Vector3d>;

constexpr double TwoPi = 6.28318530717958647692;

/// +1 where triangles are counter-clockwise seen from outside, -1 where clockwise.
double OrientationOf(
  const SurfaceView& mesh, const std::vector<StarKind>& kinds, SurfaceOrientation orientation)
{
  const auto open = [](StarKind kind)
  { return kind == StarKind::Boundary || kind == StarKind::Irregular; };
  if (orientation != SurfaceOrientation::Automatic ||
    std::any_of(kinds.begin(), kinds.end(), open) || mesh.NumberOfTriangles() == 0)
  {
    return orientation == SurfaceOrientation::Reversed ? -1.0 : 1.0;
  }
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

/// Why a point has no curvature, counted.
enum class Verdict : unsigned char
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
    , Side(OrientationOf(mesh, this->Kinds, options.Orientation))
    , Verdicts(mesh.Points.size(), Verdict::Isolated)
  {
  }

  SurfaceCurvatureResult Run(const ProgressCallback& progress);

private:
  void Allocate();
  void WithDefect(vtkIdType first, vtkIdType last);
  void WithTensor(vtkIdType first, vtkIdType last);
  TensorSums NeighbourhoodOf(vtkIdType point, SurfacePatch& patch) const;
  Verdict Judge(std::size_t point, const StarSums& sums) const;
  void Count();

  const SurfaceView Mesh;
  const SurfaceCurvatureOptions Options;
  const TriangleStars Stars;
  const std::vector<StarKind> Kinds;
  const double Side;
  std::unique_ptr<EdgeBends> Bends;
  double Radius = 0.0;
  std::vector<Verdict> Verdicts;
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
  if (this->Options.Estimate == CurvatureEstimate::EdgeTensor)
  {
    this->Result.Direction1.resize(3 * points, 0.0);
    this->Result.Direction2.resize(3 * points, 0.0);
  }
}

SurfaceCurvatureResult Estimator::Run(const ProgressCallback& progress)
{
  this->Allocate();
  const bool tensor = this->Options.Estimate == CurvatureEstimate::EdgeTensor;
  std::int64_t grain = 4096;
  if (tensor)
  {
    this->Bends = std::make_unique<EdgeBends>(this->Mesh, this->Stars);
    this->Radius =
      this->Options.Radius > 0.0 ? this->Options.Radius : 3.0 * MeanEdgeLength(this->Mesh);
    // Each piece of the loop clears stamps for all triangles: not too many pieces, then.
    grain = std::max<std::int64_t>(512, this->Mesh.NumberOfPoints() / 256);
  }
  ParallelFor(
    0, this->Mesh.NumberOfPoints(), grain,
    [&](std::int64_t first, std::int64_t last)
    { tensor ? this->WithTensor(first, last) : this->WithDefect(first, last); },
    progress);
  this->Count();
  return std::move(this->Result);
}

Verdict Estimator::Judge(std::size_t point, const StarSums& sums) const
{
  const bool tensor = this->Options.Estimate == CurvatureEstimate::EdgeTensor;
  const bool wide = tensor && this->Options.Neighbourhood != CurvatureNeighbourhood::OneRing;
  switch (this->Kinds[point])
  {
    case StarKind::Isolated:
      return Verdict::Isolated;
    case StarKind::Irregular:
      return Verdict::Irregular;
    case StarKind::Boundary:
      if (!wide)
      {
        return Verdict::Boundary;
      }
      break;
    case StarKind::Interior:
      break;
  }
  if (sums.Degenerate)
  {
    return Verdict::Degenerate;
  }
  return tensor || sums.Area > 0.0 ? Verdict::Valid : Verdict::AreaNotPositive;
}

void Estimator::WithDefect(vtkIdType first, vtkIdType last)
{
  for (vtkIdType point = first; point < last; ++point)
  {
    const auto p = static_cast<std::size_t>(point);
    const StarSums sums = SumStar(this->Mesh, this->Stars, point, this->Options.Area);
    this->Result.Area[p] = sums.Area;
    this->Verdicts[p] = this->Judge(p, sums);
    if (this->Verdicts[p] == Verdict::Valid)
    {
      const double gaussian = (TwoPi - sums.Angle) / sums.Area;
      const double magnitude = sums.Cotangent.norm() / (4.0 * sums.Area);
      const double mean = this->Side * std::copysign(magnitude, sums.Cotangent.dot(sums.Normal));
      this->Result.Gaussian[p] = gaussian;
      this->Result.Mean[p] = mean;
      this->Result.HalfDifference[p] = HalfDifference(gaussian, mean);
    }
  }
}

TensorSums Estimator::NeighbourhoodOf(vtkIdType point, SurfacePatch& patch) const
{
  switch (this->Options.Neighbourhood)
  {
    case CurvatureNeighbourhood::Ball:
      return patch.OverBall(point);
    case CurvatureNeighbourhood::GeodesicDisc:
      return patch.OverDisc(point);
    case CurvatureNeighbourhood::OneRing:
      break;
  }
  TensorSums sums;
  const MeshTriangle* const star = this->Stars.Triangles(point);
  for (vtkIdType i = 0; i < this->Stars.Size(point); ++i)
  {
    const Triangle& id = this->Mesh.Corners(star[i].Value);
    sums.Area += this->Bends->Area(star[i]);
    for (std::size_t edge = 0; edge < 3; ++edge)
    {
      const PointMap a(this->Mesh.Point(id[edge]).data());
      const PointMap b(this->Mesh.Point(id[(edge + 1) % 3]).data());
      this->Bends->AddEdge(star[i], edge, (b - a).norm(), sums);
    }
  }
  return sums;
}

void Estimator::WithTensor(vtkIdType first, vtkIdType last)
{
  SurfacePatch patch(this->Mesh, this->Stars, *this->Bends, this->Radius);
  for (vtkIdType point = first; point < last; ++point)
  {
    const auto p = static_cast<std::size_t>(point);
    const StarSums star = SumStar(this->Mesh, this->Stars, point, this->Options.Area);
    this->Result.Area[p] = star.Area;
    this->Verdicts[p] = this->Judge(p, star);
    if (this->Verdicts[p] != Verdict::Valid)
    {
      continue;
    }
    const TensorSums sums = this->NeighbourhoodOf(point, patch);
    const PrincipalFrame frame =
      PrincipalFrameOf(this->Side / sums.Area * sums.Tensor, star.Normal);
    this->Result.Gaussian[p] = frame.Maximum * frame.Minimum;
    this->Result.Mean[p] = 0.5 * (frame.Maximum + frame.Minimum);
    this->Result.HalfDifference[p] = 0.5 * (frame.Maximum - frame.Minimum);
    Eigen::Map<Vector3d>(this->Result.Direction1.data() + 3 * p) = frame.Direction1;
    Eigen::Map<Vector3d>(this->Result.Direction2.data() + 3 * p) = frame.Direction2;
  }
}

void Estimator::Count()
{
  for (std::size_t point = 0; point < this->Verdicts.size(); ++point)
  {
    const Verdict verdict = this->Verdicts[point];
    this->Result.Valid[point] = verdict == Verdict::Valid;
    this->Result.BoundaryPoints += this->Kinds[point] == StarKind::Boundary;
    this->Result.IrregularPoints += verdict == Verdict::Irregular;
    this->Result.DegeneratePoints += verdict == Verdict::Degenerate;
    this->Result.AreaNotPositive += verdict == Verdict::AreaNotPositive;
  }
}

}

SurfaceCurvatureResult CurvatureOfSurface(
  const SurfaceView& mesh, const SurfaceCurvatureOptions& options, const ProgressCallback& progress)
{
  if (!(options.Radius >= 0.0) || std::isinf(options.Radius))
  {
    throw std::invalid_argument("Radius is " + FormatNumber(options.Radius) +
      ", but it is a length: give a positive one, or 0 for three mean edge lengths.");
  }
  return Estimator(mesh, options).Run(progress);
}

}
