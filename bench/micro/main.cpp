// Times the kernels, on every instruction set, and the stages of a solve.
#include "gmcr/synthetic.hpp"
#include "micro/themes.hpp"

namespace gmcr::bench {

problem::Correspondences random_correspondences(Index count, double rate) {
  SyntheticOptions options;
  options.num_correspondences = count;
  options.outlier_rate = rate;
  options.seed = 1;
  const SyntheticProblem problem = make_synthetic(options);
  return problem::centre(problem.source, problem.target,
                         Eigen::ArrayXd::Constant(count, problem.noise_bound));
}

}  // namespace gmcr::bench

int main(int argc, char** argv) {
  gmcr::bench::register_kernels();
  gmcr::bench::register_stages();
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
}
