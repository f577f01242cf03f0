#include "result_report.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gmcr/metrics.hpp"

namespace gmcr::cli {
namespace {

using Tone = Report::Tone;

// A runner-up with a larger share of the evidence makes the answer ambiguous.
constexpr double kAmbiguous = 0.8;
// From here on chance is out of the question.
constexpr double kSureLog10 = -3;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

std::string rotation_text(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  const Eigen::Vector3d& axis = turn.axis();
  return fmt::format("{:.3f} deg about ({:.4f}, {:.4f}, {:.4f})", degrees(turn.angle()), axis.x(),
                     axis.y(), axis.z());
}

std::string vector_text(const Eigen::Vector3d& vector) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", vector.x(), vector.y(), vector.z());
}

void add_pose(Report& report, const Similarity& pose) {
  report.line("scale", fmt::format("{:.6g}", pose.scale));
  report.line("rotation", rotation_text(pose.rotation));
  for (Index i = 0; i < 3; ++i) {
    report.line("", fmt::format("{:9.6f}  {:9.6f}  {:9.6f}", pose.rotation(i, 0),
                                pose.rotation(i, 1), pose.rotation(i, 2)));
  }
  report.line("translation", fmt::format("{}  length {:.6g}", vector_text(pose.translation),
                                         pose.translation.norm()));
}

/// Standard deviation along the worst axis of a block of the covariance.
double worst_deviation(const Eigen::MatrixXd& block) {
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> axes(block, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()));
}

void add_uncertainty(Report& report, const Covariance& covariance) {
  const Eigen::MatrixXd& matrix = covariance.matrix;
  std::string text = fmt::format("rotation {:.2g} deg, translation {:.2g} m",
                                 degrees(worst_deviation(matrix.topLeftCorner(3, 3))),
                                 worst_deviation(matrix.block(3, 3, 3, 3)));
  if (matrix.rows() > 6) {
    text += fmt::format(", scale {:.2g} %", 100 * worst_deviation(matrix.bottomRightCorner(1, 1)));
  }
  report.line("uncertainty", text + " (one standard deviation, worst axis)");
}

void add_noise(Report& report, const NoiseEstimate& estimate) {
  const double log10 = estimate.log10_false_alarms;
  const auto line = [&](const std::string& chance, Tone tone) {
    report.line("noise bound",
                fmt::format("{:.4g} m chosen from the matches: {}", estimate.noise_bound, chance),
                tone);
  };
  if (!(log10 < 0)) {
    line("chance explains this", Tone::Bad);
  } else if (log10 > kSureLog10) {
    line(fmt::format("chance would give this once in {:.0f}", std::pow(10, -log10)), Tone::Fair);
  } else if (std::isfinite(log10)) {
    line(fmt::format("chance would give this once in 10^{:.0f}", std::floor(-log10)), Tone::Good);
  } else {
    line("chance cannot give this", Tone::Good);
  }
  report.line("", fmt::format("the same pose with bounds from {:.4g} to {:.4g} m",
                              estimate.stable_min, estimate.stable_max));
}

void add_certificate(Report& report, const Result& result, const Options& options) {
  const Certificate& certificate = result.certificate;
  const ScaleRange& scales = result.diagnostics.scale_range;
  const std::string pose = options.admit_all() ? "no pose" : "no pose that the priors admit";
  const std::string where =
      scales.min < scales.max
          ? fmt::format(", at scales from {:.4g} to {:.4g}", scales.min, scales.max)
          : "";
  if (certificate.certified) {
    report.line("certificate", pose + " can have more inliers: proven optimal" + where, Tone::Good);
    return;
  }
  report.line("certificate",
              fmt::format("{} can have more than {}: within {} of the best possible{}", pose,
                          certificate.upper, certificate.upper - certificate.lower, where),
              Tone::Fair);
}

