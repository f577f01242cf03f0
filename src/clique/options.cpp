#include <cmath>
#include <string>

#include "gmcr/clique.hpp"
#include "gmcr/invalid_option.hpp"

namespace gmcr {
namespace {

constexpr int kMaxThreads = 1024;

void check_time_limit(double time_limit) {
  if (std::isnan(time_limit) || time_limit < 0) {
    throw InvalidOption("time_limit", std::to_string(time_limit) + " is no number of seconds >= 0");
  }
}

void check_num_threads(int num_threads) {
  if (num_threads < 0 || num_threads > kMaxThreads) {
    throw InvalidOption("num_threads", std::to_string(num_threads) + " is not in [0, " +
                                           std::to_string(kMaxThreads) + "]");
  }
}

}  // namespace

void CliqueOptions::validate() const {
  check_time_limit(time_limit);
  check_num_threads(num_threads);
  if (must_exceed < 0) {
    throw InvalidOption("must_exceed", std::to_string(must_exceed) + " is negative");
  }
}

void WeightedCliqueOptions::validate() const {
  check_time_limit(time_limit);
  check_num_threads(num_threads);
  if (std::isnan(must_exceed) || must_exceed < 0) {
    throw InvalidOption("must_exceed", std::to_string(must_exceed) + " is no weight >= 0");
  }
}

}  // namespace gmcr
