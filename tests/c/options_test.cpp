#include <gtest/gtest.h>

#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "c/objects.hpp"
#include "c/pointers.hpp"
#include "options/table.hpp"

namespace gmcr::c {
namespace {

OptionsPointer new_options() { return OptionsPointer(gmcr_options_new()); }

TEST(OptionsInC, AreTheDefaultsUntilTheyAreSet) {
  const OptionsPointer options = new_options();
  EXPECT_EQ(options->options.num_hypotheses, Options{}.num_hypotheses);
  EXPECT_EQ(options->frontend.max_attempts, FrontendOptions{}.max_attempts);
  EXPECT_STREQ(gmcr_options_message(options.get()), "");
}

TEST(OptionsInC, AreSetByTheNamesThatTheyHaveElsewhere) {
  const OptionsPointer options = new_options();
  gmcr_options* o = options.get();
  EXPECT_EQ(gmcr_options_set_number(o, "noise_bound", 0.25), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_number(o, "num_hypotheses", 3), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_number(o, "certify", 1), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_number(o, "memory_limit", 1e9), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_number(o, "time_limit", std::numeric_limits<double>::infinity()),
            GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_word(o, "scale_mode", "estimated"), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_word(o, "orientation", "outward"), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_number(o, "voxel_size", 0.5), GMCR_SUCCESS);
  const std::vector<double> two = {0.5, 2}, three = {0, 0, -1};
  EXPECT_EQ(gmcr_options_set_numbers(o, "scale_range", two.data(), 2), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_numbers(o, "noise_bounds", three.data(), 3), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_numbers(o, "source_viewpoint", three.data(), 3), GMCR_SUCCESS);

  EXPECT_EQ(o->options.noise_bound, 0.25);
  EXPECT_EQ(o->options.num_hypotheses, 3);
  EXPECT_TRUE(o->options.certify);
  EXPECT_EQ(o->options.memory_limit, 1000000000u);
  EXPECT_EQ(o->options.time_limit, std::numeric_limits<double>::infinity());
  EXPECT_EQ(o->options.scale_mode, ScaleMode::Estimated);
  EXPECT_EQ(o->frontend.orientation, NormalOrientation::Outward);
  EXPECT_EQ(o->frontend.voxel_size, 0.5);
  EXPECT_EQ(o->options.scale_range.value().max, 2);
  EXPECT_EQ(o->options.noise_bounds, three);
  EXPECT_EQ(o->frontend.source_viewpoint.z(), -1);
}

TEST(OptionsInC, ReachIntoThePriors) {
  const OptionsPointer options = new_options();
  gmcr_options* o = options.get();
  const double up[] = {0, 0, 1};
  const double pose[] = {0, -1, 0, 5, 1, 0, 0, 6, 0, 0, 1, 7, 0, 0, 0, 1};
  EXPECT_EQ(gmcr_options_set_numbers(o, "gravity.source", up, 3), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_numbers(o, "gravity.target", up, 3), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_number(o, "gravity.max_tilt", 0.1), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_numbers(o, "initial_pose.target_from_source", pose, 16), GMCR_SUCCESS);
  EXPECT_EQ(gmcr_options_set_number(o, "initial_pose.max_rotation", 0.2), GMCR_SUCCESS);

  ASSERT_TRUE(o->options.gravity && o->options.initial_pose);
  EXPECT_EQ(o->options.gravity->source.z(), 1);
  EXPECT_EQ(o->options.gravity->max_tilt, 0.1);
  EXPECT_EQ(o->options.initial_pose->max_rotation, 0.2);
  EXPECT_EQ(o->options.initial_pose->target_from_source.translation, (Eigen::Vector3d{5, 6, 7}));
  EXPECT_LT(o->options.initial_pose->target_from_source.rotation(0, 1), -0.99);
}

/// One of the calls sets each option; what calls the caller back has one of its own.
template <class Struct>
void expect_all_known() {
  options::for_each_option<Struct>([](const auto& option) {
    const OptionsPointer options = new_options();
    const std::string name = option.about.name;
    if (name == "gravity" || name == "initial_pose") return;  // whose parts are set
    gmcr_options_set_number(options.get(), name.c_str(), 1);
    EXPECT_EQ(std::string(gmcr_options_message(options.get())).find("no such option"),
              std::string::npos)
        << name;
  });
}

TEST(OptionsInC, AreAllOfTheTable) {
  expect_all_known<Options>();
  expect_all_known<FrontendOptions>();
}

/// What is said of a mistake.
std::string mistake(gmcr_error error, const gmcr_options* options) {
  EXPECT_EQ(error, GMCR_INVALID_ARGUMENT);
  return gmcr_options_message(options);
}

TEST(OptionsInC, AreLeftAsTheyWereByAMistakeThatIsNamed) {
  const OptionsPointer options = new_options();
  gmcr_options* o = options.get();
  const double numbers[] = {1, 2, 3};
  EXPECT_EQ(mistake(gmcr_options_set_number(o, "voxel", 1), o), "voxel: there is no such option");
  EXPECT_EQ(mistake(gmcr_options_set_word(o, "method", "magic"), o),
            "method: magic is not one of gmcr|paper");
  EXPECT_EQ(mistake(gmcr_options_set_number(o, "method", 1), o), "method: takes a word");
  EXPECT_EQ(mistake(gmcr_options_set_word(o, "scale", "two"), o), "scale: takes a number");
  EXPECT_EQ(mistake(gmcr_options_set_numbers(o, "scale_range", numbers, 3), o),
            "scale_range: takes 2 numbers, not 3");
  EXPECT_EQ(mistake(gmcr_options_set_number(o, "progress", 1), o),
            "progress: has a call of its own");
  for (const double number : {0.5, 1e10, -1e10, std::numeric_limits<double>::quiet_NaN()}) {
    mistake(gmcr_options_set_number(o, "num_threads", number), o);
  }
  for (const double number : {2.0, -1.0, 0.5}) {
    mistake(gmcr_options_set_number(o, "certify", number), o);
  }
  mistake(gmcr_options_set_number(o, "memory_limit", -1), o);
  mistake(gmcr_options_set_number(o, "memory_limit", 18446744073709551616.0), o);
  mistake(gmcr_options_set_number(o, nullptr, 1), o);
  EXPECT_EQ(gmcr_options_set_number(nullptr, "scale", 1), GMCR_INVALID_ARGUMENT);
  EXPECT_EQ(o->options.num_threads, 0);
  EXPECT_FALSE(o->options.certify);
  EXPECT_EQ(gmcr_options_set_number(o, "scale", 2), GMCR_SUCCESS);
  EXPECT_STREQ(gmcr_options_message(o), "");
}

}  // namespace
}  // namespace gmcr::c
