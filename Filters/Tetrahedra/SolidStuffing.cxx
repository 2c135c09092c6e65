#include "Tetrahedra/SolidStuffing.h"

#include "Core/Geometry.h"
#include "Surfaces/ShellNesting.h"
#include "Surfaces/TriangleTree.h"
#include "Surfaces/WindingNumber.h"
#include "Tetrahedra/IsosurfaceStuffing.h"

#include <stdexcept>

namespace isthmus
{
namespace
{

/// Distance to a soup, positive where it winds around a point by more than a half.
class SolidField
{
public:
  explicit SolidField(const SurfaceView& soup)
    : Winding(soup)
    , Tree(soup)
    , Triangles(static_cast<std::int64_t>(soup.Triangles.size()))
  {
  }

  double operator()(const Point3& x) const
  {
    // The nearest triangle of the last place asked for, which is beside this one, saves most of the
    // search; whatever it is, the answer is the same.
    thread_local std::int64_t last = -1;
    const auto nearest = this->Tree.Find(x, last < this->Triangles ? last : -1);
    last = nearest.Guess;
    const double distance = std::sqrt(nearest.Squared);
    return std::abs(this->Winding(x)) > 0.5 ? distance : -distance;
  }

private:
  WindingNumber Winding;
  TriangleTree Tree;
  std::int64_t Triangles;
};

/// Leaves the tetrahedra of region 0 and the points they use.
TetrahedralMesh OutsideOf(const TetrahedralMesh& mesh)
{
  TetrahedralMesh outside;
  std::vector<std::int64_t> ids(mesh.Points.size(), -1);
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    if (mesh.Regions[i] != 0)
    {
      continue;
    }
    Tetrahedron t = mesh.Tetrahedra[i];
    for (vtkIdType& id : t)
    {
      std::int64_t& known = ids[static_cast<std::size_t>(id)];
      if (known < 0)
      {
        known = static_cast<std::int64_t>(outside.Points.size());
        outside.Points.push_back(mesh.Points[static_cast<std::size_t>(id)]);
      }
      id = known;
    }
    outside.Tetrahedra.push_back(t);
  }
  outside.Regions.assign(outside.Tetrahedra.size(), 0);
  outside.OriginalPoints.assign(outside.Points.size(), -1);
  return outside;
}

}

TetrahedralMesh StuffSolid(const SurfaceView& soup, const SolidStuffingParameters& parameters,
  const ProgressCallback& progress)
{
  const char* const nothing =
    "The surface encloses nothing: it is no closed surface, nor nearly one.";
  if (soup.Triangles.empty())
  {
    throw std::invalid_argument(nothing);
  }
  const Bounds3 bounds = BoundsOf(soup);
  const double diagonal = bounds.Diagonal();
  if (!(diagonal > 0.0) || !std::isfinite(diagonal * diagonal * diagonal))
  {
    throw std::invalid_argument("The surface has no size, or one too large for its volume.");
  }
  const SolidField field(soup);
  StuffingParameters stuffing;
  // Whether anything is enclosed shows on the inside, so it is always made.
  stuffing.Side = parameters.Side == MeshedSide::Inside ? MeshedSide::Inside : MeshedSide::Both;
  stuffing.Margin = parameters.Side == MeshedSide::Inside ? 0.0 : parameters.BoxMargin * diagonal;
  stuffing.MaximumBytes = parameters.MaximumBytes;
  stuffing.GradingLevels = parameters.Side == MeshedSide::Inside ? 0 : 4;
  stuffing.CellSize = parameters.CellSize > 0.0 ? parameters.CellSize : diagonal / 100.0;
  TetrahedralMesh mesh = IsosurfaceStuffing(field, bounds, stuffing, progress).Mesh;
  if (std::count(mesh.Regions.begin(), mesh.Regions.end(), 1) == 0)
  {
    throw std::invalid_argument(nothing);
  }
  return parameters.Side == MeshedSide::Outside ? OutsideOf(mesh) : std::move(mesh);
}

}
