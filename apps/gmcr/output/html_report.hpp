#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "gmcr/io.hpp"

namespace gmcr::cli {

/// What a report shows beside the result.
struct ReportInput {
  std::string title;
  Matches matches;               ///< that the inliers of the result index
  std::optional<Points> source;  ///< the clouds; without them the matched points are drawn
  std::optional<Points> target;
};

/// Reports are made by the Python package: $GMCR_PYTHON, or else python3, runs it.
/// @throws std::invalid_argument where it is not installed with what it needs for that.
void require_html_reports();

/// Writes a self-contained HTML file.
/// @param result  the JSON object of the result, with its options.
/// @throws IoError where the file cannot be written.
void write_html_report(const std::filesystem::path& path, const std::string& result,
                       const ReportInput& input);

}  // namespace gmcr::cli
