#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "gmcr/metrics.hpp"
#include "report/lines.hpp"

namespace gmcr {
namespace report {
namespace {

// A runner-up with a larger share of the evidence makes the answer ambiguous.
constexpr double kAmbiguous = 0.8;
// From here on chance is out of the question.
constexpr double kSureLog10 = -3;

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

/// "44 of 5344 (0.8 %)".
std::string share(Index part, Index whole) {
  if (whole == 0) return fmt::format("{} of 0", part);
  return fmt::format("{} of {} ({:.1f} %)", part, whole,
                     100 * static_cast<double>(part) / static_cast<double>(whole));
}

void add_pose(Lines& lines, const Similarity& pose, Detail detail) {
  lines.add("scale", fmt::format("{:.6g}", pose.scale));
  lines.add("rotation", rotation_text(pose.rotation));
  for (Index i = 0; detail == Detail::Full && i < 3; ++i) {
    lines.add_more(fmt::format("{:9.6f}  {:9.6f}  {:9.6f}", pose.rotation(i, 0),
                               pose.rotation(i, 1), pose.rotation(i, 2)));
  }
  lines.add("translation", fmt::format("{} m, length {:.6g} m", vector_text(pose.translation),
                                       pose.translation.norm()));
}

/// Standard deviation along the worst axis of a block of the covariance.
double worst_deviation(const Eigen::Matrix3d& block) {
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(block, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues().maxCoeff()));
}

void add_uncertainty(Lines& lines, const Covariance& covariance) {
  const Eigen::MatrixXd& matrix = covariance.matrix;
  std::string text = fmt::format("rotation {:.2g} deg, translation {:.2g} m",
                                 degrees(worst_deviation(matrix.topLeftCorner<3, 3>())),
                                 worst_deviation(matrix.block<3, 3>(3, 3)));
  if (matrix.rows() > 6) {
    text += fmt::format(", scale {:.2g} %", 100 * std::sqrt(std::max(0.0, matrix(6, 6))));
  }
  lines.add("uncertainty", text + " (one standard deviation, worst axis)");
}

void add_noise(Lines& lines, const NoiseEstimate& estimate) {
  const double log10 = estimate.log10_false_alarms;
  const auto add = [&](const std::string& chance, Tone tone) {
    lines.add("noise bound",
              fmt::format("{:.4g} m chosen from the matches: {}", estimate.noise_bound, chance),
              tone);
  };
  if (!(log10 < 0)) {
    add("chance explains this", Tone::Bad);
  } else if (log10 > kSureLog10) {
    add(fmt::format("chance would give this once in {:.0f}", std::pow(10, -log10)), Tone::Fair);
  } else if (std::isfinite(log10)) {
    add(fmt::format("chance would give this once in 10^{:.0f}", std::floor(-log10)), Tone::Good);
  } else {
    add("chance cannot give this", Tone::Good);
  }
  lines.add_more(fmt::format("the same pose with bounds from {:.4g} to {:.4g} m",
                             estimate.stable_min, estimate.stable_max));
}

/// The poses that the certificate speaks of.
const char* no_pose(const Options* options) {
  if (!options) return "no admitted pose";
  return options->admit_all() ? "no pose" : "no pose that the priors admit";
}

void add_certificate(Lines& lines, const Result& result, const Options* options) {
  const Certificate& certificate = result.certificate;
  const ScaleRange& scales = result.diagnostics.scale_range;
  const std::string where =
      scales.min < scales.max
          ? fmt::format(", at scales from {:.4g} to {:.4g}", scales.min, scales.max)
          : "";
  if (certificate.certified) {
    lines.add("certificate",
              fmt::format("{} can have more than {} inliers: proven optimal{}", no_pose(options),
                          certificate.upper, where),
              Tone::Good);
  } else {
    lines.add(
        "certificate",
        fmt::format("{} can have more than {}: within {} of the best possible{}", no_pose(options),
                    certificate.upper, certificate.upper - certificate.lower, where),
        Tone::Fair);
  }
  if (certificate.lower != static_cast<Index>(result.inliers.size())) {
    lines.add_more(fmt::format("another pose holds {}, but is less likely", certificate.lower));
  }
}

/// Whether the evidence is another number than that of the inliers, as far as is known.
bool has_evidence_of_its_own(const Certificate& certificate, const Options* options) {
  if (options) return options->evidence == Evidence::Distinct;
  return certificate.evidence.lower != static_cast<double>(certificate.lower) ||
         certificate.evidence.upper != static_cast<double>(certificate.upper);
}

void add_evidence(Lines& lines, const EvidenceCertificate& evidence) {
  if (evidence.certified) {
    lines.add("evidence", fmt::format("{:.1f}: no pose can have more", evidence.lower), Tone::Good);
  } else {
    lines.add("evidence",
              fmt::format("{:.1f}, at most {:.1f} possible", evidence.lower, evidence.upper),
              Tone::Fair);
  }
}

void add_alternatives(Lines& lines, const Result& result) {
  if (result.alternatives.empty()) {
    lines.add("alternatives", "none found", Tone::Good);
    return;
  }
  const Similarity& best = result.target_from_source;
  std::string label = "alternatives";
  for (const Alternative& alternative : result.alternatives) {
    const Similarity& pose = alternative.target_from_source;
    // where surfaces chose the pose, matches may speak more for another one
    const std::string evidence =
        alternative.evidence <= result.evidence
            ? fmt::format("{:.0f} % of the evidence", 100 * alternative.evidence / result.evidence)
            : fmt::format("evidence of {:.1f} against {:.1f}", alternative.evidence,
                          result.evidence);
    std::string text =
        fmt::format("{}, {} inliers: {:.3g} deg and {:.3g} m away", evidence,
                    alternative.inliers.size(), rotation_error_deg(pose.rotation, best.rotation),
                    translation_error(pose.translation, best.translation));
    if (pose.scale != best.scale) text += fmt::format(", scale {:.4g}", pose.scale);
    lines.add(label, text);
    label.clear();
  }
}

void add_ambiguity(Lines& lines, const Result& result) {
  if (result.runner_up_ratio() <= kAmbiguous) return;
  lines.add("ambiguous",
            fmt::format("another pose has {:.0f} % of the evidence of this one",
                        100 * result.runner_up_ratio()),
            Tone::Bad);
}

/// Whether a limit left only a bound looser than it might be, which the certificate says in
/// numbers.
bool is_of_proof(Limit limit) {
  return limit == Limit::CliqueSearch || limit == Limit::EvidenceSearch ||
         limit == Limit::ScaleSearch || limit == Limit::ConsensusSearch;
}

/// Limits that the pose may feel, and one word on the proof where the caller asked for it.
void add_limits(Lines& lines, const Diagnostics& diagnostics, const Options* options) {
  bool is_unproven = false;
  for (const LimitHit& hit : diagnostics.limits_hit) {
    if (is_of_proof(hit.limit)) {
      is_unproven = true;
    } else {
      lines.add("limit", hit.sentence, Tone::Fair);
    }
  }
  if (is_unproven && options && options->certify) {
    lines.add("proof", "not finished: a longer time limit may bring the bounds together",
              Tone::Fair);
  }
}

void add_work(Lines& lines, const Diagnostics& diagnostics, Detail detail,
              const ReportContext& context) {
  const double seconds = context.total_seconds.value_or(diagnostics.total_seconds);
  lines.add("time", fmt::format("{} with {} threads", duration(seconds), diagnostics.num_threads));
  if (detail == Detail::Full) {
    for (const StageTime& stage : diagnostics.stages) {
      lines.add_more(
          fmt::format("{:<22} {:>9}", stage_in_words(stage.name), duration(stage.seconds)));
    }
  }
  add_limits(lines, diagnostics, context.options);
}

Tone tone_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::Trusted:
      return Tone::Good;
    case Verdict::Doubtful:
      return Tone::Fair;
    default:
      return Tone::Bad;
  }
}

}  // namespace

