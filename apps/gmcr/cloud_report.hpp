#pragma once

#include <filesystem>

#include "gmcr/frontend.hpp"
#include "refine.hpp"
#include "report.hpp"
#include "result_json.hpp"

namespace gmcr::cli {

/// Reads a cloud; a warning on stderr says how many points were not finite.
Points read_points(const std::filesystem::path& path);

/// The contract of `register --json`.
/// @param options  that the result was computed with.
Json to_json(const CloudResult& result, const Options& options, const Refinement& refinement,
             double total_seconds);

/// The same for people.
void add_cloud_result(Report& report, const CloudResult& result, const Options& options,
                      const Refinement& refinement, double total_seconds);

}  // namespace gmcr::cli
