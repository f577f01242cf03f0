#include "parallel/deadline.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <limits>
#include <stop_token>
#include <thread>

namespace gmcr::parallel {
namespace {

TEST(Stopwatch, RunsFromItsConstructionOn) {
  const Stopwatch stopwatch;
  const double first = stopwatch.elapsed();
  EXPECT_GE(first, 0);
  std::this_thread::sleep_for(std::chrono::milliseconds(2));
  EXPECT_GE(stopwatch.elapsed(), first + 2e-3);
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
