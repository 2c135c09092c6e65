#include "Core/ParallelFor.h"

#include "Core/SystemMemory.h"

#include <vtkSMPTools.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <mutex>
#include <string>

#if defined(__unix__) || defined(__APPLE__)
#include <pthread.h>
#endif

namespace isthmus
{
namespace
{

constexpr std::int64_t JobsPerThread = 8;

bool SequentialByDefault()
{
  return std::strcmp(vtkSMPTools::GetBackend(), "Sequential") == 0 &&
    std::getenv("VTK_SMP_BACKEND_IN_USE") == nullptr;
}

/// Runs `work` under the backend that our loops use.
template <typename Work>
void WithBackend(Work&& work)
{
  if (SequentialByDefault())
  {
    // Spelt as a std::string: a literal would convert to bool and switch on nested parallelism.
    vtkSMPTools::LocalScope(vtkSMPTools::Config(std::string("STDThread")), work);
  }
  else
  {
    work();
  }
}

/// Whether the address space that this process may have (ulimit -v) has room for the stacks of
/// `threads`. VTK's pool ends the program when it cannot start one of its threads.
bool StacksFit(int threads)
{
  const double left = AddressSpaceLeft();
  if (std::isinf(left))
  {
    return true;
  }
  std::size_t stack = std::size_t{ 8 } << 20;
#if defined(__unix__) || defined(__APPLE__)
  pthread_attr_t attributes;
  if (pthread_attr_init(&attributes) == 0)
  {
    pthread_attr_getstacksize(&attributes, &stack);
    pthread_attr_destroy(&attributes);
  }
#endif
  // Beside its stack, a thread has local storage; what the loop itself allocates comes on top.
  constexpr double more = 1 << 20;
  constexpr double spare = 8 << 20;
  return left > static_cast<double>(threads) * (static_cast<double>(stack) + more) + spare;
}

/// Stores the first exception of any thread, since none may leave a vtkSMPTools functor.
class FirstException
{
public:
  bool Caught() const { return this->Seen.load(std::memory_order_relaxed); }

  void Store(const std::exception_ptr& exception)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    if (!this->Seen.exchange(true))
    {
      this->Exception = exception;
    }
  }

  void Rethrow() const
  {
    if (this->Exception)
    {
      std::rethrow_exception(this->Exception);
    }
  }

private:
  std::atomic<bool> Seen{ false };
  std::mutex Mutex;
  std::exception_ptr Exception;
};

void RunRound(std::int64_t begin, std::int64_t end, std::int64_t grain, const RangeBody& body)
{
  FirstException failure;
  // Orders the work of the threads before the code after the loop, as VTK does; from 9.3
  // on by a std::future in its own library, which ThreadSanitizer does not see.
  std::atomic<int> done{ 0 };
  auto guarded = [&](vtkIdType first, vtkIdType last)
  {
    // The Sequential backend, or any backend for a small range, passes the whole range at once: it
    // is then split here, since bodies size their scratch memory by the grain.
    for (std::int64_t piece = first; piece < last && !failure.Caught(); piece += grain)
    {
      try
      {
        body(piece, std::min<std::int64_t>(piece + grain, last));
      }
      catch (...)
      {
        failure.Store(std::current_exception());
      }
    }
    done.fetch_add(1, std::memory_order_release);
  };
  const int threads = ParallelThreads();
  if (!StacksFit(threads))
  {
    guarded(begin, end);
    failure.Rethrow();
    return;
  }
  // Few jobs, each of many pieces: VTK 9.3's pool ends the program when it finds no memory for its
  // list of them.
  const std::int64_t pieces = (end - begin) / grain;
  const std::int64_t together = std::max<std::int64_t>(1, pieces / (JobsPerThread * threads));
  WithBackend([&]() { vtkSMPTools::For(begin, end, grain * together, guarded); });
  done.load(std::memory_order_acquire);
  failure.Rethrow();
}

}

void ParallelFor(std::int64_t begin, std::int64_t end, std::int64_t grain, const RangeBody& body,
  const ProgressCallback& progress)
{
  grain = std::max<std::int64_t>(grain, 1);
  if (!progress)
  {
    RunRound(begin, end, grain, body);
    return;
  }
  using Clock = std::chrono::steady_clock;
  constexpr double roundSeconds = 0.1;
  std::int64_t round = grain * ParallelThreads();
  for (std::int64_t first = begin; first < end;)
  {
    const std::int64_t last = std::min(end, first + round);
    const Clock::time_point start = Clock::now();
    RunRound(first, last, grain, body);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    Report(progress, static_cast<double>(last - begin) / static_cast<double>(end - begin));
    first = last;
    // Grow at most fourfold, since the first rounds are also the ones that touch cold memory.
    const double factor = std::clamp(roundSeconds / std::max(seconds, 1e-9), 0.25, 4.0);
    round = std::max(grain * ParallelThreads(),
      static_cast<std::int64_t>(static_cast<double>(round) * factor) / grain * grain);
  }
}

int ParallelThreads()
{
  int threads = 1;
  WithBackend([&]() { threads = vtkSMPTools::GetEstimatedNumberOfThreads(); });
  return threads;
}

}
