// Memory that is used comes back: after many solves there is as much of it as before.
#include <gtest/gtest.h>
#include <malloc.h>

#include <cstddef>
#include <thread>
#include <vector>

#include "gmcr/registration.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr {
namespace {

void solve(std::uint64_t seed) {
  SyntheticOptions synthetic;
  synthetic.num_correspondences = 60;
  synthetic.outlier_rate = 0.6;
  synthetic.seed = seed;
  const SyntheticProblem problem = make_synthetic(synthetic);
  Options options;
  options.noise_bound = problem.noise_bound;
  options.scale_mode = seed % 3 == 0 ? ScaleMode::Estimated : ScaleMode::Known;
  options.method = seed % 5 == 0 ? Method::Paper : Method::Gmcr;
  options.num_threads = 2;
  register_correspondences(problem.source, problem.target, options);
}

void solve_on_threads(int num_threads, int each) {
  std::vector<std::jthread> threads;
  for (int t = 0; t < num_threads; ++t) {
    threads.emplace_back([=] {
      for (int i = 0; i < each; ++i) solve(static_cast<std::uint64_t>(t * each + i));
    });
  }
}

/// Bytes in use in all arenas of malloc.
std::size_t bytes_in_use() {
  const struct mallinfo2 info = mallinfo2();
  return info.uordblks + info.hblkhd;
}

TEST(Memory, DoesNotGrowWithTheNumberOfSolvesOrThreads) {
  constexpr int kThreads = 8, kSolves = 100;
  solve_on_threads(kThreads, kSolves);  // pools of threads, and what a thread keeps
  const std::size_t before = bytes_in_use();
  for (int repeat = 0; repeat < 3; ++repeat) solve_on_threads(kThreads, kSolves);
  // a solve of this size takes 100 kB, so that one block in a hundred solves would be seen
  EXPECT_LT(bytes_in_use(), before + 300'000);
}

}  // namespace
}  // namespace gmcr
