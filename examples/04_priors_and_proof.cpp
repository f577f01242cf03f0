// What is known beforehand, a proof of the best consensus, other answers, and how sure the pose is.
#include <cmath>
#include <cstdio>

#include "gmcr/registration.hpp"

int main() {
  // 40 points that turned by 40 degrees about gravity, and 25 of them that also match as if the
  // whole had been turned upside down; 60 more matches are wrong
  const double angle = 40 * 3.14159265358979 / 180;
  gmcr::Points source = gmcr::Points::Random(3, 125), target = gmcr::Points::Random(3, 125);
  source.middleCols(40, 25) = source.leftCols(25);
  for (gmcr::Index i = 0; i < 65; ++i) {
    const double flip = i < 40 ? 1 : -1;
    target(0, i) = std::cos(angle) * source(0, i) - flip * std::sin(angle) * source(1, i);
    target(1, i) = std::sin(angle) * source(0, i) + flip * std::cos(angle) * source(1, i);
    target(2, i) = flip * source(2, i);
  }
  target.leftCols(65) += 0.005 * gmcr::Points::Random(3, 65);  // noise

  gmcr::Options options;
  options.noise_bound = 0.01;  // metres
  options.num_hypotheses = 2;
  options.certify = true;
  const gmcr::Result free = gmcr::register_correspondences(source, target, options);

  options.gravity = gmcr::GravityPrior{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(),
                                       5 * 3.14159265358979 / 180};
  const gmcr::Result upright = gmcr::register_correspondences(source, target, options);

  std::printf("without gravity: %zu agree, proven best: %s, runner-up %.0f %%\n",
              free.inliers.size(), free.certificate.certified ? "yes" : "no",
              100 * free.runner_up_ratio());
  std::printf("with gravity: %zu agree, runner-up %.0f %%\n", upright.inliers.size(),
              100 * upright.runner_up_ratio());
  if (upright.covariance) {
    std::printf("the translation is known to %.2g m\n",
                std::sqrt(upright.covariance->matrix.diagonal().segment<3>(3).maxCoeff()));
  }
  const bool told_apart = free.runner_up_ratio() > 0.4 && upright.runner_up_ratio() < 0.4;
  return free.certificate.certified && told_apart ? 0 : 1;
}
