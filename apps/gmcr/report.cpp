#include "report.hpp"

#include <unistd.h>

#include <Eigen/Geometry>
#include <cstdlib>
#include <numbers>

namespace gmcr::cli {
namespace {

fmt::text_style style_of(Report::Tone tone) {
  switch (tone) {
    case Report::Tone::Good:
      return fmt::fg(fmt::terminal_color::green);
    case Report::Tone::Fair:
      return fmt::fg(fmt::terminal_color::yellow);
    default:
      return fmt::fg(fmt::terminal_color::red);
  }
}

void add_pose(Report& report, const Similarity& pose) {
  const Eigen::AngleAxisd turn(pose.rotation);
  const Eigen::Vector3d& axis = turn.axis();
  const Eigen::Vector3d& shift = pose.translation;
  report.line("scale", fmt::format("{:.6g}", pose.scale));
  report.line("rotation",
              fmt::format("{:.3f} deg about ({:.4f}, {:.4f}, {:.4f})",
                          turn.angle() * 180 / std::numbers::pi, axis.x(), axis.y(), axis.z()));
  for (Index i = 0; i < 3; ++i) {
    report.line("", fmt::format("{:9.6f}  {:9.6f}  {:9.6f}", pose.rotation(i, 0),
                                pose.rotation(i, 1), pose.rotation(i, 2)));
  }
  report.line("translation", fmt::format("({:.6g}, {:.6g}, {:.6g})  length {:.6g}", shift.x(),
                                         shift.y(), shift.z(), shift.norm()));
}

void add_certificate(Report& report, const Certificate& certificate, const ScaleRange& scales) {
  const std::string where =
      scales.min < scales.max
          ? fmt::format(", at scales from {:.4g} to {:.4g}", scales.min, scales.max)
          : "";
  if (certificate.certified) {
    report.line("certificate", "no pose can have more inliers: proven optimal" + where,
                Report::Tone::Good);
    return;
  }
  report.line("certificate",
              fmt::format("at most {} could agree: within {} of the best possible{}",
                          certificate.upper, certificate.upper - certificate.lower, where),
              Report::Tone::Fair);
}

}  // namespace

Report::Report() : is_terminal_(isatty(STDOUT_FILENO) && !std::getenv("NO_COLOR")) {}

void Report::line(std::string_view label, std::string_view text) {
  text_ += fmt::format("{:<13} {}\n", label, text);
}

void Report::line(std::string_view label, std::string_view text, Tone tone) {
  line(label, is_terminal_ ? fmt::format(style_of(tone), "{}", text) : std::string(text));
}

void Report::print() const { fmt::print("{}", text_); }

void add_result(Report& report, const Result& result, double total_seconds) {
  const Diagnostics& diagnostics = result.diagnostics;
  const bool is_ok = result.status == Status::Ok;
  report.line("status",
              is_ok ? std::string("pose found")
                    : fmt::format("{}: {}", to_string(result.status), result.status_reason),
              is_ok ? Report::Tone::Good : Report::Tone::Bad);
  if (is_ok || result.status == Status::Degenerate) add_pose(report, result.target_from_source);
  report.line("inliers",
              share(static_cast<Index>(result.inliers.size()), diagnostics.num_correspondences));
  if (diagnostics.num_used != diagnostics.num_correspondences) {
    report.line("used", share(diagnostics.num_used, diagnostics.num_correspondences));
  }
  add_certificate(report, result.certificate, diagnostics.scale_range);
  report.line("time",
              fmt::format("{} with {} threads", duration(total_seconds), diagnostics.num_threads));
  for (const StageTime& stage : diagnostics.stages) {
    report.line("", fmt::format("{:<22} {:>9}", stage.name, duration(stage.seconds)));
  }
  for (const std::string& limit : diagnostics.limits_hit) {
    report.line("limit", limit, Report::Tone::Fair);
  }
}

std::string share(Index part, Index whole) {
  if (whole == 0) return fmt::format("{} of 0", part);
  return fmt::format("{} of {} ({:.1f} %)", part, whole,
                     100 * static_cast<double>(part) / static_cast<double>(whole));
}

std::string duration(double seconds) {
  return seconds < 1 ? fmt::format("{:.2f} ms", 1000 * seconds) : fmt::format("{:.2f} s", seconds);
}

}  // namespace gmcr::cli
