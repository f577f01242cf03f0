#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gmcr/options.hpp"
#include "support/problem.hpp"

namespace gmcr::bench {

/// A solver setting under test.
struct NamedMethod {
  std::string name;
  /// Sets what makes the method in options that carry the problem's noise bound.
  /// @throws std::invalid_argument where the problem lacks what the method needs.
  std::function<void(Options& options, const Problem& problem)> adapt;
};

/// gmcr             the default: distinct evidence
/// gmcr-count       plain number of inliers
/// paper            the stages of the paper
/// gmcr-certify     the default, the time that is left spent on the certificate
/// gmcr-gravity     the default, told the direction of gravity
/// gmcr-auto-noise  the default, not told the noise bound
const std::vector<NamedMethod>& all_methods();

/// Their names, separated by commas.
std::string method_names();

/// Those of `all_methods` that have one of the names.
/// @throws std::invalid_argument naming an unknown one.
std::vector<NamedMethod> methods_named(const std::vector<std::string>& names);

}  // namespace gmcr::bench
