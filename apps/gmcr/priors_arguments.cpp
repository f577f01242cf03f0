#include "priors_arguments.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "gmcr/io.hpp"
#include "validators.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kGroup = "Priors";
constexpr const char* kGravity = "--gravity";

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// At most pi, which 180 degrees may exceed by rounding.
double radians(double degrees) {
  return std::min(std::numbers::pi, degrees * std::numbers::pi / 180);
}

std::vector<double> parse_gravity(const CLI::results_t& given) {
  std::vector<double> values;
  for (const std::string& text : given) {
    const std::optional<double> value = to_number(text);
    if (!value || !std::isfinite(*value)) {
      throw CLI::ValidationError(kGravity, "'" + text +
                                               "' is no coordinate; it takes 3 or 6 of them, and "
                                               "files go before it");
    }
    values.push_back(*value);
  }
  if (values.size() != 3 && values.size() != 6) {
    throw CLI::ValidationError(
        kGravity,
        fmt::format("{} values, but a direction has 3 and one for each frame 6", values.size()));
  }
  for (std::size_t start = 0; start < values.size(); start += 3) {
    if (Eigen::Vector3d(&values[start]).isZero(0)) {
      throw CLI::ValidationError(kGravity, "(0, 0, 0) is no direction");
    }
  }
  return values;
}

}  // namespace

void PriorsArguments::add_to(CLI::App& command) {
  auto* gravity_option = command.add_option(
      kGravity,
      [this](const CLI::results_t& given) {
        gravity = parse_gravity(given);
        return true;
      },
      "Direction of gravity in the source frame and, where it differs, in the target frame");
  gravity_option->expected(3, 6)->type_name("X Y Z [X Y Z]")->group(kGroup);
  command
      .add_option("--max-tilt", max_tilt_deg,
                  "Largest angle between the two directions after the transform")
      ->check(between(0, 180, "degrees"))
      ->default_str(fmt::format("{}", degrees(GravityPrior{}.max_tilt)))
      ->type_name("DEG")
      ->needs(gravity_option)
      ->group(kGroup);
  command.add_option("--max-translation", max_translation, "Longest translation, metres")
      ->check(positive())
      ->type_name("M")
      ->group(kGroup);
  auto* pose_option =
      command.add_option("--initial-pose", initial_pose, "4 x 4 transform near which to look")
          ->type_name("T.txt")
          ->group(kGroup);
  command
      .add_option("--max-rotation-error", max_rotation_error_deg,
                  "Largest angle from the initial pose (default: any)")
      ->check(between(0, 180, "degrees"))
      ->type_name("DEG")
      ->needs(pose_option)
      ->group(kGroup);
  command
      .add_option("--max-translation-error", max_translation_error,
                  "Largest distance from the translation of the initial pose (default: any)")
      ->check(at_least(0))
      ->type_name("M")
      ->needs(pose_option)
      ->group(kGroup);
}

Priors PriorsArguments::resolved() const {
  Priors priors;
  if (!gravity.empty()) {
    GravityPrior& prior = priors.gravity.emplace();
    prior.source = Eigen::Vector3d(gravity.data());
    prior.target = Eigen::Vector3d(gravity.data() + gravity.size() - 3);
    if (max_tilt_deg) prior.max_tilt = radians(*max_tilt_deg);
  }
  priors.max_translation = max_translation.value_or(priors.max_translation);
  if (initial_pose.empty()) return priors;
  if (!max_rotation_error_deg && !max_translation_error) {
    throw std::invalid_argument(
        "--initial-pose needs --max-rotation-error, --max-translation-error or both");
  }
  InitialPose& prior = priors.initial_pose.emplace();
  prior.target_from_source = read_transform(initial_pose);
  prior.max_rotation = radians(max_rotation_error_deg.value_or(180));
  prior.max_translation = max_translation_error.value_or(prior.max_translation);
  return priors;
}

}  // namespace gmcr::cli
