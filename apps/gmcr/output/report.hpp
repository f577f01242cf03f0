#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "arguments/output_arguments.hpp"
#include "gmcr/report.hpp"

namespace gmcr::cli {

/// Lines "label  text" of a report for people; colours only on a terminal.
class Report {
 public:
  using Tone = gmcr::Tone;

  explicit Report(const OutputArguments& output) : output_(output) {}

  void line(std::string_view label, std::string_view text, Tone tone = Tone::Plain);
  void add(const std::vector<ReportLine>& lines);

  /// Prints it on stdout, unless it is to be quiet.
  void print() const;

 private:
  OutputArguments output_;
  std::vector<ReportLine> lines_;
};

/// Prints an answer: its JSON where that was asked for, otherwise its lines and the files that were
/// written.
void print_answer(const OutputArguments& output, const std::function<std::string()>& json,
                  const std::function<std::vector<ReportLine>()>& lines,
                  const std::vector<std::string>& written);

}  // namespace gmcr::cli
