#include "parallel/parallel_for.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <unistd.h>

#include <atomic>
#include <fstream>
#include <stdexcept>
#include <thread>
#include <vector>

#include "parallel/deadline.hpp"

namespace gmcr::parallel {
namespace {

TEST(ParallelFor, VisitsEachIndexOnce) {
  for (const int threads : {1, 2, 7}) {
    for (const Index count : {0, 1, 9, 10, 11, 1000}) {
      std::vector<std::atomic<int>> visits(static_cast<std::size_t>(count));
      parallel_for(count, 10, threads, [&](Index begin, Index end) {
        for (Index i = begin; i < end; ++i) ++visits[static_cast<std::size_t>(i)];
      });
      for (const auto& visit : visits) EXPECT_EQ(visit, 1);
    }
  }
}

TEST(ParallelFor, CutsTheSameRangesForAnyNumberOfThreads) {
  const auto ranges = [](int threads) {
    std::vector<Index> end_of_begin(100, -1);
    parallel_for(95, 10, threads, [&](Index begin, Index end) {
      end_of_begin[static_cast<std::size_t>(begin)] = end;
    });
    return end_of_begin;
  };
  EXPECT_EQ(ranges(1), ranges(4));
  EXPECT_EQ(ranges(1)[90], 95);
}

TEST(ParallelFor, ForwardsAnExceptionOfTheBody) {
  for (const int threads : {1, 3}) {
    EXPECT_THROW(parallel_for(100, 1, threads,
                              [](Index begin, Index) {
                                if (begin == 42) throw std::runtime_error("42");
                              }),
                 std::runtime_error);
  }
}

TEST(ParallelFor, TakesNoOtherChunkAfterAnException) {
  std::atomic<int> num_visited = 0;
  EXPECT_THROW(parallel_for(1000, 1, 1,
                            [&](Index, Index) {
                              if (++num_visited == 3) throw std::runtime_error("3");
                            }),
               std::runtime_error);
  EXPECT_EQ(num_visited, 3);
}

/// Bytes that the process has in memory, those of allocators beside malloc as well.
std::size_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::size_t total = 0, resident = 0;
  file >> total >> resident;
  return resident * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

TEST(ParallelFor, LeavesNoMemoryBehind) {
  const auto call_often = [](int times) {
    std::atomic<Index> num_visited = 0;
    for (int i = 0; i < times; ++i) {
      parallel_for(40, 1, 2, [&](Index, Index) {
        for (int k = 0; k < 100; ++k) num_visited.fetch_add(1, std::memory_order_relaxed);
      });
    }
    return num_visited.load();
  };
  call_often(100);
  const std::size_t before = resident_bytes();
  EXPECT_EQ(call_often(5000), Index{5000 * 40 * 100});
  EXPECT_LT(resident_bytes(), before + 4'000'000);
}

TEST(CallBoth, CallsBothWithLoopsOfTheirOwn) {
  for (const int threads : {1, 2, 7}) {
    std::atomic<Index> first = 0, second = 0;
    const auto sum_to = [&](std::atomic<Index>& sum) {
      parallel_for(1000, 10, threads, [&](Index begin, Index end) { sum += end - begin; });
    };
    call_both(
        threads, [&] { sum_to(first); }, [&] { sum_to(second); });
    EXPECT_EQ(first, 1000);
    EXPECT_EQ(second, 1000);
  }
}

TEST(CallBoth, ForwardsAnExceptionOfEither) {
  const auto fail = [] { throw std::runtime_error("no"); };
  for (const int threads : {1, 2}) {
    EXPECT_THROW(call_both(threads, fail, [] {}), std::runtime_error);
    EXPECT_THROW(call_both(
                     threads, [] {}, fail),
                 std::runtime_error);
  }
}

TEST(ResolveNumThreads, KeepsARequestAndTurnsZeroIntoEveryCore) {
  EXPECT_EQ(resolve_num_threads(3), 3);
  EXPECT_GE(resolve_num_threads(0), 1);
}

std::size_t allowed_parallelism() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

TEST(ParallelFor, LeavesTheParallelismOfItsHostAsItIs) {
  const std::size_t before = allowed_parallelism();
  for (const int threads : {1, 2, 1000}) {
    std::atomic<Index> num_changed = 0, num_visited = 0;
    ::testing::internal::CaptureStderr();
    parallel_for(100, 1, threads, [&](Index, Index) {
      num_changed += allowed_parallelism() != before;
      ++num_visited;
    });
    EXPECT_EQ(::testing::internal::GetCapturedStderr(), "") << threads;
    EXPECT_EQ(num_changed, 0) << threads;
    EXPECT_EQ(num_visited, 100) << threads;
    EXPECT_EQ(allowed_parallelism(), before) << threads;
  }
}

TEST(ParallelFor, KeepsToTheArenaThatItIsCalledIn) {
  tbb::task_arena one_slot(1);
  std::atomic<Index> num_elsewhere = 0, num_visited = 0;
  one_slot.execute([&] {
    const auto here = std::this_thread::get_id();
    parallel_for(100, 1, 8, [&](Index, Index) {
      num_elsewhere += std::this_thread::get_id() != here;
      ++num_visited;
    });
  });
#ifndef GMCR_PLAIN_THREADS
  EXPECT_EQ(num_elsewhere, 0);
#endif
  EXPECT_EQ(num_visited, 100);
}

TEST(ParallelFor, KeepsToTheThreadsThatItsHostAllows) {
  const tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const auto here = std::this_thread::get_id();
  std::atomic<Index> num_elsewhere = 0, num_visited = 0;
  parallel_for(100, 1, 8, [&](Index, Index) {
    num_elsewhere += std::this_thread::get_id() != here;
    ++num_visited;
  });
#ifndef GMCR_PLAIN_THREADS
  EXPECT_EQ(num_elsewhere, 0);
#endif
  EXPECT_EQ(num_visited, 100);
}

}  // namespace
}  // namespace gmcr::parallel
