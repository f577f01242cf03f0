#pragma once

#include <Eigen/Geometry>
#include <numbers>
#include <random>

#include "cli/tool.hpp"
#include "gmcr/io.hpp"

namespace gmcr::test {

/// Matches of which 36 follow a motion that keeps the source upright to within 3 degrees and moves
/// it by 0.5 m, 40 one that tips it over and moves it by 5 m, and 6 none.
class TwoMotions : public testing::Test {
 protected:
  static constexpr Index kNumUpright = 36;
  static constexpr Index kNumTipped = 40;
  static constexpr Index kNumWrong = 6;

  TwoMotions() {
    using Eigen::AngleAxisd;
    using Eigen::Vector3d;
    constexpr double kDegree = std::numbers::pi / 180;
    upright_.rotation = AngleAxisd(3 * kDegree, Vector3d::UnitX()).matrix() *
                        AngleAxisd(40 * kDegree, Vector3d::UnitZ()).matrix();
    upright_.translation << 0.3, 0.4, 0;
    tipped_.rotation = AngleAxisd(120 * kDegree, Vector3d::UnitX()).matrix();
    tipped_.translation << 3, 0, 4;
    std::mt19937 random(3);
    const auto uniform = [&] { return static_cast<double>(random()) / std::mt19937::max(); };
    source_.resize(3, kNumUpright + kNumTipped + kNumWrong);
    for (double& value : source_.reshaped()) value = uniform();
    target_ = 9 * source_;
    for (Index i = 0; i < kNumUpright; ++i) target_.col(i) = upright_ * source_.col(i);
    for (Index i = kNumUpright; i < kNumUpright + kNumTipped; ++i) {
      target_.col(i) = tipped_ * source_.col(i);
    }
    for (Index i = kNumUpright + kNumTipped; i < source_.cols(); ++i) {
      target_.col(i) << 20 * uniform(), 20 * uniform(), 20 * uniform();
    }
    // a thousandth of the bound, so that there are residuals to speak of
    for (double& value : target_.reshaped()) value += 1e-5 * uniform();
    write_matches(folder_ / "m.csv", source_, target_);
    write_transform(folder_ / "upright.txt", upright_);
  }

  std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }

  std::string command(const std::string& options) const {
    return "solve " + path("m.csv") + " --noise-bound 0.01 " + options;
  }

  nlohmann::json solve(const std::string& options) const { return run_json(command(options)); }

  TemporaryFolder folder_;
  Points source_;
  Points target_;
  Similarity upright_;
  Similarity tipped_;
};

}  // namespace gmcr::test
