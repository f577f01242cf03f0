// A process that has solved forks, as servers and Python's multiprocessing do: its child solves
// too, and comes to the same bits.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "gmcr/registration.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr {
namespace {

/// Large enough to start threads.
Eigen::Matrix4d solved() {
  SyntheticOptions synthetic;
  synthetic.num_correspondences = 1500;
  synthetic.outlier_rate = 0.8;
  const SyntheticProblem problem = make_synthetic(synthetic);
  Options options;
  options.noise_bound = problem.noise_bound;
  options.num_threads = 4;
  const Result result = register_correspondences(problem.source, problem.target, options);
  EXPECT_EQ(result.status, Status::Ok);
  return result.target_from_source.matrix();
}

TEST(Fork, AfterASolveLeavesAChildThatSolvesTheSame) {
  const Eigen::Matrix4d pose = solved();
  const pid_t child = fork();
  ASSERT_GE(child, 0);
  if (child == 0) {
    alarm(60);  // ends a child that waits for threads which it does not have
    _exit(solved() == pose ? 0 : 1);
  }
  int status = 0;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  ASSERT_TRUE(WIFEXITED(status)) << "signal " << WTERMSIG(status);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_EQ(solved(), pose);
}

}  // namespace
}  // namespace gmcr
