// Shortest loops round a choke, compared with a search without homology: on a torus, the winding
// numbers of a walk follow from the angles of its points.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingSurfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <random>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr double Large = 1.0;
constexpr double Small = 0.3;

/// A torus turned and moved, whose points are slightly perturbed; its analysis adds no points.
struct RoughTorus
{
  explicit RoughTorus(bool isTurned = false, double unit = 1.0)
    : Mesh(Torus(Large, Small, 48, 16))
  {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shift(-0.004, 0.004);
    for (Point3& p : this->Mesh.Points)
    {
      p = p + Point3{ shift(random), shift(random), shift(random) };
    }
    this->Straight = this->Mesh.Points;
    for (Point3& p : this->Mesh.Points)
    {
      // By 3-4-5 triangles.
      p = isTurned ? Point3{ 0.6 * p[0] - 0.8 * p[2], p[1], 0.8 * p[0] + 0.6 * p[2] } : p;
      p = unit * p;
    }
  }

  ChokingLoops Analyse() const
  {
    ChokingLoopParameters parameters;
    parameters.SampleSpacing = 1e3; // longer than any edge
    return ChokingLoops(this->Mesh, parameters);
  }

  /// Angle of an edge round the hole and round the tube, in turns.
  std::array<double, 2> Turns(SimplexId a, SimplexId b) const
  {
    const auto angles = [this](SimplexId i)
    {
      const Point3& p = this->Straight[static_cast<std::size_t>(i)];
      return std::array<double, 2>{ std::atan2(p[1], p[0]),
        std::atan2(p[2], std::hypot(p[0], p[1]) - Large) };
    };
    const auto from = angles(a);
    const auto to = angles(b);
    std::array<double, 2> turns;
    for (std::size_t k = 0; k < 2; ++k)
    {
      turns[k] = std::remainder(to[k] - from[k], 2.0 * M_PI) / (2.0 * M_PI);
    }
    return turns;
  }

  std::array<int, 2> CountWindings(const std::vector<SimplexId>& loop) const
  {
    std::array<double, 2> sum{ 0.0, 0.0 };
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const auto turns = this->Turns(loop[i], loop[(i + 1) % loop.size()]);
      sum = { sum[0] + turns[0], sum[1] + turns[1] };
    }
    return { static_cast<int>(std::round(sum[0])), static_cast<int>(std::round(sum[1])) };
  }

  TriangleMesh Mesh;
  std::vector<Point3> Straight; ///< where the points were before they were turned
};

/// Shortest closed walk along edges from `base` that winds round the tube once and not round the
/// hole (`axis` 1), or the other way: on the torus cut along both and glued fourfold.
double ShortestWinding(const RoughTorus& torus, SimplexId base, std::size_t axis)
{
  std::vector<std::vector<SimplexId>> beside(torus.Mesh.Points.size());
  for (const Triangle& t : torus.Mesh.Triangles)
  {
    for (std::size_t k = 0; k < 3; ++k)
    {
      beside[static_cast<std::size_t>(t[k])].push_back(static_cast<SimplexId>(t[(k + 1) % 3]));
    }
  }
  const auto cut = [&torus](SimplexId a, SimplexId b, std::size_t k)
  {
    // The cut is where the angle jumps from pi to -pi.
    const auto angle = [&](SimplexId i)
    {
      const Point3& p = torus.Straight[static_cast<std::size_t>(i)];
      return k == 0 ? std::atan2(p[1], p[0]) : std::atan2(p[2], std::hypot(p[0], p[1]) - Large);
    };
    return std::abs(angle(a) - angle(b)) > M_PI ? 1U : 0U;
  };
  using State = std::pair<SimplexId,
    unsigned>; // a point, and the cuts that were crossed an odd number of times
  std::map<State, double> known;
  std::priority_queue<std::pair<double, State>, std::vector<std::pair<double, State>>,
    std::greater<>>
    queue;
  queue.push({ 0.0, { base, 0U } });
  while (!queue.empty())
  {
    const auto [length, state] = queue.top();
    queue.pop();
    if (!known.emplace(state, length).second)
    {
      continue;
    }
    if (state.first == base && state.second == 1U << axis)
    {
      return length;
    }
    for (const SimplexId next : beside[static_cast<std::size_t>(state.first)])
    {
      const unsigned crossed =
        state.second ^ cut(state.first, next, 0) ^ (cut(state.first, next, 1) << 1U);
      const double step = Distance(torus.Mesh.Points[static_cast<std::size_t>(state.first)],
        torus.Mesh.Points[static_cast<std::size_t>(next)]);
      queue.push({ length + step, { next, crossed } });
    }
  }
  return HUGE_VAL;
}

