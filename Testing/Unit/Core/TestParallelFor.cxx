#include "Core/ParallelFor.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

#if defined(__linux__)
#include <sys/resource.h>
#include <unistd.h>
#endif

namespace
{

std::vector<int> VisitsPerIndex(
  std::int64_t count, std::int64_t grain, const isthmus::ProgressCallback& progress = {})
{
  std::vector<int> visits(static_cast<std::size_t>(count), 0);
  isthmus::ParallelFor(
    0, count, grain,
    [&](std::int64_t first, std::int64_t last)
    {
      EXPECT_LE(last - first, std::max<std::int64_t>(grain, 1));
      for (std::int64_t i = first; i < last; ++i)
      {
        ++visits[static_cast<std::size_t>(i)];
      }
    },
    progress);
  return visits;
}

}

TEST(ParallelFor, VisitsEveryIndexOnce)
{
  for (const std::int64_t count : { 0, 1, 7, 1000, 1001 })
  {
    for (const std::int64_t grain : { 0, 1, 3, 5000 })
    {
      const std::vector<int> visits = VisitsPerIndex(count, grain);
      EXPECT_EQ(visits, std::vector<int>(static_cast<std::size_t>(count), 1));
      EXPECT_EQ(visits, VisitsPerIndex(count, grain, [](double) { return true; }));
    }
  }
}

TEST(ParallelFor, RunsOnSeveralThreadsWhereVTKIsSequential)
{
  if (std::getenv("VTK_SMP_BACKEND_IN_USE") || std::thread::hardware_concurrency() < 2)
  {
    GTEST_SKIP() << "needs two cores and a backend that the user has not chosen";
  }
  std::mutex mutex;
  std::set<std::thread::id> threads;
  isthmus::ParallelFor(0, 64, 1,
    [&](std::int64_t, std::int64_t)
    {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      const std::lock_guard<std::mutex> lock(mutex);
      threads.insert(std::this_thread::get_id());
    });
  EXPECT_GE(threads.size(), 2u);
  EXPECT_GE(isthmus::ParallelThreads(), 2);
}

#if defined(__linux__)
/// VTK's thread pool terminates the program if there is no memory for a thread's stack.
TEST(ParallelFor, IsSequentialWhereNoThreadFits)
{
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const auto run = []
  {
    double pages = 0.0;
    std::ifstream("/proc/self/statm") >> pages;
    rlimit limit{};
    limit.rlim_max = RLIM_INFINITY;
    limit.rlim_cur =
      static_cast<rlim_t>(pages) * static_cast<rlim_t>(sysconf(_SC_PAGESIZE)) + (rlim_t{ 4 } << 20);
    setrlimit(RLIMIT_AS, &limit);
    std::vector<int> visits(1000, 0);
    isthmus::ParallelFor(0, 1000, 1,
      [&](std::int64_t first, std::int64_t last)
      {
        for (std::int64_t i = first; i < last; ++i)
        {
          ++visits[static_cast<std::size_t>(i)];
        }
      });
    std::_Exit(std::count(visits.begin(), visits.end(), 1) == 1000 ? 0 : 1);
  };
  EXPECT_EXIT(run(), ::testing::ExitedWithCode(0), "");
}
#endif

TEST(ParallelFor, RethrowsInTheCaller)
{
  EXPECT_THROW(isthmus::ParallelFor(0, 1000, 1,
                 [](std::int64_t first, std::int64_t)
                 {
                   if (first == 500)
                   {
                     throw std::runtime_error("piece 500");
                   }
                 }),
    std::runtime_error);
}

TEST(ParallelFor, ProgressRisesToOneOnTheCallersThread)
{
  std::vector<double> fractions;
  const std::thread::id caller = std::this_thread::get_id();
  VisitsPerIndex(1000, 1,
    [&](double fraction)
    {
      EXPECT_EQ(std::this_thread::get_id(), caller);
      fractions.push_back(fraction);
      return true;
    });
  ASSERT_FALSE(fractions.empty());
  EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
  EXPECT_DOUBLE_EQ(fractions.back(), 1.0);
}

TEST(ParallelFor, StopsOnRequest)
{
  std::atomic<int> pieces{ 0 };
  EXPECT_THROW(
    isthmus::ParallelFor(
      0, 1000000, 1, [&](std::int64_t, std::int64_t) { ++pieces; }, [](double) { return false; }),
    isthmus::Cancelled);
  EXPECT_LT(pieces, 1000);
}
