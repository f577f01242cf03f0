#include "gmcr/prepared_cloud.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "frontend/cloud_notes.hpp"
#include "frontend/cloud_pair.hpp"
#include "frontend/features/prepared_file.hpp"
#include "gmcr/invalid_option.hpp"

namespace gmcr {
namespace {

/// Options of a pair with the radii and viewpoints of its clouds.
/// @throws InvalidOption where the options ask for others.
template <class Value>
void adopt(const char* name, Value& asked, const Value& by_default, const Value& prepared) {
  if (asked != by_default && asked != prepared) {
    throw InvalidOption(name, "the cloud was prepared with another one");
  }
  asked = prepared;
}

}  // namespace

struct PreparedCloud::State {
  State(Points of_cloud, double size, double normals, double features, Eigen::Vector3d from)
      : points(std::move(of_cloud)),
        view(points),
        scales(view),
        normal_radius(normals),
        feature_radius(features),
        viewpoint(std::move(from)) {
    if (size > 0) scales.set_voxel_size(size);
  }

  Points points;
  PointsRef view;
  frontend::CloudScales scales;
  double normal_radius, feature_radius;  // voxels
  Eigen::Vector3d viewpoint;             // metres
};

PreparedCloud::PreparedCloud(std::shared_ptr<State> state) : state_(std::move(state)) {}

PreparedCloud PreparedCloud::beside(const PointsRef& points,
                                    const Eigen::Vector3d& other_viewpoint) const {
  frontend::validate_pair(points, points, {}, {});
  frontend::DistinctCloud distinct = frontend::without_repeats(points);
  return PreparedCloud(
      std::make_shared<State>(distinct.kept ? std::move(*distinct.kept) : Points(points), 0,
                              state_->normal_radius, state_->feature_radius, other_viewpoint));
}

PreparedCloud::PreparedCloud(const PointsRef& points, const FrontendOptions& options,
                             int num_threads) {
  Options solver;
  solver.num_threads = num_threads;
  frontend::validate_pair(points, points, options, solver);
  frontend::DistinctCloud distinct = frontend::without_repeats(points);
  state_ = std::make_shared<State>(distinct.kept ? std::move(*distinct.kept) : Points(points),
                                   options.voxel_size, options.normal_radius,
                                   options.feature_radius, options.source_viewpoint);
  // the side of the first attempt
  const frontend::FrontendSetting first =
      frontend::list_settings(options, {state_->view, state_->view}).front();
  std::vector<StageTime> stages;
  frontend::StageClock clock(stages);
  frontend::CloudScales& scales = state_->scales;
  const frontend::Surface& surface =
      scales.surface(scales.voxel_size(), options, num_threads, clock);
  scales.features(surface, first.source_side, options.source_viewpoint, num_threads, clock);
}

const Points& PreparedCloud::points() const { return state_->points; }
double PreparedCloud::voxel_size() const { return state_->scales.voxel_size(); }
double PreparedCloud::normal_radius() const { return state_->normal_radius; }
double PreparedCloud::feature_radius() const { return state_->feature_radius; }
const Eigen::Vector3d& PreparedCloud::viewpoint() const { return state_->viewpoint; }

std::string PreparedCloud::to_bytes() const {
  return frontend::write_prepared({state_->points, voxel_size(), state_->normal_radius,
                                   state_->feature_radius, state_->viewpoint,
                                   state_->scales.known(), state_->points.cols()});
}

bool PreparedCloud::is_prepared(std::string_view bytes) { return frontend::is_prepared(bytes); }

PreparedCloud PreparedCloud::from_bytes(std::string_view bytes) {
  frontend::PreparedFile file = frontend::read_prepared(bytes);
  FrontendOptions options;
  options.voxel_size = file.voxel_size;
  options.normal_radius = file.normal_radius;
  options.feature_radius = file.feature_radius;
  options.source_viewpoint = file.viewpoint;
  frontend::validate_pair(file.points, file.points, options, {});
  auto state = std::make_shared<State>(std::move(file.points), file.voxel_size, file.normal_radius,
                                       file.feature_radius, file.viewpoint);
  for (frontend::KnownSurface& known : file.surfaces) state->scales.add(std::move(known));
  return PreparedCloud(std::move(state));
}

namespace frontend {
namespace {

FrontendOptions options_of(const PreparedCloud& source, const PreparedCloud& target,
                           const FrontendOptions& asked) {
  const FrontendOptions by_default;
  if (source.normal_radius() != target.normal_radius() ||
      source.feature_radius() != target.feature_radius()) {
    throw std::invalid_argument("target: it was prepared with other radii than the source");
  }
  FrontendOptions options = asked;
  adopt("normal_radius", options.normal_radius, by_default.normal_radius, source.normal_radius());
  adopt("feature_radius", options.feature_radius, by_default.feature_radius,
        source.feature_radius());
  adopt("source_viewpoint", options.source_viewpoint, by_default.source_viewpoint,
        source.viewpoint());
  adopt("target_viewpoint", options.target_viewpoint, by_default.target_viewpoint,
        target.viewpoint());
  return options;
}

}  // namespace
}  // namespace frontend

CloudMatches match_clouds(const PreparedCloud& source, const PreparedCloud& target,
                          const FrontendOptions& asked, const Options& options) {
  const FrontendOptions frontend = frontend::options_of(source, target, asked);
  frontend::validate_pair(source.points(), target.points(), frontend, options);
  return frontend::match_scales(source.state_->scales, target.state_->scales, frontend, options);
}

CloudResult register_clouds(const PreparedCloud& source, const PreparedCloud& target,
                            const FrontendOptions& asked, const Options& options) {
  const FrontendOptions frontend = frontend::options_of(source, target, asked);
  frontend::validate_pair(source.points(), target.points(), frontend, options);
  frontend::refuse_noise_bounds(options);
  CloudResult result =
      frontend::register_scales(source.state_->scales, target.state_->scales, frontend, options);
  frontend::add_notes(result, source.state_->scales, target.state_->scales, {}, {}, frontend,
                      options);
  return result;
}

}  // namespace gmcr
