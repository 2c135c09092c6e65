/**
 * @file FeatureDiagram.h
 * @brief The persistence diagram of a shape: the pairs of its filtration, classified as handles,
 * tunnels and additional features, inside or outside.
 */
#ifndef isthmus_FeatureDiagram_h
#define isthmus_FeatureDiagram_h

#include "ChokingLoops/ChokingLoopParameters.h"
#include "ChokingLoops/SurfaceHomology.h"
#include "ChokingLoops/SurfacePreparation.h"
#include "Core/DisjointSets.h"
#include "Core/Geometry.h"
#include "Persistence/FiltrationPairs.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace isthmus
{

// ------------------------------------------------------------------------------------------
// Which components of a closed surface enclose a point?

/**
 * Counts the crossings of a ray, component by component, modulo 2: no orientation is needed, and a
 * ray through an edge is counted once, since both triangles evaluate the same expression.
 *
 * Building takes O(n); a query visits the triangles of one bin (some tens).
 */
class EnclosureTest
{
public:
  EnclosureTest(const SurfaceView& mesh, const SurfaceHomology& homology);

  /// Ascending ids of the components that enclose `p`: an odd number of them means inside. Within
  /// rounding (1e-12 of the size) of the surface either result is possible.
  std::vector<int> Enclosing(const Point3& p) const;

private:
  std::size_t Bin(double v, std::size_t axis) const;
  /// Rotated into general position.
  std::array<Point3, 3> Corners(const Triangle& t) const;

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

/// Error bound of a function that is linear in each tetrahedron of a mesh and approximates another
/// one.
struct CellError
{
  double Error = 0.0; ///< largest difference of the two functions in the tetrahedron
  double Least = 0.0; ///< lower bound of both functions in it
};

/// A filtration of a surface's surroundings, with associated data.
struct FeatureContext
{
  const CellFiltration& Filtration;
  const FiltrationPairs& Pairs;
  const SurfaceHomology& Homology;
  const SurfaceInComplex& Embedding;
  const SurfaceAdjacency& Surface;
  SampleErrors Errors;
  std::vector<CellError> CellErrors; ///< of each tetrahedron, if M is part of the complex
  std::vector<double> PointValue{};  ///< the function at points, if M is part of the complex

  /// SampleErrors::Squared() of a simplex.
  template <std::size_t N>
  double SquaredError(const std::array<SimplexId, N>& corners, double squared = 0.0) const
  {
    return this->Errors.Squared(corners.data(), N, squared);
  }

  /// True for a triangle of the complex that may cross M or be part of it.
  bool IsWall(TriangleId triangle) const
  {
    return this->Errors.Point.empty() ? this->Filtration.TriangleFirst[triangle] != 0
                                      : this->Filtration.TriangleValue[triangle] <=
        this->SquaredError(this->Filtration.TrianglePoints(triangle));
  }
};

/**
 * Tetrahedra grouped across triangles that are not walls (IsWall()); a group lies in one region,
 * the one that contains the circumcenter of its last tetrahedron in the filtration (or its
 * centroid, if M is part of the complex).
 *
 * The dual edge of a triangle that enters above the sampling error does not cross M, so the
 * circumcenters at its ends lie on the same side.
 */
class SpaceRegions
{
public:
  explicit SpaceRegions(const FeatureContext& context, const ProgressCallback& progress = {});

  /// The components of M that enclose a tetrahedron, ascending; empty for the exterior (None).
  VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT const std::vector<int>& Of(TetrahedronId cell);

  /// The same for a triangle that is not a wall.
  const std::vector<int>& OfTriangle(TriangleId triangle);

  static SpaceSide SideFrom(const std::vector<int>& enclosing)
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

/// Center of the smallest sphere through the corners of a triangle or tetrahedron.
Point3 Circumcenter(const Point3& p, const Point3& q, const Point3& r);
Point3 Circumcenter(const Point3& p, const Point3& q, const Point3& r, const Point3& s);

inline const std::vector<int>& SpaceRegions::OfTriangle(TriangleId triangle)
{
  return this->Of(this->Context.Filtration.TriangleSides(triangle)[0]);
}

// ------------------------------------------------------------------------------------------
// All narrowings of a shape, from the pairs of its filtration.

enum class FeatureKind
{
  Handle = 0,     ///< a loop of M that bounds inside, but not on M
  Tunnel = 1,     ///< a loop of M that bounds outside, but not on M
  Additional = 2, ///< a narrowing that the homology of M does not detect
  Noise = 3       ///< not distinguishable from the sampling error, or M itself
};

/**
 * A narrowing of the space on one side of M. Lengths are in the unit of the points.
 *
 * A ball that grows inside or outside of M defines two radii:
 * - Birth, also called Radius: the radius of the largest ball that passes the narrowing. At this
 *   radius a loop of M is filled (handles, tunnels), or a void is closed off (additional features).
 * - Death: the radius of the largest ball that fits behind the narrowing. At this radius the space
 *   behind it is filled. For a handle or tunnel: the last death in its region.
 * - Persistence: Death - Birth, which measures how much the space widens behind the narrowing.
 *
 * These are the arrays `Birth`, `Death` and `Persistence` of loops, membranes and choke points. The
 * persistence diagram shows the pair of the filtration, PairBirth and PairDeath: for additional
 * features the same two radii; for handles and tunnels those of the class of the loop, which exists
 * from the start (0) and dies at Radius().
 */
struct ShapeFeature
{
  int Dimension = 2; ///< of the pair's class: 1: a loop, 2: a void
  SpaceSide Side = SpaceSide::Inside;
  FeatureKind Kind = FeatureKind::Noise;
  double PairBirth = 0.0;
  double PairDeath = 0.0;
  /// True for a feature of M that is not caused by the samples or the mesh: PairDeath^2 -
  /// PairBirth^2 exceeds the square of the sampling error or, on a mesh, PairDeath - PairBirth
  /// exceeds twice the error of the function (for a handle or tunnel, its radius exceeds that
  /// error).
  bool Trusted = false;
  /// The true radius lies between sqrt(Radius()^2 - Error^2) and Radius(): for samples on M, the
  /// local sampling error.
  double Error = 0.0;
  /// On a mesh: the largest error of the function at radii up to PairDeath. Birth and death are
  /// known up to this error.
  double FunctionError = 0.0;
  /// On a fine surface: how much smaller the measured Radius() is than the one between the samples
  /// (ChokingLoops.h). Other narrow places may be as much narrower, so the true radius of a handle
  /// or tunnel may lie as far below, and that of an additional feature as far above.
  double Narrowed = 0.0;
  /// The triangle where a ball of radius Radius() gets stuck.
  TriangleId Choke = TriangleId::None();
  double Death = 0.0;
  /// For a handle or tunnel: the basis loops of SurfaceHomology whose sum it is.
  std::vector<std::size_t> Sum;

  double Radius() const { return this->Dimension == 1 ? this->PairDeath : this->PairBirth; }
  double Birth() const { return this->Radius(); }
  double Persistence() const { return this->Death - this->Birth(); }
};

/// How far the true radius may lie below Radius() (ShapeFeature::Error). With a function on a mesh,
/// or measured on a fine surface: how far it may lie below or above (ShapeFeature::FunctionError,
/// Narrowed).
inline double ComputeUncertainty(const ShapeFeature& feature)
{
  const double d = feature.Radius();
  return feature.FunctionError > 0.0
    ? feature.FunctionError
    : feature.Narrowed + d - std::sqrt(std::max(0.0, d * d - feature.Error * feature.Error));
}

inline bool IsGenerator(const ShapeFeature& feature)
{
  return feature.Kind == FeatureKind::Handle || feature.Kind == FeatureKind::Tunnel;
}

/// Result of FindFeatures().
struct FeatureDiagram
{
  std::vector<ShapeFeature> Features;          ///< ascending by Radius()
  std::array<double, 2> Reference{ 0.0, 0.0 }; ///< per side: largest trusted PairDeath, 0 if none
  std::size_t ExpectedGenerators = 0;          ///< 2g
};

/**
 * The pairs of a filtration as features with side and kind; classes of M itself are marked as
 * Noise.
 *
 * In each bounded region of the complement, the class of M itself is the pair with the largest
 * death among those born below the error. Pairs of equal birth and death, and pairs that die below
 * the error, are omitted.
 */
FeatureDiagram FindFeatures(
  const FeatureContext& context, SpaceRegions& regions, const ProgressCallback& progress = {});

// ------------------------------------------------------------------------------------------
// Selection of the reported features, and the threshold proposed by a diagram.

/// A gap between consecutive persistences of one side, in the unit of the points.
struct PersistenceGap
{
  double Threshold = 0.0; ///< middle of the gap: features with a larger persistence are selected
  double Width = 0.0;     ///< 0: there is none
};

/**
 * The largest gap of one side's additional features: the largest difference of consecutive
 * persistences in descending order, with 0 after the last. If no gap is wider than 1 % of the
 * side's reference length, the threshold is that 1 %.
 */
PersistenceGap LargestGap(const FeatureDiagram& diagram, SpaceSide side);

/// Indices of the features of a selection, ascending by Radius(). O(n log n).
std::vector<std::size_t> SelectFeatures(
  const FeatureDiagram& diagram, const FeatureSelection& selection);

}

#endif
