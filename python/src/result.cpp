#include "gmcr/result.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <functional>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <string>

#include "bindings.hpp"
#include "conversion/pose_properties.hpp"
#include "conversion/record.hpp"
#include "conversion/report_methods.hpp"
#include "gmcr/registration.hpp"

namespace gmcr::python {

/// Their sentences.
template <>
struct Convert<std::vector<LimitHit>> {
  static std::string type() { return "list[str]"; }
  static std::string accepted() { return type(); }
  static nb::object to_python(const std::vector<LimitHit>& hits, nb::handle) {
    nb::list sentences;
    for (const LimitHit& hit : hits) sentences.append(hit.sentence);
    return sentences;
  }
  static std::vector<LimitHit> from_python(nb::handle value, const char* name) {
    std::vector<LimitHit> hits;
    for (std::string& sentence : Convert<std::vector<std::string>>::from_python(value, name)) {
      hits.push_back({{}, std::move(sentence)});
    }
    return hits;
  }
};

/// The codes of limits whose sentences are there.
struct LimitCodes {
  std::vector<LimitHit>& hits;

  void operator=(const std::vector<Limit>& codes) {
    const std::size_t count = std::min(codes.size(), hits.size());
    for (std::size_t i = 0; i < count; ++i) hits[i].limit = codes[i];
  }
};

template <>
struct Convert<LimitCodes> {
  static std::string type() { return "list[str]"; }
  static std::string accepted() { return type(); }
  static nb::object to_python(const LimitCodes& codes, nb::handle) {
    nb::list words;
    for (const LimitHit& hit : codes.hits) words.append(to_string(hit.limit));
    return words;
  }
  static std::vector<Limit> from_python(nb::handle value, const char* name) {
    std::vector<Limit> codes;
    for (const std::string& word : Convert<std::vector<std::string>>::from_python(value, name)) {
      const auto known = std::find_if(std::begin(kLimits), std::end(kLimits),
                                      [&](Limit limit) { return word == to_string(limit); });
      if (known == std::end(kLimits)) {
        throw std::invalid_argument(std::string(name) + ": '" + word + "' is no limit");
      }
      codes.push_back(*known);
    }
    return codes;
  }
};

namespace {

constexpr const char* kResultDoc =
    R"(What a registration found: status, transform, inliers and how far the best can be.)";

std::string describe(const Result& result) {
  const nb::str format(
      "Result({status!r}, {inliers} of {total} inliers, at most {upper}{certified}, "
      "evidence={evidence:.4g}, scale={scale:.6g}, rotation={angle:.2f} deg, "
      "translation=[{x:.4g}, {y:.4g}, {z:.4g}], {ms:.3g} ms)");
  const Similarity& pose = result.target_from_source;
  const Certificate& certificate = result.certificate;
  const double degrees = Eigen::AngleAxisd(pose.rotation).angle() * 180 / EIGEN_PI;
  return nb::cast<std::string>(format.attr("format")(
      nb::arg("status") = name_of(result.status), nb::arg("inliers") = result.inliers.size(),
      nb::arg("total") = result.diagnostics.num_correspondences,
      nb::arg("upper") = certificate.upper,
      nb::arg("certified") = certificate.certified ? " (certified)" : "",
      nb::arg("evidence") = result.evidence, nb::arg("scale") = pose.scale,
      nb::arg("angle") = degrees, nb::arg("x") = pose.translation.x(),
      nb::arg("y") = pose.translation.y(), nb::arg("z") = pose.translation.z(),
      nb::arg("ms") = 1000 * result.diagnostics.total_seconds));
}

void bind_certificate(nb::module_& module) {
  Record<EvidenceCertificate>(
      module, "EvidenceCertificate",
      "How far the evidence of the consensus can be from the best possible.")
      .field("lower", &EvidenceCertificate::lower, "Evidence of the certificate's inliers.")
      .field("upper", &EvidenceCertificate::upper, "Proven: no transform has more evidence.")
      .field("certified", &EvidenceCertificate::certified, "No transform has more, to rounding.")
      .read_only();
  Record<Certificate>(module, "Certificate",
                      "How far the consensus can be from the best possible, in inliers.")
      .field("lower", &Certificate::lower, "Number of its inliers.")
      .field("upper", &Certificate::upper, "Proven: no transform has more inliers.")
      .field("certified", &Certificate::certified, "lower == upper: a maximum consensus.")
      .field("evidence", &Certificate::evidence, "The same for the evidence.")
      .field("target_from_source", &Certificate::target_from_source,
             "The transform that achieves them; the returned one, near it, may hold fewer.")
      .field("inliers", &Certificate::inliers,
             "(m,) int64, its consensus set, ascending, read only.")
      .read_only();
}

void bind_diagnostics(nb::module_& module) {
  Record<Diagnostics>(module, "Diagnostics", "What the solver did.")
      .field("stages", &Diagnostics::stages, "Stage -> seconds, in order of first use.")
      .field("total_seconds", &Diagnostics::total_seconds, "Wall time, seconds.")
      .field("num_correspondences", &Diagnostics::num_correspondences, "In the input.")
      .field("num_used", &Diagnostics::num_used, "Correspondences that the priors admit.")
      .field("scale_range", &Diagnostics::scale_range,
             "(min, max) of the scales that were searched; equal: it was known.")
      .field("num_candidates", &Diagnostics::num_candidates, "Poses judged on all correspondences.")
      .field("num_scale_ranges", &Diagnostics::num_scale_ranges,
             "Scale ranges whose graph was searched.")
      .field("num_clique_nodes", &Diagnostics::num_clique_nodes,
             "Search nodes of all clique searches.")
      .field("num_threads", &Diagnostics::num_threads, "Threads that were used.")
      .field("limits_hit", &Diagnostics::limits_hit,
             "One sentence for each limit that made the work less than complete.")
      .field(
          "limit_codes", [](Diagnostics& self) { return LimitCodes{self.limits_hit}; },
          "The word for each of them: 'time', 'stopped', 'memory', 'clique_search',\n"
          "'evidence_search', 'scale_search' or 'consensus_search'.")
      .read_only();
}

void bind_parts(nb::module_& module) {
  Record<Covariance>(module, "Covariance", "How well the inliers determine the transform.")
      .field("matrix", &Covariance::matrix,
             "(6, 6), or (7, 7) where the scale was estimated: rotation (radians, target frame),\n"
             "translation (metres), relative scale.")
      .field("eigenvalues", &Covariance::eigenvalues,
             "(6,) or (7,), square metres, ascending: variances of the motion of the inliers.")
      .read_only();
  Record<NoiseEstimate>(module, "NoiseEstimate", "The noise bound that was chosen from the data.")
      .field("noise_bound", &NoiseEstimate::noise_bound, "Metres.")
      .field("stable_min", &NoiseEstimate::stable_min,
             "Least bound that leads to the pose, metres.")
      .field("stable_max", &NoiseEstimate::stable_max, "Largest such bound, metres.")
      .field("log10_false_alarms", &NoiseEstimate::log10_false_alarms,
             "log10 of the expected number of such consensus sets among random correspondences.")
      .read_only();
  auto alternative =
      Record<Alternative>(module, "Alternative", "Another pose that many correspondences agree on.")
          .field("target_from_source", &Alternative::target_from_source, "The transform.")
          .field("inliers", &Alternative::inliers, "(m,) int64, ascending, read only.")
          .field("evidence", &Alternative::evidence, "Sum of the evidence of the inliers.")
          .read_only();
  add_pose(alternative);
}

}  // namespace

void bind_results(nb::module_& module) {
  bind_certificate(module);
  bind_diagnostics(module);
  bind_parts(module);
  auto result =
      Record<Result>(module, "Result", kResultDoc)
          .field("status", &Result::status,
                 "'ok', 'too_few_correspondences', 'no_consensus' or 'degenerate'.")
          .field("status_reason", &Result::status_reason, "One sentence; empty when ok.")
          .field("target_from_source", &Result::target_from_source,
                 "The transform; the identity where nothing was found.")
          .field("inliers", &Result::inliers,
                 "(m,) int64, ascending indices of the correspondences within their bound, read\n"
                 "only.")
          .field("evidence", &Result::evidence, "Sum of the evidence of the inliers.")
          .field("verdict", &Result::verdict,
                 "'trusted', 'doubtful' or 'untrusted': whether chance explains so many inliers,\n"
                 "whether these are few things said often, whether a reflection fits better.")
          .field("verdict_reason", &Result::verdict_reason, "One sentence.")
          .field("log10_false_alarms", &Result::log10_false_alarms,
                 "log10 of the expected number of consensus sets as large among random matches of\n"
                 "the same points; above 0 chance explains it; 0 where there is no pose.")
          .field("certificate", &Result::certificate,
                 "How far the consensus can be from the best possible.")
          .field("consistent_scales", &Result::consistent_scales,
                 "(min, max) of the scales at which all pairs of inliers agree.")
          .field("covariance", &Result::covariance, "Where the status is 'ok', else None.")
          .field("alternatives", &Result::alternatives,
                 "The next best poses, where num_hypotheses > 1.")
          .field("noise_estimate", &Result::noise_estimate,
                 "The noise bound, where it was to be estimated, else None.")
          .field("diagnostics", &Result::diagnostics, "Times, counts, limits.")
          .read_only(&describe);
  add_pose(result);
  add_report(result);
  add_pose_graph(result, std::identity{});
  Record<Consensus>(module, "Consensus", "The correspondences that agree with a transform.")
      .field("inliers", &Consensus::inliers, "(m,) int64, ascending, read only.")
      .field("evidence", &Consensus::evidence, "Sum of the evidence of the inliers.")
      .read_only();
  Record<Uncertainty>(module, "Uncertainty", "How surely correspondences determine a transform.")
      .field("consistent_scales", &Uncertainty::consistent_scales, "As in Result.")
      .field("covariance", &Uncertainty::covariance,
             "None where the transform is one of many that fit.")
      .read_only();
}

}  // namespace gmcr::python
