#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// What is written beside what a result holds.
struct ReportContext {
  /// Those that the result was computed with; null: not known, and nothing is said that they
  /// decide, such as a noise bound that was given.
  const Options* options = nullptr;
  /// Wall time of the work without reading files, seconds; without it that of the diagnostics.
  std::optional<double> total_seconds;
};

/// A result as one JSON object: the schema of `gmcr solve --json`, docs/json.md.
///
/// Numbers have full precision; one that is not finite is null.
/// @param indent  spaces a level; -1: all on one line.
/// Cost O(number of inliers).
std::string to_json(const Result& result, const ReportContext& context = {}, int indent = -1);

/// The same of the first instance, and each instance in `instances`. The times of the stages are
/// those of all.
/// @param instances  at least one.
/// @throws std::invalid_argument where there is none.
std::string to_json(const std::vector<Result>& instances, const ReportContext& context = {},
                    int indent = -1);

/// The same of two clouds: the schema of `gmcr register --json`.
std::string to_json(const CloudResult& result, const ReportContext& context = {}, int indent = -1);

/// The same of the first instance in a cloud, and each in `instances`, with its own verdict.
/// @param instances  at least one.
/// @throws std::invalid_argument where there is none.
std::string to_json(const std::vector<CloudResult>& instances, const ReportContext& context = {},
                    int indent = -1);

/// How good what a line says is.
enum class Tone { Plain, Good, Fair, Bad };

/// "", "good", "fair" or "bad".
const char* to_string(Tone tone);

/// A line of a report for people.
struct ReportLine {
  std::string label;        ///< empty: goes on about what the line above is about
  std::string text;         ///< one line, units included
  Tone tone = Tone::Plain;  ///< what to colour it by
};

/// How much a report says.
enum class Detail {
  Brief,  ///< status, pose, inliers, certificate, what is doubtful, time
  Full,   ///< also the matrix, the uncertainty, the evidence, the alternatives, each stage
};

/// A result in words.
/// Cost O(number of stages and alternatives).
std::vector<ReportLine> report_lines(const Result& result, Detail detail,
                                     const ReportContext& context = {});

/// The same of the first instance, and a table of all.
/// @param instances  at least one.
/// @throws std::invalid_argument where there is none.
std::vector<ReportLine> report_lines(const std::vector<Result>& instances, Detail detail,
                                     const ReportContext& context = {});

/// The same of two clouds, with how their surfaces meet and the verdict.
std::vector<ReportLine> report_lines(const CloudResult& result, Detail detail,
                                     const ReportContext& context = {});

/// The same of the first instance in a cloud, and a table of all.
/// @param instances  at least one.
/// @throws std::invalid_argument where there is none.
std::vector<ReportLine> report_lines(const std::vector<CloudResult>& instances, Detail detail,
                                     const ReportContext& context = {});

/// Lines of text: the labels in a column, then the texts.
/// @param coloured  whether tones become colours of a terminal.
std::string to_text(const std::vector<ReportLine>& lines, bool coloured = false);

/// An HTML table without a style sheet, for notebooks.
std::string to_html(const std::vector<ReportLine>& lines);

/// "1.23 ms", "45.6 s".
std::string duration(double seconds);

/// A stage of the diagnostics in words, "votes for scales" for "scale_votes"; one that needs none
/// is called by its name.
std::string stage_in_words(std::string_view stage);

}  // namespace gmcr