void add_evidence(Report& report, const EvidenceCertificate& evidence) {
  if (evidence.certified) {
    report.line("evidence", fmt::format("{:.1f}: no pose can have more", evidence.lower),
                Tone::Good);
  } else {
    report.line("evidence",
                fmt::format("{:.1f}, at most {:.1f} possible", evidence.lower, evidence.upper),
                Tone::Fair);
  }
}

void add_alternatives(Report& report, const Result& result) {
  if (result.alternatives.empty()) {
    report.line("alternatives", "none found", Tone::Good);
    return;
  }
  const Similarity& best = result.target_from_source;
  std::string label = "alternatives";
  for (const Alternative& alternative : result.alternatives) {
    const Similarity& pose = alternative.target_from_source;
    std::string text =
        fmt::format("{:.0f} % of the evidence, {} inliers: {:.3g} deg and {:.3g} m away",
                    100 * alternative.evidence / result.evidence, alternative.inliers.size(),
                    rotation_error_deg(pose.rotation, best.rotation),
                    translation_error(pose.translation, best.translation));
    if (pose.scale != best.scale) text += fmt::format(", scale {:.4g}", pose.scale);
    report.line(label, text);
    label.clear();
  }
  if (result.runner_up_ratio() > kAmbiguous) {
    report.line("ambiguous",
                fmt::format("another pose has {:.0f} % of the evidence of this one",
                            100 * result.runner_up_ratio()),
                Tone::Bad);
  }
}

void add_work(Report& report, const Diagnostics& diagnostics, double total_seconds) {
  report.line("time",
              fmt::format("{} with {} threads", duration(total_seconds), diagnostics.num_threads));
  for (const StageTime& stage : diagnostics.stages) {
    report.line("", fmt::format("{:<22} {:>9}", stage.name, duration(stage.seconds)));
  }
  for (const std::string& limit : diagnostics.limits_hit) report.line("limit", limit, Tone::Fair);
}

}  // namespace

void add_result(Report& report, const Result& result, const Options& options,
                double total_seconds) {
  const Diagnostics& diagnostics = result.diagnostics;
  const bool is_ok = result.status == Status::Ok;
  report.line("status",
              is_ok ? std::string("pose found")
                    : fmt::format("{}: {}", to_string(result.status), result.status_reason),
              is_ok ? Tone::Good : Tone::Bad);
  if (is_ok || result.status == Status::Degenerate) add_pose(report, result.target_from_source);
  if (result.covariance) add_uncertainty(report, *result.covariance);
  if (result.noise_estimate) add_noise(report, *result.noise_estimate);
  report.line("inliers",
              share(static_cast<Index>(result.inliers.size()), diagnostics.num_correspondences));
  if (diagnostics.num_used != diagnostics.num_correspondences) {
    report.line("used", share(diagnostics.num_used, diagnostics.num_correspondences) +
                            ", those that the priors admit");
  }
  add_certificate(report, result, options);
  if (options.evidence == Evidence::Distinct && !result.inliers.empty()) {
    add_evidence(report, result.certificate.evidence);
  }
  if (options.num_hypotheses > 1) add_alternatives(report, result);
  add_work(report, diagnostics, total_seconds);
}

void add_instances(Report& report, const std::vector<Result>& instances) {
  const auto is_found = [](const Result& result) { return result.status == Status::Ok; };
  const auto count = std::count_if(instances.begin(), instances.end(), is_found);
  report.line("instances", fmt::format("{} found", count));
  constexpr const char* kRow = "{:>2} {:>8} {:>9}  {:<45}  {}";
  if (count > 0) {
    report.line("", fmt::format(kRow, "", "inliers", "evidence", "rotation", "translation"));
  }
  for (std::size_t i = 0; i < instances.size(); ++i) {
    const Result& instance = instances[i];
    if (!is_found(instance)) continue;
    const Similarity& pose = instance.target_from_source;
    report.line("", fmt::format(kRow, i + 1, instance.inliers.size(),
                                fmt::format("{:.1f}", instance.evidence),
                                rotation_text(pose.rotation), vector_text(pose.translation)));
  }
}

}  // namespace gmcr::cli
