/**
 * @file FeatureDiagram.h
 * @brief Every narrowing of a shape, as the pairs of its filtration tell.
 */
#ifndef isthmus_FeatureDiagram_h
#define isthmus_FeatureDiagram_h

#include "ChokingLoops/SpaceRegions.h"
#include "ChokingLoops/SurfaceGenerators.h"
#include "vtkIsthmusFiltersChokingLoopsModule.h"

namespace isthmus
{

enum class FeatureKind
{
  Handle = 0,     ///< a loop of M that bounds inside, but not on M
  Tunnel = 1,     ///< one that bounds outside
  Additional = 2, ///< a narrowing that homology of M does not see
  Noise = 3       ///< not told apart from the sampling, or M itself
};

/// One point of the persistence diagram. Radii are in the unit of the points.
struct ShapeFeature
{
  int Dimension = 2; ///< 1: a loop, 2: a void
  SpaceSide Side = SpaceSide::Inside;
  FeatureKind Kind = FeatureKind::Noise;
  double Birth = 0.0;
  double Death = 0.0;
  /// death^2 - birth^2 exceeds the square of the sampling error: a feature of M, not of the
  /// samples.
  bool Trusted = false;
  double Error = 0.0; ///< the sampling error there
  /// The triangle where a ball of radius Distance() gets stuck.
  TriangleId Choke = TriangleId::None();
  /// radius at which what lies beyond is filled; a loop's: the last of its region
  double Fill = 0.0;
  /// For a handle or tunnel: basis loops of SurfaceHomology that it is the sum of.
  std::vector<std::size_t> Sum;

  /// Radius of the ball that gets stuck: where a loop of M is filled, or a void is closed.
  double Distance() const { return this->Dimension == 1 ? this->Death : this->Birth; }
  double Persistence() const { return this->Death - this->Birth; }
  /// How far the space widens behind the narrowing: Fill - Distance().
  double Widening() const { return this->Fill - this->Distance(); }
};

inline bool IsGenerator(const ShapeFeature& feature)
{
  return feature.Kind == FeatureKind::Handle || feature.Kind == FeatureKind::Tunnel;
}

/// What ShapeFeatures found.
struct FeatureDiagram
{
  std::vector<ShapeFeature> Features;          ///< ascending by Distance()
  std::array<double, 2> Reference{ 0.0, 0.0 }; ///< per side: largest trusted Death, 0 without any
  std::size_t ExpectedGenerators = 0;          ///< 2g
};

/**
 * The pairs of a filtration as features: sides and kinds decided, M's own classes set apart.
 *
 * M's own class in each bounded region of its complement is the pair, born below the error, with
 * the greatest death; it is kept as Noise. Pairs of equal birth and death, and those that die below
 * the error, are left out.
 */
VTKISTHMUSFILTERSCHOKINGLOOPS_EXPORT FeatureDiagram ShapeFeatures(
  const FeatureContext& context, SpaceRegions& regions, const ProgressCallback& progress = {});

}

#endif
