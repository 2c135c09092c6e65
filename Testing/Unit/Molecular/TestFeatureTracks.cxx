// Features that move, cross, pause, merge and split, followed by hand.

#include "FeatureTracks.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace isthmus;

TEST(FeatureTracks, CrossingOnesAreToldApartByRadiusAndResidues)
{
  std::vector<TrackFrame> frames;
  for (int t = 0; t <= 20; ++t)
  {
    const double x = -5.0 + 0.5 * t;
    const TrackedFeature right{ { x, 0.0, 0.0 }, 3.0, { "A|1", "A|2" } };
    const TrackedFeature left{ { -x, 0.2, 0.0 }, 1.0, { "A|8", "A|9" } };
    frames.push_back(t % 2 ? TrackFrame{ right, left } : TrackFrame{ left, right });
  }
  const FeatureTracks tracks = TrackFeatures(frames, {});
  EXPECT_EQ(tracks.NumberOfTracks, 2);
  for (int t = 0; t <= 20; ++t)
  {
    const auto& of = tracks.TrackOf[static_cast<std::size_t>(t)];
    EXPECT_EQ(of, t % 2 ? (std::vector<int>{ 1, 0 }) : (std::vector<int>{ 0, 1 }));
  }
  EXPECT_TRUE(tracks.Events.empty());
}

TEST(FeatureTracks, GapsAreBridgedUpToTheirLimit)
{
  const TrackedFeature one{ { 0, 0, 0 }, 2.0, {} };
  const std::vector<TrackFrame> frames{ { one }, {}, {}, { one }, {}, {}, {}, { one } };
  const FeatureTracks tracks = TrackFeatures(frames, { 4.0, 2 });
  EXPECT_EQ(tracks.TrackOf[3][0], 0);
  EXPECT_EQ(tracks.TrackOf[7][0], 1);
}

TEST(FeatureTracks, MergesAndSplitsAreNamed)
{
  const TrackedFeature a{ { -1, 0, 0 }, 2.0, { "A|1", "A|2", "A|3" } };
  const TrackedFeature b{ { 1.5, 0, 0 }, 1.5, { "A|7", "A|8" } };
  const TrackedFeature both{ { -0.5, 0, 0 }, 2.2, { "A|1", "A|2", "A|3", "A|7", "A|8" } };
  const FeatureTracks tracks =
    TrackFeatures({ { a, b }, { both }, { both }, { a, b } }, { 4.0, 0 });
  ASSERT_EQ(tracks.Events.size(), 2u);
  EXPECT_EQ(tracks.Events[0].Kind, TrackEventKind::Merge);
  EXPECT_EQ(tracks.Events[0].Track, 1);
  EXPECT_EQ(tracks.Events[0].Other, 0);
  EXPECT_EQ(tracks.Events[1].Kind, TrackEventKind::Split);
  EXPECT_EQ(tracks.Events[1].Frame, 3u);
  EXPECT_EQ(tracks.Events[1].Other, 0);
}

TEST(FeatureTracks, EmptyFramesAndBadOptions)
{
  EXPECT_EQ(TrackFeatures({}, {}).NumberOfTracks, 0);
  EXPECT_EQ(TrackFeatures({ {}, {} }, {}).NumberOfTracks, 0);
  EXPECT_THROW(TrackFeatures({}, { 0.0, 1 }), std::invalid_argument);
  EXPECT_THROW(TrackFeatures({}, { std::nan(""), 1 }), std::invalid_argument);
  EXPECT_THROW(TrackFeatures({}, { 4.0, -1 }), std::invalid_argument);
}
