#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "frontend/attempts.hpp"
#include "frontend/cloud_notes.hpp"
#include "frontend/cloud_pair.hpp"
#include "frontend/judgement/verdict.hpp"
#include "frontend/mirrored.hpp"
#include "parallel/deadline.hpp"
#include "parallel/parallel_for.hpp"
#include "parallel/stopwatch.hpp"

namespace gmcr {
namespace {

using frontend::Attempts;
using frontend::CloudScales;
using frontend::FrontendSetting;

/// Evidence of the mirrored source over that of the source below which it is clearly worse.
constexpr double kClearlyWorse = 0.5;

/// Whether the mirrored source, matched or turned as in an attempt, speaks less for itself.
bool is_worse(const CloudResult& mirrored, const CloudResult& result) {
  if (result.found_by_turning) {
    return mirrored.surfaces.overlap() < result.surfaces.overlap();
  }
  return mirrored.distinct_evidence < kClearlyWorse * result.distinct_evidence;
}

/// Of an object those at its own voxels come first, and the last of them turns it.
void put_object_first(std::vector<FrontendSetting>& settings, double coarsening) {
  const auto others = std::stable_partition(
      settings.begin(), settings.end(),
      [](const FrontendSetting& setting) { return setting.voxel_factor == 1; });
  FrontendSetting& last = *(others - 1);
  if (others - settings.begin() < 2) return;
  last.turns_source = true;
  last.voxel_factor = coarsening;
}

}  // namespace

CloudResult frontend::register_scales(CloudScales& source, CloudScales& target,
                                      const FrontendOptions& frontend, const Options& asked) {
  bool is_stopped = false;  // a caller who wants to stop says so to one stage, and means all
  Options options = asked;
  if (asked.progress) {
    options.progress = [&](const Progress& progress) {
      is_stopped = is_stopped || !asked.progress(progress);
      return !is_stopped;
    };
  }
  const parallel::Stopwatch stopwatch;
  const parallel::Deadline deadline(options.time_limit, options.stop);
  const bool refines = frontend.refine == Refine::Icp;
  std::vector<FrontendSetting> settings =
      list_settings(frontend, {source.points(), target.points()});
  const FrontendSetting first = settings.front();
  Attempts attempts(source, target, frontend, options, deadline);
  std::vector<LimitHit> limits;
  std::optional<FrontendSetting> mirrored_with;  // as which attempt the mirrored source was tried
  for (std::size_t k = 0; k < settings.size(); ++k) {
    // an attempt that cannot come to its pose would only take time
    const int count = attempts.count();
    if (count > 0 && deadline.remaining() < deadline.elapsed() / count) {
      limits.push_back({Limit::Time, "the time budget ended the attempts at other settings"});
      break;
    }
    if (!attempts.add(settings[k])) continue;
    if (refines && mirrored_with != attempts.best_setting() &&
        awaits_mirrored(attempts.best().result)) {
      mirrored_with = attempts.best_setting();
      const auto mirrored =
          frontend::register_mirrored(source, target, frontend, options, *mirrored_with, deadline);
      const bool is_whole = mirrored && !deadline.expired();
      if (is_whole && is_worse(*mirrored, attempts.best().result)) {
        attempts.know_mirrored_is_worse();
      }
    }
    const Verdict verdict = attempts.best().result.verdict;
    if (verdict == Verdict::Trusted) break;
    // turned all around, an object shows all that the others could find
    if (settings[k].turns_source && verdict == Verdict::Doubtful) break;
    if (k == 0 && attempts.may_show_object()) put_object_first(settings, attempts.coarsening());
  }
  CloudResult result = attempts.settled();
  bool is_left_handed = result.mirrored_is_better;
  if (refines && result.verdict != Verdict::Trusted && !is_left_handed) {
    const auto mirrored =
        frontend::register_mirrored(source, target, frontend, options, first, deadline);
    is_left_handed = mirrored && mirrored->verdict == Verdict::Trusted;
  }
  if (is_left_handed) {
    result.notes.push_back(
        "the mirrored source fits the target: one of the clouds is left-handed, negate one of its "
        "coordinates");
  }
  auto& limits_hit = result.registration.diagnostics.limits_hit;
  limits_hit.insert(limits_hit.end(), limits.begin(), limits.end());
  result.registration.diagnostics.total_seconds = stopwatch.elapsed();
  return result;
}

void frontend::refuse_noise_bounds(const Options& options) {
  if (options.noise_bounds.empty()) return;
  throw InvalidOption("noise_bounds", std::to_string(options.noise_bounds.size()) +
                                          " values for matches that are not known yet");
}

CloudResult register_clouds(const PointsRef& source, const PointsRef& target,
                            const FrontendOptions& frontend, const Options& options) {
  frontend::validate_pair(source, target, frontend, options);
  frontend::refuse_noise_bounds(options);
  frontend::DistinctCloud from, to;
  parallel::call_both(
      options.num_threads, [&] { from = frontend::without_repeats(source); },
      [&] { to = frontend::without_repeats(target); });
  const PointsRef source_kept = from.kept ? PointsRef(*from.kept) : source;
  const PointsRef target_kept = to.kept ? PointsRef(*to.kept) : target;
  frontend::CloudScales source_scales(source_kept), target_scales(target_kept);
  CloudResult result = frontend::register_scales(source_scales, target_scales, frontend, options);
  result.num_source_points = source.cols();
  result.num_target_points = target.cols();
  frontend::add_notes(result, source_scales, target_scales, from, to, frontend, options);
  return result;
}

}  // namespace gmcr
