/**
 * @file FeatureDiagram.h
 * @brief The persistence diagram of a shape: pairs of its filtration as handles, tunnels and
 * additional features, each on its side.
 */
#ifndef isthmus_FeatureDiagram_h
#define isthmus_FeatureDiagram_h

#include "ChokingLoops/SurfaceHomology.h"
#include "Core/DisjointSets.h"
#include "Core/Geometry.h"
#include "Persistence/FiltrationPairs.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <algorithm>
#include <map>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Which components of a closed surface enclose a point?

/**
 * Counts the crossings of a ray, component by component, modulo 2: no orientation is needed, and a
 * ray through an edge is counted once, since both triangles evaluate the same expression.
 *
 * Building takes O(n), a query the triangles of one bin (some tens).
 */
class EnclosureTest
{
public:
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT EnclosureTest(
    const SurfaceView& mesh, const SurfaceHomology& homology);

  /// Ascending ids of the components that enclose `p`: an odd number of them means inside. Within
  /// rounding (1e-12 of the size) of the surface either result is possible.
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<int> Enclosing(const Point3& p) const;

private:
  std::size_t Bin(double v, std::size_t axis) const;

  std::vector<Point3> Points; ///< rotated into general position
  SurfaceView Mesh;
  const SurfaceHomology& Homology;
  Bounds3 Box;
  std::size_t Bins = 1;
  std::vector<SimplexId> First;
  std::vector<SimplexId> Inside;
};

// ------------------------------------------------------------------------------------------
// Inside or outside: the regions into which a surface divides the tetrahedra around it.

enum class SpaceSide
{
  Inside = 0,
  Outside = 1
};

/// A function on a tetrahedral mesh, linear in each tetrahedron, beside the one that it stands for.
struct CellError
{
  double Error = 0.0; ///< they differ by at most this in the tetrahedron
  double Least = 0.0; ///< both are at least this there
};

/**
 * The errors of the distance to M on a mesh. `values` at its points differ from the distance by at
 * most `atPoints` of each (empty: not at all).
 *
 * The distance changes by no more than one goes, so at a point with barycentric coordinates l_i it
 * differs from the linear function by at most sum l_i |x - v_i|. By Jensen's inequality that is at
 * most the radius of the smallest ball around the tetrahedron, and by Jung's theorem at most
 * sqrt(3/8) of its longest edge.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<CellError> DistanceErrors(
  const CellFiltration& mesh, const std::vector<double>& values,
  const std::vector<double>& atPoints);

/// The errors of any other function: within a tetrahedron it may have any of the values at its
/// corners.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<CellError> RangeErrors(
  const CellFiltration& mesh, const std::vector<double>& values);

/// A filtration of a surface's surroundings, with associated data.
struct FeatureContext
{
  const CellFiltration& Filtration;
  const FiltrationPairs& Pairs;
  const SurfaceHomology& Homology;
  const SurfaceInComplex& Embedding;
  const SurfaceAdjacency& Surface;
  std::vector<double>
    PointError; ///< SamplingErrors() (SurfacePreparation.h); empty: M is part of the complex
  std::vector<CellError> CellErrors; ///< of each tetrahedron, where M is part of the complex
  std::vector<double> PointValue{};  ///< the function at points, where M is part of the complex

  /// Square of the largest sampling error at the corners of a simplex, with a margin for rounding.
  template <std::size_t N>
  double SquaredError(const std::array<SimplexId, N>& corners) const
  {
    double e = 0.0;
    for (const SimplexId p : corners)
    {
      e =
        std::max(e, this->PointError.empty() ? 0.0 : this->PointError[static_cast<std::size_t>(p)]);
    }
    return (1.0 + 1e-7) * e * e;
  }

  /// True for a triangle of the complex that may cross M or be part of it.
  bool IsWall(TriangleId triangle) const;
};

/**
 * Tetrahedra grouped across triangles that are not walls (IsWall()); a group lies in one region,
 * that of the circumcentre of its last tetrahedron in the filtration (of its centroid, where M is
 * part of the complex).
 *
 * The dual edge of a triangle that enters above the sampling error keeps away from M, so that the
 * circumcentres at its ends lie on the same side.
 */
class SpaceRegions
{
public:
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT explicit SpaceRegions(
    const FeatureContext& context, const ProgressCallback& progress = {});

  /// The components of M that enclose a tetrahedron, ascending; none for the exterior (None).
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const std::vector<int>& Of(TetrahedronId cell);

  /// The same for a triangle that is not a wall.
  const std::vector<int>& OfTriangle(TriangleId triangle);

  static SpaceSide SideOf(const std::vector<int>& enclosing)
  {
    return enclosing.size() % 2 == 1 ? SpaceSide::Inside : SpaceSide::Outside;
  }

private:
  Point3 Inner(TetrahedronId deepest) const;

  const FeatureContext& Context;
  DisjointSets<TetrahedronId> Groups; ///< the root of each is its last tetrahedron
  EnclosureTest Test;
  std::map<TetrahedronId, std::vector<int>> Known;
};

/// Centre of the smallest sphere through the corners of a triangle or tetrahedron.
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Point3 Circumcentre(
  const Point3& p, const Point3& q, const Point3& r);
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT Point3 Circumcentre(
  const Point3& p, const Point3& q, const Point3& r, const Point3& s);

inline bool FeatureContext::IsWall(TriangleId t) const
{
  return this->PointError.empty()
    ? this->Filtration.TriangleFirst[t] != 0
    : this->Filtration.TriangleValue[t] <= this->SquaredError(this->Filtration.TrianglePoints(t));
}

