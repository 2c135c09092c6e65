// Loops are drawn on several threads: bitwise the same on any number of threads, and when drawn one
// by one; an abort ends the drawing and keeps the finished ones.

#include "ChokingLoops/ChokingLoops.h"
#include "ChokingLoops/LoopDrawing.h"
#include "ChokingSurfaces.h"
#include "SharedData.h"

#include <vtkSMPTools.h>

#include <gtest/gtest.h>

#include <functional>
#include <string>
#include <thread>

using namespace isthmus;
using namespace isthmus::testing;

namespace
{

constexpr int UntilGeodesic = 1000;

std::vector<std::size_t> AllFeatures(const ChokingLoops& loops)
{
  FeatureSelection selection;
  selection.MinimumPersistence = 1.0;
  return loops.Select(selection);
}

void OnThreads(int threads, const std::function<void()>& work)
{
  vtkSMPTools::LocalScope(vtkSMPTools::Config{ threads, "STDThread", false }, work);
}

/// From a new analysis, which has only the membranes of handles and tunnels yet.
DrawnFeatures DrawnOn(int threads, const TriangleMesh& mesh)
{
  ChokingLoops loops{ TriangleMesh(mesh) };
  DrawnFeatures drawn;
  OnThreads(threads, [&] { DrawFeatures(loops, AllFeatures(loops), UntilGeodesic, drawn); });
  return drawn;
}

void ExpectSame(const LoopFeature& a, const LoopFeature& b)
{
  EXPECT_EQ(a.Loops, b.Loops);
  EXPECT_EQ(a.Lengths, b.Lengths);
  EXPECT_EQ(a.Anchors, b.Anchors);
  EXPECT_EQ(a.Membrane, b.Membrane);
  EXPECT_EQ(a.Extra, b.Extra);
  EXPECT_EQ(a.Area, b.Area);
  EXPECT_EQ(a.SharpestBend, b.SharpestBend);
  EXPECT_EQ(a.Held, b.Held);
  EXPECT_EQ(a.Encircling, b.Encircling);
  EXPECT_EQ(a.Converged, b.Converged);
}

TEST(ParallelDrawing, IdenticalOnAnyNumberOfThreads)
{
  for (const char* name : { "3holes.off", "genus3.off", "soccerball.obj" })
  {
    ISTHMUS_NEEDS_SHARED_DATA(std::string("surfaces/") + name);
    const TriangleMesh mesh = ReadSurface(name);
    const DrawnFeatures serial = DrawnOn(1, mesh);
    for (const int threads : { 2, 5 })
    {
      SCOPED_TRACE(std::string(name) + " on " + std::to_string(threads));
      const DrawnFeatures drawn = DrawnOn(threads, mesh);
      ASSERT_EQ(drawn.size(), serial.size());
      for (const auto& [key, feature] : serial)
      {
        ASSERT_EQ(drawn.count(key), 1U);
        ExpectSame(feature, drawn.at(key));
      }
    }
  }
}

TEST(ParallelDrawing, MatchesDrawingOneByOne)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/genus3.off");
  const TriangleMesh mesh = ReadSurface("genus3.off");
  const DrawnFeatures drawn = DrawnOn(3, mesh);
  ChokingLoops loops{ TriangleMesh(mesh) };
  for (const auto& [key, feature] : drawn)
  {
    ExpectSame(feature, MakeLoopFeature(loops, key.first, key.second));
  }
}

TEST(ParallelDrawing, CallbacksRunOnTheCallingThreadAndAnAbortKeepsResults)
{
  ISTHMUS_NEEDS_SHARED_DATA("surfaces/soccerball.obj");
  ChokingLoops loops(ReadSurface("soccerball.obj"));
  const std::vector<std::size_t> all = AllFeatures(loops);
  const auto caller = std::this_thread::get_id();
  DrawnFeatures drawn;
  double last = 0.0;
  const auto half = [&](double done)
  {
    EXPECT_EQ(std::this_thread::get_id(), caller);
    EXPECT_GE(done, last);
    last = done;
    return done < 0.5;
  };
  OnThreads(
    3, [&] { EXPECT_THROW(DrawFeatures(loops, all, UntilGeodesic, drawn, half), Cancelled); });
  EXPECT_GE(drawn.size(), all.size() / 2);
  OnThreads(3, [&] { DrawFeatures(loops, all, UntilGeodesic, drawn); });
  EXPECT_EQ(drawn.size(), all.size());
}

}
