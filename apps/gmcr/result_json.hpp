#pragma once

#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "json.hpp"

namespace gmcr::cli {

/// The contract of `solve --json`.
/// @param options  that the result was computed with.
/// @param total_seconds  wall time of the work without reading files.
Json to_json(const Result& result, const Options& options, double total_seconds);

/// The same of the first instance, and each instance in `instances`. The times are those of all.
/// @param instances  at least one.
Json to_json(const std::vector<Result>& instances, const Options& options, double total_seconds);

}  // namespace gmcr::cli
