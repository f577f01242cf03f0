// Putative correspondences, most of them wrong, to a pose.
#include <cstdio>

#include "gmcr/registration.hpp"

int main() {
  // 100 points and their images under a quarter turn; the images of 70 of them are replaced by
  // noise
  gmcr::Points source = gmcr::Points::Random(3, 100), target(3, 100);
  target.row(0) = -source.row(1);
  target.row(1) = source.row(0);
  target.row(2) = source.row(2);
  target.rightCols(70) = gmcr::Points::Random(3, 70);

  gmcr::Options options;
  options.noise_bound = 0.01;  // metres
  const gmcr::Result result = gmcr::register_correspondences(source, target, options);

  std::printf("%s: %zu of 100 agree, at most %td could\n", to_string(result.status),
              result.inliers.size(), result.certificate.upper);
  return result.status == gmcr::Status::Ok && result.inliers.size() >= 30 ? 0 : 1;
}
