#include "SolidStuffing.h"

#include "IsosurfaceStuffing.h"
#include "ShellNesting.h"
#include "TriangleTree.h"
#include "WindingNumber.h"

#include <stdexcept>

namespace isthmus
{
namespace
{

/// Distance to a soup, positive where it winds around a point by more than a half.
class SolidField
{
public:
  explicit SolidField(const TriangleMesh& soup)
    : Winding(soup)
    , Tree(TreeOf(soup))
  {
  }

  double operator()(const Point3& x) const
  {
    const double distance = std::sqrt(this->Tree.Find(x, -1).Squared);
    return std::abs(this->Winding(x)) > 0.5 ? distance : -distance;
  }

private:
  static TriangleTree TreeOf(const TriangleMesh& mesh)
  {
    std::vector<vtkIdType> ids;
    ids.reserve(3 * mesh.Triangles.size());
    for (const Triangle& t : mesh.Triangles)
    {
      ids.insert(ids.end(), t.begin(), t.end());
    }
    return TriangleTree({ mesh.Points.front().data(), static_cast<vtkIdType>(mesh.Points.size()),
      ids.data(), static_cast<vtkIdType>(mesh.Triangles.size()) });
  }

  WindingNumber Winding;
  TriangleTree Tree;
};

double SolidVolume(const TetrahedralMesh& mesh)
{
  double six = 0.0;
  for (std::size_t i = 0; i < mesh.Tetrahedra.size(); ++i)
  {
    if (mesh.Regions[i] == 0)
    {
      continue;
    }
    const Tetrahedron& t = mesh.Tetrahedra[i];
    const auto at = [&](std::size_t c) { return mesh.Points[static_cast<std::size_t>(t[c])]; };
    six += Dot(Cross(at(1) - at(0), at(2) - at(0)), at(3) - at(0));
  }
  return six / 6.0;
}

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
    for (std::int64_t& id : t)
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

TetrahedralMesh StuffSolid(const TriangleMesh& soup, const SolidStuffingParameters& parameters,
  const ProgressCallback& progress)
{
  const char* const nothing = "The surface encloses nothing: it is no closed surface, nor nearly one.";
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
  // The volume of the solid tells whether cells are small enough, so it is always made.
  stuffing.Side =
    parameters.Side == MeshedSide::Inside ? MeshedSide::Inside : MeshedSide::Both;
  stuffing.Margin = parameters.Side == MeshedSide::Inside ? 0.0 : parameters.BoxMargin * diagonal;
  stuffing.MaximumBytes = parameters.MaximumBytes;
  stuffing.GradingLevels = parameters.Side == MeshedSide::Inside ? 0 : 4;
  stuffing.CellSize = parameters.CellSize > 0.0 ? parameters.CellSize : diagonal / 100.0;
  const int most = parameters.CellSize > 0.0 ? 0 : 2;
  TetrahedralMesh mesh;
  double volume = 0.0;
  for (int round = 0; round <= most; ++round)
  {
    TetrahedralMesh finer;
    try
    {
      const double from = round == 0 ? 0.0 : round == 1 ? 0.05 : 0.2;
      finer = IsosurfaceStuffing(field, bounds, stuffing,
        Between(progress, from, round == 0 ? 0.05 : round == 1 ? 0.2 : 1.0))
                .Mesh;
    }
    catch (const Cancelled&)
    {
      throw;
    }
    catch (const std::runtime_error&)
    {
      if (round == 0)
      {
        throw;
      }
      break; // no memory for smaller cells: the mesh is as good as the limit lets it be
    }
    const double last = volume;
    mesh = std::move(finer);
    volume = SolidVolume(mesh);
    if (round > 0 && std::abs(volume - last) <= 0.005 * volume)
    {
      break;
    }
    stuffing.CellSize *= 0.5;
  }
  if (!(volume > 0.0))
  {
    throw std::invalid_argument(nothing);
  }
  return parameters.Side == MeshedSide::Outside ? OutsideOf(mesh) : std::move(mesh);
}

}
