#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "frontend/cloud_notes.hpp"
#include "frontend/cloud_pair.hpp"
#include "frontend/features/stage_clock.hpp"
#include "frontend/judgement/judged_pose.hpp"
#include "frontend/map/map_state.hpp"
#include "frontend/map/nearby_map.hpp"
#include "frontend/map/place_verdict.hpp"
#include "frontend/map/placed_scan.hpp"
#include "frontend/refine_clouds.hpp"
#include "geometry/angles.hpp"
#include "geometry/elementary.hpp"
#include "gmcr/localisation.hpp"
#include "parallel/deadline.hpp"
#include "parallel/parallel_for.hpp"
#include "parallel/stopwatch.hpp"

namespace gmcr {
namespace {

using frontend::Place;
using frontend::PlaceLimits;

constexpr std::size_t kNumPlaces = 20;  // distinct ones that the surfaces are asked about
/// Angle within which an axis of a gravity prior is taken for the vertical of the map.
constexpr double kVertical = 0.35;
/// How far off a start may be, radians, beside what the headings leave.
constexpr double kTiltOfStart = 0.1;
/// Voxels about the sensor: what settles the pose on finer voxels. Farther out a scan is sparse.
constexpr double kSettleReach = 80;
/// Scan voxels below which there is nothing to compare.
constexpr Index kLeastVoxels = 20;

/// One scan on its way into a map.
class Localisation {
 public:
  Localisation(const PointsRef& scan, const frontend::MapState& map,
               const FrontendOptions& frontend, const Options& options)
      : scan_(scan),
        map_(map),
        frontend_(frontend),
        options_(options),
        deadline_(options.time_limit, options.stop) {}

  CloudResult run();

 private:
  Eigen::Vector3d up_of_scan() const;
  PlaceLimits limits(const frontend::ScanOutline& outline) const;
  Similarity as_gravity_says(Similarity pose) const;
  std::vector<Similarity> find_starts(frontend::StageClock& clock);
  void answer(const frontend::PlacedScan& placed, frontend::StageClock& clock);
  void certify_by_number();
  void give_up(Status status, const std::string& reason);
  void note_limit(const std::string& what);
  bool begin(const char* stage);

