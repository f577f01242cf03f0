// Small clouds of any numbers through the front end.
#include <cmath>
#include <string>

#include "fuzz/bytes.hpp"
#include "fuzz/target.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::fuzz {
namespace {

constexpr Index kMostPoints = 80;

/// Points of small whole numbers, of any numbers, or of a bent sheet, which has a surface.
Points cloud_of(Bytes& input) {
  const auto n = static_cast<Index>(input.below(kMostPoints + 1));
  const std::size_t kind = input.below(4);
  Points points(3, n);
  for (Index i = 0; i < n; ++i) {
    if (kind == 0) {
      for (Index j = 0; j < 3; ++j) points(j, i) = input.number();
    } else if (kind == 1) {
      for (Index j = 0; j < 3; ++j) points(j, i) = 0.1 * input.raw<std::int8_t>();
    } else {
      const double x = static_cast<double>(i % 9), y = static_cast<double>(i) / 9;
      const double bend = 0.01 * input.raw<std::int8_t>();
      points.col(i) = Eigen::Vector3d(x, y, x * y / 20 + bend);
    }
  }
  return points;
}

FrontendOptions frontend_of(Bytes& input) {
  FrontendOptions frontend;
  if (input.flag()) frontend.voxel_size = input.flag() ? 0.5 : input.number();
  if (input.below(4) == 0) frontend.source_voxel_size = input.number();
  if (input.below(4) == 0) frontend.max_ratio = input.number();
  if (input.below(4) == 0) frontend.source_viewpoint = {input.number(), input.number(), 0};
  if (input.flag()) frontend.orientation = NormalOrientation::Outward;
  if (input.flag()) frontend.refine = Refine::None;
  frontend.mutual = input.flag();
  frontend.max_attempts = static_cast<int>(1 + input.below(2));
  return frontend;
}

Options options_of(Bytes& input) {
  Options options;
  options.time_limit = 0.5;
  options.num_threads = 1;
  if (input.below(4) == 0) options.noise_bound = input.number();
  if (input.flag()) options.scale_mode = ScaleMode::Estimated;
  if (input.below(4) == 0) options.scale = input.number();
  if (input.below(4) == 0) options.noise_mode = NoiseMode::Estimated;
  return options;
}

bool is_share(double share) { return share >= 0 && share <= 1; }

void check(const CloudResult& result) {
  require(result.registration.target_from_source.matrix().allFinite(), "a finite pose");
  require(result.registration.target_from_source.scale > 0, "a scale");
  require(is_share(result.fitness) && is_share(result.target_fitness), "fitness is a share");
  require(std::isfinite(result.overlap_rmse), "a finite distance");
  for (const Index i : result.registration.inliers) {
    require(i >= 0 && i < result.matches.source.cols(), "inliers are matches");
  }
  require(!result.verdict_reason.empty(), "a verdict with a reason");
}

}  // namespace

void register_small_clouds(std::string_view bytes) {
  Bytes input(bytes);
  const Points source = cloud_of(input);
  const Points target = input.flag() ? source : cloud_of(input);
  const FrontendOptions frontend = frontend_of(input);
  const Options options = options_of(input);
  try {
    check(register_clouds(source, target, frontend, options));
  } catch (const std::invalid_argument& error) {
    require(std::string(error.what()).find(": ") != std::string::npos, "a refusal by name");
  }
}

}  // namespace gmcr::fuzz