std::size_t FindFeature(const ChokingLoops& loops, FeatureKind kind)
{
  const auto& features = loops.Diagram().Features;
  const auto found = std::find_if(
    features.begin(), features.end(), [kind](const ShapeFeature& f) { return f.Kind == kind; });
  EXPECT_NE(found, features.end());
  return static_cast<std::size_t>(found - features.begin());
}

double LengthOfLoop(const TriangleMesh& mesh, const std::vector<SimplexId>& loop)
{
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    length += Distance(mesh.Points[static_cast<std::size_t>(loop[i])],
      mesh.Points[static_cast<std::size_t>(loop[(i + 1) % loop.size()])]);
  }
  return length;
}

/// A fan from the choke point to all edges of one loop along edges of M.
void ExpectFan(const ChokingLoops& loops, std::size_t feature, const Membrane& membrane)
{
  ASSERT_EQ(membrane.Loops.size(), 1U);
  const std::vector<SimplexId>& loop = membrane.Loops[0];
  ASSERT_GE(loop.size(), 3U);
  ASSERT_EQ(membrane.Extra.size(), 1U);
  EXPECT_EQ(membrane.Extra[0], loops.ChokePoint(feature));
  ASSERT_EQ(membrane.Triangles.size(), loop.size());
  const auto apex = static_cast<SimplexId>(loops.Samples().Points.size());
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    EXPECT_TRUE(loops.Adjacency().Find(loop[i], loop[(i + 1) % loop.size()]).Exists());
    EXPECT_EQ(std::count(membrane.Triangles[i].begin(), membrane.Triangles[i].end(), apex), 1);
    EXPECT_EQ(std::count(membrane.Triangles[i].begin(), membrane.Triangles[i].end(), loop[i]), 1);
  }
}

// A handle's loops wind round the tube, a tunnel's round the hole, and the shortest of them is as
// short as any walk through one of the points where the ball touches.
TEST(EncirclingLoops, AreTheShortestOfTheirClass)
{
  const RoughTorus torus;
  const ChokingLoops loops = torus.Analyse();
  ASSERT_EQ(loops.Samples().Points.size(), torus.Mesh.Points.size());
  for (const FeatureKind kind : { FeatureKind::Handle, FeatureKind::Tunnel })
  {
    const std::size_t axis = kind == FeatureKind::Handle ? 1 : 0;
    const std::size_t feature = FindFeature(loops, kind);
    const std::vector<Membrane> found = loops.ComputeEncirclingMembranes(feature, 20.0);
    ASSERT_FALSE(found.empty());
    double shortest = HUGE_VAL;
    for (const SimplexId contact : loops.GetContacts(feature))
    {
      shortest = std::min(shortest, ShortestWinding(torus, contact, axis));
    }
    EXPECT_NEAR(LengthOfLoop(loops.Samples(), found[0].Loops[0]), shortest, 1e-12);
    for (const Membrane& membrane : found)
    {
      ExpectFan(loops, feature, membrane);
      const auto windings = torus.CountWindings(membrane.Loops[0]);
      EXPECT_EQ(std::abs(windings[axis]) % 2, 1);
      EXPECT_EQ(windings[1 - axis] % 2, 0) << "does not bound on that side";
      const auto contacts = loops.GetContacts(feature);
      EXPECT_TRUE(std::any_of(contacts.begin(), contacts.end(),
        [&](SimplexId c)
        {
          const auto& loop = membrane.Loops[0];
          return std::find(loop.begin(), loop.end(), c) != loop.end();
        }));
    }
  }
}

