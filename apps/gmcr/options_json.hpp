#pragma once

#include "gmcr/options.hpp"
#include "json.hpp"

namespace gmcr::cli {

/// Every choice of the solver by the name of its field; null: not given.
Json to_json(const Options& options);

}  // namespace gmcr::cli
