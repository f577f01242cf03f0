#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <vector>

#include "gmcr/options.hpp"

namespace gmcr {
namespace {

struct BadOption {
  const char* field;
  std::function<void(Options&)> spoil;
};

TEST(Options, NamesTheFieldThatIsOutOfRange) {
  const double nan = std::nan(""), inf = std::numeric_limits<double>::infinity();
  const std::vector<BadOption> cases = {
      {"noise_bound", [](Options& o) { o.noise_bound = 0; }},
      {"noise_bound", [](Options& o) { o.noise_bound = -1; }},
      {"noise_bound", [&](Options& o) { o.noise_bound = nan; }},
      {"noise_bound", [&](Options& o) { o.noise_bound = inf; }},
      {"noise_bound", [](Options& o) { o.noise_bounds = {0.1}; }},
      {"noise_bounds[1]",
       [](Options& o) {
         o.noise_bound = 0;
         o.noise_bounds = {0.1, 0};
       }},
      {"scale", [](Options& o) { o.scale = -2; }},
      {"scale",
       [](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale = 2;
       }},
      {"scale_range",
       [](Options& o) {
         o.scale_range = ScaleRange{1, 2};
       }},
      {"scale_range.min",
       [](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale_range = ScaleRange{0, 2};
       }},
      {"scale_range.min",
       [](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale_range = ScaleRange{3, 2};
       }},
      {"scale_range.max",
       [&](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale_range = ScaleRange{1, inf};
       }},
      {"num_hypotheses", [](Options& o) { o.num_hypotheses = 0; }},
      {"num_hypotheses", [](Options& o) { o.num_hypotheses = -3; }},
      {"num_hypotheses",
       [](Options& o) {
         o.method = Method::Paper;
         o.num_hypotheses = 2;
       }},
      {"certify",
       [](Options& o) {
         o.method = Method::Paper;
         o.certify = true;
       }},
      {"num_threads", [](Options& o) { o.num_threads = -1; }},
      {"time_limit", [](Options& o) { o.time_limit = 0; }},
      {"time_limit", [&](Options& o) { o.time_limit = nan; }},
      {"memory_limit", [](Options& o) { o.memory_limit = 0; }},
  };
  for (const auto& [field, spoil] : cases) {
    Options options;
    options.noise_bound = 0.1;
    EXPECT_NO_THROW(options.validate());
    spoil(options);
    try {
      options.validate();
      FAIL() << field;
    } catch (const InvalidOption& error) {
      EXPECT_EQ(error.option(), field) << error.what();
    }
  }
}

TEST(Options, RefuseMagnitudesOutOfRange) {
  const std::vector<BadOption> cases = {
      {"noise_bound", [](Options& o) { o.noise_bound = 1e158; }},
      {"noise_bound", [](Options& o) { o.noise_bound = 9e-51; }},
      {"noise_bounds[1]",
       [](Options& o) {
         o.noise_bound = 0;
         o.noise_bounds = {1e50, 1.1e50};
       }},
      {"scale", [](Options& o) { o.scale = 1e51; }},
      {"scale_range.min",
       [](Options& o) {
         o.scale_mode = ScaleMode::Estimated;
         o.scale_range = ScaleRange{1e-60, 1};
       }},
      {"max_translation", [](Options& o) { o.max_translation = 1e60; }},
      {"initial_pose.target_from_source.translation",
       [](Options& o) {
         o.initial_pose.emplace();
         o.initial_pose->target_from_source.translation[1] = -1e60;
       }},
      {"initial_pose.max_translation",
       [](Options& o) {
         o.initial_pose.emplace();
         o.initial_pose->max_translation = 1e60;
       }},
  };
  for (const auto& [field, spoil] : cases) {
    Options options;
    options.noise_bound = kLargestMagnitude;
    options.scale = kLeastMagnitude;
    EXPECT_NO_THROW(options.validate());
    spoil(options);
    try {
      options.validate();
      FAIL() << field;
    } catch (const InvalidOption& error) {
      EXPECT_EQ(error.option(), field) << error.what();
    }
  }
}

TEST(Priors, NameTheFieldThatIsOutOfRange) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  struct Case {
    const char* field;
    std::function<void(Priors&)> spoil;
  };
  const std::vector<Case> cases = {
      {"gravity.source", [](Priors& p) { p.gravity->source.setZero(); }},
      {"gravity.source", [](Priors& p) { p.gravity->source[1] = std::nan(""); }},
      {"gravity.source", [](Priors& p) { p.gravity->source[1] = 1e60; }},
      {"gravity.target",
       [](Priors& p) {
         p.gravity->target = {0, 1e-60, 0};
       }},
      {"gravity.target", [&](Priors& p) { p.gravity->target[2] = kInfinity; }},
      {"gravity.max_tilt", [](Priors& p) { p.gravity->max_tilt = -0.1; }},
      {"gravity.max_tilt", [](Priors& p) { p.gravity->max_tilt = 30; }},
      {"initial_pose.max_rotation", [](Priors& p) { p.initial_pose->max_rotation = 3.2; }},
      {"initial_pose.max_rotation", [](Priors& p) { p.initial_pose->max_rotation = std::nan(""); }},
      {"initial_pose.max_translation", [](Priors& p) { p.initial_pose->max_translation = -1; }},
      {"initial_pose.target_from_source.rotation",
       [](Priors& p) { p.initial_pose->target_from_source.rotation *= 1.01; }},
      {"initial_pose.target_from_source.rotation",
       [](Priors& p) { p.initial_pose->target_from_source.rotation *= -1; }},
      {"initial_pose.target_from_source.translation",
       [](Priors& p) { p.initial_pose->target_from_source.translation[0] = std::nan(""); }},
      {"max_translation", [](Priors& p) { p.max_translation = 0; }},
      {"max_translation", [](Priors& p) { p.max_translation = std::nan(""); }},
  };
  for (const auto& [field, spoil] : cases) {
    Priors priors;
    priors.gravity =
        GravityPrior{Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitZ(), std::numbers::pi};
    priors.initial_pose = InitialPose{Similarity{}, std::numbers::pi, 0};
    EXPECT_NO_THROW(priors.validate());
    spoil(priors);
    try {
      priors.validate();
      FAIL() << field;
    } catch (const InvalidOption& error) {
      EXPECT_EQ(error.option(), field) << error.what();
    }
  }
}

}  // namespace
}  // namespace gmcr