TEST(EncirclingLoops, AreWithinTheLimitShortestFirst)
{
  const RoughTorus torus;
  const ChokingLoops loops = torus.Analyse();
  const std::size_t handle = FindFeature(loops, FeatureKind::Handle);
  const std::vector<Membrane> all = loops.ComputeEncirclingMembranes(handle, 20.0);
  ASSERT_GE(all.size(), 2U);
  std::vector<double> lengths;
  for (const Membrane& membrane : all)
  {
    lengths.push_back(LengthOfLoop(loops.Samples(), membrane.Loops[0]));
  }
  // Edges traversed back and forth at the ends of a walk are removed, so the walk may be shorter
  // than when it was queued.
  EXPECT_LE(lengths.front(), *std::min_element(lengths.begin(), lengths.end()) + 1e-12);
  EXPECT_TRUE(loops.ComputeEncirclingMembranes(handle, 0.99 * lengths.front()).empty());
  const std::vector<Membrane> some =
    loops.ComputeEncirclingMembranes(handle, 1.01 * lengths.front());
  ASSERT_FALSE(some.empty());
  for (const Membrane& membrane : some)
  {
    EXPECT_LE(LengthOfLoop(loops.Samples(), membrane.Loops[0]), 1.01 * lengths.front());
  }
  EXPECT_TRUE(loops.ComputeEncirclingMembranes(handle, 0.0).empty());
}

TEST(EncirclingLoops, AreTheFirstOfAllWhereFewAreRequested)
{
  const RoughTorus torus;
  const ChokingLoops loops = torus.Analyse();
  for (const FeatureKind kind : { FeatureKind::Handle, FeatureKind::Tunnel })
  {
    const std::size_t feature = FindFeature(loops, kind);
    const std::vector<Membrane> all = loops.ComputeEncirclingMembranes(feature, 20.0);
    ASSERT_GE(all.size(), 2U);
    for (std::size_t most = 0; most <= all.size() + 1; ++most)
    {
      const std::vector<Membrane> some = loops.ComputeEncirclingMembranes(feature, 20.0, most);
      ASSERT_EQ(some.size(), std::min(most, all.size()));
      for (std::size_t i = 0; i < some.size(); ++i)
      {
        EXPECT_EQ(some[i].Loops, all[i].Loops);
      }
    }
  }
}

TEST(EncirclingLoops, DoNotDependOnPlaceOrUnit)
{
  const RoughTorus torus;
  const ChokingLoops loops = torus.Analyse();
  const RoughTorus other(true, 4.0);
  const ChokingLoops otherLoops = other.Analyse();
  for (const FeatureKind kind : { FeatureKind::Handle, FeatureKind::Tunnel })
  {
    const auto found = loops.ComputeEncirclingMembranes(FindFeature(loops, kind), 20.0);
    const auto others = otherLoops.ComputeEncirclingMembranes(FindFeature(otherLoops, kind), 80.0);
    ASSERT_FALSE(found.empty());
    ASSERT_FALSE(others.empty());
    EXPECT_NEAR(LengthOfLoop(otherLoops.Samples(), others[0].Loops[0]),
      4.0 * LengthOfLoop(loops.Samples(), found[0].Loops[0]), 1e-9);
  }
}

TEST(EncirclingLoops, AreMissingWhereNothingBounds)
{
  const ChokingLoops loops{ Revolution(
    [](double z) { return DumbbellRadius(z, 0.4); }, -2.0, 2.0, 30, 60) };
  const std::size_t neck = FindFeature(loops, FeatureKind::Additional);
  EXPECT_TRUE(loops.ComputeEncirclingMembranes(neck, 100.0).empty());
}

// Straight from each contact to the next, if the ball has contacts all round.
TEST(ContactLoop, PassesAllPointsWhereTheBallTouches)
{
  const RoughTorus torus;
  const ChokingLoops loops = torus.Analyse();
  const std::size_t handle = FindFeature(loops, FeatureKind::Handle);
  const auto membrane = loops.ComputeContactMembrane(handle, 20.0);
  ASSERT_TRUE(membrane);
  ExpectFan(loops, handle, *membrane);
  const auto& loop = membrane->Loops[0];
  for (const SimplexId c : loops.GetContacts(handle))
  {
    EXPECT_NE(std::find(loop.begin(), loop.end(), c), loop.end());
  }
  EXPECT_EQ(std::abs(torus.CountWindings(loop)[1]), 1);
  EXPECT_EQ(torus.CountWindings(loop)[0], 0);
  EXPECT_FALSE(loops.ComputeContactMembrane(handle, 1e-3)) << "paths are no longer than asked";
}

}
