#include "gmcr/options.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

namespace gmcr {
namespace {

constexpr int kMaxThreads = 1024;

void require(bool holds, const std::string& field, double value, const char* rule) {
  if (holds) return;
  std::ostringstream message;
  message << field << ": " << value << ' ' << rule;
  throw std::invalid_argument(message.str());
}

void require_positive(const std::string& field, double value) {
  require(value > 0 && std::isfinite(value), field, value, "is not a positive finite number");
}

}  // namespace

void Options::validate() const {
  if (noise_mode == NoiseMode::Estimated) {
    require(noise_bound == 0, "noise_bound", noise_bound, "is given, but is to be estimated");
    require(noise_bounds.empty(), "noise_bounds", static_cast<double>(noise_bounds.size()),
            "values are given, but the noise is to be estimated");
  } else if (noise_bounds.empty()) {
    require_positive("noise_bound", noise_bound);
  } else {
    require(noise_bound == 0, "noise_bound", noise_bound, "must be 0 where noise_bounds is given");
    for (std::size_t i = 0; i < noise_bounds.size(); ++i) {
      require_positive("noise_bounds[" + std::to_string(i) + "]", noise_bounds[i]);
    }
  }
  require_positive("threshold", threshold);
  require_positive("scale", scale);
  if (scale_mode == ScaleMode::Estimated) {
    require(scale == 1, "scale", scale, "is given, but the scale is to be estimated");
  }
  if (scale_range) {
    if (scale_mode == ScaleMode::Known) {
      throw std::invalid_argument("scale_range: is given, but the scale is known");
    }
    require_positive("scale_range.min", scale_range->min);
    require_positive("scale_range.max", scale_range->max);
    require(scale_range->min <= scale_range->max, "scale_range.min", scale_range->min,
            "exceeds scale_range.max");
  }
  priors.validate();
  require(num_hypotheses >= 1, "num_hypotheses", num_hypotheses, "is less than 1");
  if (method == Method::Paper) {
    require(num_hypotheses == 1, "num_hypotheses", num_hypotheses,
            "are asked for, but Method::Paper finds one");
    require(!certify, "certify", 1, "is asked for, but Method::Paper has no joint search");
  }
  require(num_threads >= 0, "num_threads", num_threads, "is negative");
  require(num_threads <= kMaxThreads, "num_threads", num_threads, "exceeds 1024");
  require(budget.time > 0, "budget.time", budget.time, "is not a positive number of seconds");
  require(budget.memory > 0, "budget.memory", 0, "is no memory at all");
}

}  // namespace gmcr
