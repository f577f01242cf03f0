#pragma once

#include <string>
#include <vector>

#include "gmcr/options.hpp"

namespace gmcr::bench {

/// A solver setting under test.
struct NamedMethod {
  std::string name;
  Method method;
  Evidence evidence;
};

/// "gmcr" (distinct evidence), "gmcr-count" and "paper".
const std::vector<NamedMethod>& all_methods();

/// Those of `all_methods` that have one of the names.
/// @throws std::invalid_argument naming an unknown one.
std::vector<NamedMethod> methods_named(const std::vector<std::string>& names);

}  // namespace gmcr::bench