inline const std::vector<int>& SpaceRegions::OfTriangle(TriangleId triangle)
{
  return this->Of(this->Context.Filtration.TriangleSides(triangle)[0]);
}

// ------------------------------------------------------------------------------------------
// Every narrowing of a shape, from the pairs of its filtration.

enum class FeatureKind
{
  Handle = 0,     ///< a loop of M that bounds inside, but not on M
  Tunnel = 1,     ///< one that bounds outside
  Additional = 2, ///< a narrowing that the homology of M does not detect
  Noise = 3       ///< not distinguishable from the sampling, or M itself
};

/**
 * A narrowing of the space on one side of M. Lengths are in the unit of the points.
 *
 * A ball that grows inside or outside of M defines two radii:
 * - Birth, also called Radius: of the largest ball that passes the narrowing. There a loop of M is
 *   filled (handles, tunnels), or a void is closed off (additional features).
 * - Death: of the largest ball that fits behind it, at which the space there is filled. For a
 *   handle or tunnel: the last death in its region.
 * - Persistence: Death - Birth, how much the space widens behind the narrowing.
 *
 * These are the arrays `Birth`, `Death` and `Persistence` of loops, membranes and choke points. The
 * persistence diagram shows the pair of the filtration, PairBirth and PairDeath: the same for
 * additional features; for handles and tunnels the class of the loop, which exists from the start
 * (0) and dies at Radius().
 */
struct ShapeFeature
{
  int Dimension = 2; ///< of the pair's class: 1: a loop, 2: a void
  SpaceSide Side = SpaceSide::Inside;
  FeatureKind Kind = FeatureKind::Noise;
  double PairBirth = 0.0;
  double PairDeath = 0.0;
  /// PairDeath^2 - PairBirth^2 exceeds the square of the sampling error, or PairDeath - PairBirth
  /// twice the error of the function on a mesh (a handle's or tunnel's radius that error itself): a
  /// feature of M, not of the samples or the mesh.
  bool Trusted = false;
  double Error = 0.0; ///< the local sampling error
  /// Of the function on a mesh, at all radii up to PairDeath: birth and death are that exact.
  double FunctionError = 0.0;
  /// The triangle where a ball of radius Radius() gets stuck.
  TriangleId Choke = TriangleId::None();
  double Death = 0.0;
  /// For a handle or tunnel: basis loops of SurfaceHomology that it is the sum of.
  std::vector<std::size_t> Sum;

  double Radius() const { return this->Dimension == 1 ? this->PairDeath : this->PairBirth; }
  double Birth() const { return this->Radius(); }
  double Persistence() const { return this->Death - this->Birth(); }
};

inline bool IsGenerator(const ShapeFeature& feature)
{
  return feature.Kind == FeatureKind::Handle || feature.Kind == FeatureKind::Tunnel;
}

/// What FindFeatures found.
struct FeatureDiagram
{
  std::vector<ShapeFeature> Features;          ///< ascending by Radius()
  std::array<double, 2> Reference{ 0.0, 0.0 }; ///< per side: largest trusted PairDeath, 0 if none
  std::size_t ExpectedGenerators = 0;          ///< 2g
};

/**
 * The pairs of a filtration as features with side and kind; the classes of M itself are kept
 * separate.
 *
 * M's own class in each bounded region of its complement is the pair, born below the error, with
 * the greatest death; it is kept as Noise. Pairs of equal birth and death, and those that die below
 * the error, are omitted.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT FeatureDiagram FindFeatures(
  const FeatureContext& context, SpaceRegions& regions, const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// Which features of a diagram are reported, and the threshold that a diagram proposes.

/// A length as given by the user: in percent of a side's reference length, or in units of the data.
struct LengthSetting
{
  double Value = 0.0;
  bool Percent = true;

  double Of(double reference) const
  {
    return this->Percent ? 0.01 * this->Value * reference : this->Value;
  }
};

/// How additional features are separated from noise.
enum class ThresholdMode
{
  Given,     ///< by FeatureSelection::MinimumPersistence
  LargestGap ///< by the largest gap of each side's diagram
};

/// Which features to report.
struct FeatureSelection
{
  bool Inside = true;
  bool Outside = true;
  LengthSetting MaximumRadius{ 100.0, true };
  LengthSetting MinimumPersistence{ 5.0, true };
  ThresholdMode Threshold = ThresholdMode::Given;
  /// Handles and tunnels need not obey MaximumRadius. MinimumPersistence never applies to them: a
  /// ring of constant width does not widen behind the narrowing, and yet it is a handle.
  bool AlwaysReportHandles = true;
  /// Drop features that may be ones of the sampling (ShapeFeature::Trusted).
  bool TrustedOnly = false;
  /// Keep the features of the largest persistence; 0: all of them.
  std::size_t MaximumNumber = 0;
};

/// A gap between consecutive persistences of one side, in the unit of the points.
struct PersistenceGap
{
  double Threshold = 0.0; ///< its middle: features with a larger persistence are selected
  double Width = 0.0;     ///< 0: there is none
};

/**
 * The largest gap of one side's additional features: the largest difference of consecutive
 * persistences in descending order, with 0 after the last. A gap narrower than a hundredth of the
 * side's reference length does not count; the threshold is then that hundredth.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT PersistenceGap LargestGap(
  const FeatureDiagram& diagram, SpaceSide side);

/// Indices of the features of a selection, ascending by Radius(). O(n log n).
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT std::vector<std::size_t> SelectFeatures(
  const FeatureDiagram& diagram, const FeatureSelection& selection);

}

#endif