  const PointsRef& scan_;
  const frontend::MapState& map_;
  const FrontendOptions& frontend_;
  const Options& options_;
  parallel::Deadline deadline_;
  CloudResult result_;
};

Eigen::Vector3d Localisation::up_of_scan() const {
  if (!options_.gravity) return Eigen::Vector3d::UnitZ();
  const Eigen::Vector3d target = options_.gravity->target.normalized();
  const double cosine = target.dot(map_.up);
  if (std::abs(cosine) < elementary::cos(kVertical)) {
    throw InvalidOption("gravity", "its axis in the target is not the vertical of the map");
  }
  return (cosine < 0 ? -1 : 1) * options_.gravity->source.normalized();
}

PlaceLimits Localisation::limits(const frontend::ScanOutline& outline) const {
  PlaceLimits limits;
  const double beside = frontend::PlaceSearch::half_step() * std::numbers::sqrt2 +
                        options_.scale * frontend_.source_viewpoint.norm() / map_.voxel_size;
  struct Ball {
    Eigen::Vector3d centre;
    double radius;
  };
  std::vector<Ball> balls;  // where the sensor can be, from above
  const auto add_ball = [&](const Eigen::Vector3d& centre, double radius) {
    if (std::isfinite(radius))
      balls.push_back({map_.level(centre), radius / map_.voxel_size + beside});
  };
  add_ball(Eigen::Vector3d::Zero(), options_.max_translation);
  if (options_.initial_pose) {
    const InitialPose& prior = *options_.initial_pose;
    add_ball(prior.target_from_source.translation, prior.max_translation);
    limits.heading = [this, &outline, &prior](double heading) {
      Place place;
      place.heading = heading;
      const Similarity pose = map_.pose_at(place, outline, frontend_.source_viewpoint, 1);
      return geometry::rotation_angle(prior.target_from_source.rotation.transpose() *
                                      pose.rotation) <=
             prior.max_rotation + frontend::PlaceSearch::half_turn() + kTiltOfStart;
    };
  }
  if (!balls.empty()) {
    limits.position = [balls](double x, double y) {
      return std::all_of(balls.begin(), balls.end(), [&](const Ball& ball) {
        return (Eigen::Vector2d(x, y) - ball.centre.head<2>()).norm() <= ball.radius;
      });
    };
  }
  return limits;
}

/// The pose turned about the sensor so that the axes of the gravity prior are parallel: one that
/// is not admitted would not be refined.
Similarity Localisation::as_gravity_says(Similarity pose) const {
  if (!options_.gravity) return pose;
  const Eigen::Vector3d sensor = pose * frontend_.source_viewpoint;
  const Eigen::Quaterniond turn =
      geometry::turn_between(pose.rotation * options_.gravity->source, options_.gravity->target);
  pose.rotation = turn.toRotationMatrix() * pose.rotation;
  pose.translation = sensor - pose.scale * (pose.rotation * frontend_.source_viewpoint);
  return pose;
}

/// Poses at which the scan looks like the map, and the initial pose, where there is one.
std::vector<Similarity> Localisation::find_starts(frontend::StageClock& clock) {
  const CloudMatches& matches = result_.matches;
  const frontend::ScanOutline outline = frontend::outline_of(
      (matches.source_voxels.colwise() - frontend_.source_viewpoint) / matches.source_voxel_size,
      up_of_scan());
  const std::vector<Place> places =
      map_.places.best(outline, kNumPlaces, limits(outline), options_.num_threads, deadline_);
  if (deadline_.expired()) note_limit("the search for places");
  std::vector<Similarity> starts;
  if (options_.initial_pose) {
    starts.push_back(options_.initial_pose->target_from_source);
    starts.back().scale = options_.scale;
  }
  for (const Place& place : places) {
    starts.push_back(
        as_gravity_says(map_.pose_at(place, outline, frontend_.source_viewpoint, options_.scale)));
  }
  clock.lap("search");
  return starts;
}

void Localisation::give_up(Status status, const std::string& reason) {
  result_.registration.status = status;
  result_.registration.status_reason = reason;
  result_.verdict = Verdict::Untrusted;
  result_.verdict_reason = "there is no pose: " + reason;
}

void Localisation::note_limit(const std::string& what) {
  result_.registration.diagnostics.limits_hit.push_back(
      {Limit::Time, "the time budget ended " + what});
}

bool Localisation::begin(const char* stage) {
  if (frontend::begin_stage(options_, stage)) return true;
  result_.registration.diagnostics.limits_hit.push_back(
      {Limit::Stopped, std::string("the caller stopped before the ") + stage});
  give_up(Status::NoConsensus, "the caller stopped the search");
  return false;
}

/// Fills the result with the pose and the part of the map around it.
void Localisation::answer(const frontend::PlacedScan& placed, frontend::StageClock& clock) {
  CloudMatches& matches = result_.matches;
  const Similarity& pose = placed.best.target_from_source;
  const Eigen::Vector3d sensor = pose * frontend_.source_viewpoint;
  const double radius =
      pose.scale * (scan_.colwise() - frontend_.source_viewpoint).colwise().norm().maxCoeff() +
      2 * map_.voxel_size;
  matches.target_voxels = frontend::points_within(map_.voxels, sensor, radius);
  if (matches.target_voxels.cols() < kLeastVoxels) {
    return give_up(Status::NoConsensus, "the map has nothing around the best place");
  }
  result_.voxels = {matches.source_voxels,
                    matches.target_voxels,
                    matches.source_voxel_size,
                    matches.target_voxel_size,
                    {},
                    {}};
  const auto voxels = frontend::centred_pair(result_.voxels, options_.num_threads);
  frontend::match_by_pose(matches, *voxels, pose, options_.num_threads);
  result_.registration.status = Status::Ok;
  result_.rivals = placed.rivals;
  result_ = frontend::take(std::move(result_), placed.best, *voxels, options_);
  clock.lap("comparison");
  if (frontend_.refine == Refine::Icp) {
    const double near = std::min(radius, kSettleReach * map_.voxel_size);
    const Points scan =
        frontend::points_within(scan_, frontend_.source_viewpoint, near / pose.scale);
    const Points map = frontend::points_within(map_.fine, sensor, near);
    if (scan.cols() >= kLeastVoxels && map.cols() >= kLeastVoxels) {
      result_ = frontend::settle(std::move(result_), scan, map, *voxels, pose, options_, deadline_);
    }
  }
  certify_by_number();
  frontend::judge_place(result_, placed.runner_up);
}

/// The matches are what meets under the pose: no search was made among them.
void Localisation::certify_by_number() {
  Result& registration = result_.registration;
  const auto num_matches = result_.matches.source.cols();
  registration.verdict_reason = "the matches are what meets under the pose, and say no more";
  registration.diagnostics.num_correspondences = num_matches;
  registration.diagnostics.num_used = num_matches;
  Certificate& certificate = registration.certificate;
  certificate.lower = static_cast<Index>(registration.inliers.size());
  certificate.upper = num_matches;
  certificate.certified = certificate.lower == certificate.upper;
  certificate.evidence.lower = registration.evidence;
  certificate.evidence.upper = static_cast<double>(num_matches);
  certificate.target_from_source = registration.target_from_source;
  certificate.inliers = registration.inliers;
}

CloudResult Localisation::run() {
  frontend::StageClock clock(result_.registration.diagnostics.stages);
  CloudMatches& matches = result_.matches;
  result_.num_source_points = scan_.cols();
  result_.num_target_points = map_.num_given;
  result_.num_attempts = 1;
  matches.target_voxel_size = map_.voxel_size;
  matches.source_voxel_size = map_.voxel_size / options_.scale;
  matches.noise_bound = options_.noise_bound > 0 ? options_.noise_bound
                                                 : frontend_.noise_bound_voxels * map_.voxel_size;
  matches.source_voxels = voxel_grid(scan_, matches.source_voxel_size);
  clock.lap("voxel");
  if (matches.source_voxels.cols() < kLeastVoxels) {
    give_up(Status::TooFewCorrespondences, "the scan has hardly any voxels");
    return std::move(result_);
  }
  if (!begin("search")) return std::move(result_);
  const std::vector<Similarity> starts = find_starts(clock);
  if (!begin("comparison")) return std::move(result_);
  std::optional<frontend::PlacedScan> placed;
  if (!starts.empty()) {
    const auto pair = std::make_shared<frontend::CentredPair>(
        matches.source_voxels, matches.source_voxel_size, map_.surface, map_.centre);
    placed = frontend::compare_places(pair, map_.voxel_size, starts, options_, deadline_);
  }
  clock.lap("comparison");
  if (placed) {
    answer(*placed, clock);
  } else {
    give_up(Status::NoConsensus, "no place of the map that the options admit looks like the scan");
  }
  return std::move(result_);
}

}  // namespace

CloudResult localise_scan(const PointsRef& scan, const PreparedMap& map,
                          const FrontendOptions& frontend, const Options& options) {
  frontend::validate_pair(scan, Points(3, 0), frontend, options);
  frontend::refuse_noise_bounds(options);
  if (options.scale_mode == ScaleMode::Estimated) {
    throw InvalidOption("scale_mode", "the scale of a scan in a map has to be known");
  }
  const parallel::Stopwatch stopwatch;
  const frontend::DistinctCloud distinct = frontend::without_repeats(scan);
  const PointsRef kept = distinct.kept ? PointsRef(*distinct.kept) : scan;
  CloudResult result = Localisation(kept, *map.state_, frontend, options).run();
  result.num_source_points = scan.cols();
  result.registration.diagnostics.num_threads = parallel::resolve_num_threads(options.num_threads);
  result.registration.diagnostics.total_seconds = stopwatch.elapsed();
  return result;
}

}  // namespace gmcr
