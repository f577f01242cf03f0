#include "parallel/parallel_for.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <limits>
#include <stdexcept>
#include <stop_token>
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

TEST(Deadline, PassesWithARequestToStop) {
  std::stop_source source;
  const Deadline deadline(1000, source.get_token());
  const Deadline inner = deadline.within(500);
  EXPECT_FALSE(deadline.expired());
  EXPECT_LE(inner.remaining(), 500);
  source.request_stop();
  for (const Deadline& stopped : {deadline, inner}) {
    EXPECT_TRUE(stopped.expired());
    EXPECT_EQ(stopped.remaining(), 0);
  }
}

TEST(Deadline, OfZeroSecondsHasPassedAndOfInfinityNeverDoes) {
  EXPECT_TRUE(Deadline(0).expired());
  EXPECT_EQ(Deadline(0).remaining(), 0);
  EXPECT_FALSE(Deadline(std::numeric_limits<double>::infinity()).expired());
  EXPECT_GT(Deadline(1000).remaining(), 900);
}

}  // namespace
}  // namespace gmcr::parallel