void add_verdict(Lines& lines, Verdict verdict, const std::string& reason) {
  lines.add("verdict", fmt::format("{}: {}", to_string(verdict), reason), tone_of(verdict));
}

std::string rotation_text(const Eigen::Matrix3d& rotation) {
  const Eigen::AngleAxisd turn(rotation);
  const Eigen::Vector3d& axis = turn.axis();
  return fmt::format("{:.3f} deg about ({:.4f}, {:.4f}, {:.4f})", degrees(turn.angle()), axis.x(),
                     axis.y(), axis.z());
}

std::string vector_text(const Eigen::Vector3d& vector) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", vector.x(), vector.y(), vector.z());
}

void add_result(Lines& lines, const Result& result, Detail detail, const ReportContext& context) {
  const Diagnostics& diagnostics = result.diagnostics;
  const Options* options = context.options;
  const bool is_full = detail == Detail::Full;
  const bool is_ok = result.status == Status::Ok;
  lines.add("status",
            is_ok ? std::string("pose found")
                  : fmt::format("{}: {}", to_string(result.status), result.status_reason),
            is_ok ? Tone::Plain : Tone::Bad);
  if (is_ok || result.status == Status::Degenerate) {
    add_pose(lines, result.target_from_source, detail);
  }
  if (is_full && result.covariance) add_uncertainty(lines, *result.covariance);
  if (result.noise_estimate) add_noise(lines, *result.noise_estimate);
  lines.add("inliers",
            share(static_cast<Index>(result.inliers.size()), diagnostics.num_correspondences));
  if (diagnostics.num_used != diagnostics.num_correspondences) {
    lines.add("used", share(diagnostics.num_used, diagnostics.num_correspondences) +
                          ", those that the priors admit");
  }
  add_certificate(lines, result, options);
  if (is_full && !result.inliers.empty() && has_evidence_of_its_own(result.certificate, options)) {
    add_evidence(lines, result.certificate.evidence);
  }
  const bool has_alternatives =
      !result.alternatives.empty() || (options && options->num_hypotheses > 1);
  if (is_full && has_alternatives) add_alternatives(lines, result);
  add_ambiguity(lines, result);
  add_work(lines, diagnostics, detail, context);
}

}  // namespace report

std::vector<ReportLine> report_lines(const Result& result, Detail detail,
                                     const ReportContext& context) {
  report::Lines lines;
  report::add_result(lines, result, detail, context);
  report::add_verdict(lines, result.verdict, result.verdict_reason);
  return std::move(lines).take();
}

}  // namespace gmcr
