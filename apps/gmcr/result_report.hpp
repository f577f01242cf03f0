#pragma once

#include <vector>

#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "report.hpp"

namespace gmcr::cli {

/// Appends status, pose, inliers, certificate, how sure they are, times and limits.
/// @param options  that the result was computed with.
void add_result(Report& report, const Result& result, const Options& options, double total_seconds);

/// Appends the instances as a table.
void add_instances(Report& report, const std::vector<Result>& instances);

}  // namespace gmcr::cli
