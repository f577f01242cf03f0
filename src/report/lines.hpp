#pragma once

#include <string>
#include <utility>
#include <vector>

#include "gmcr/report.hpp"

namespace gmcr::report {

/// Lines of a report as they are written.
class Lines {
 public:
  void add(std::string label, std::string text, Tone tone = Tone::Plain) {
    lines_.push_back({std::move(label), std::move(text), tone});
  }

  /// Goes on about what the last line is about.
  void add_more(std::string text, Tone tone = Tone::Plain) { add("", std::move(text), tone); }

  std::vector<ReportLine> take() && { return std::move(lines_); }

 private:
  std::vector<ReportLine> lines_;
};

/// Status, pose, inliers, certificate, how sure they are, times and limits.
void add_result(Lines& lines, const Result& result, Detail detail, const ReportContext& context);

/// An instance, and what is said of it.
struct InstanceRow {
  const Result& result;
  Verdict verdict;
};

/// How many instances there are, and a row for each.
void add_instances(Lines& lines, const std::vector<InstanceRow>& instances);

/// The verdict in its colour, with its reason.
void add_verdict(Lines& lines, Verdict verdict, const std::string& reason);

/// "0.286 deg about (0.0000, 0.0000, 1.0000)".
std::string rotation_text(const Eigen::Matrix3d& rotation);

/// "(1.5, 0, -2)".
std::string vector_text(const Eigen::Vector3d& vector);

}  // namespace gmcr::report
