#include "parallel/parallel_for.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <atomic>
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
