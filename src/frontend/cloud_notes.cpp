#include "frontend/cloud_notes.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "frontend/cloud_pair.hpp"

namespace gmcr::frontend {
namespace {

constexpr double kRepeatedShare = 0.01;
/// Steps of the coordinates above this share of a voxel bend the surface.
constexpr double kCoarseStep = 0.25;
/// Extents that differ by about 1000 are metres and millimetres.
constexpr double kLeastUnits = 300;
constexpr double kMostUnits = 3000;

Eigen::Vector3d median_point(const PointsRef& points) {
  std::vector<double> values(static_cast<std::size_t>(points.cols()));
  Eigen::Vector3d median;
  for (int axis = 0; axis < 3; ++axis) {
    std::copy(points.row(axis).begin(), points.row(axis).end(), values.begin());
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    median[axis] = *middle;
  }
  return median;
}

/// Smallest step between different coordinates among some of the points along the axis of the
/// largest one; 0 where all are the same. Of coordinates that are not quantised it is tiny.
double smallest_step(const PointsRef& points) {
  constexpr Index kSamples = 2000;
  const Index stride = std::max<Index>(1, points.cols() / kSamples);
  double largest = 0;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (Index i = 0; i < points.cols(); i += stride) values.push_back(points(axis, i));
    std::sort(values.begin(), values.end());
    double step = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < values.size(); ++k) {
      if (values[k] > values[k - 1]) step = std::min(step, values[k] - values[k - 1]);
    }
    // few values leave wide gaps without being quantised
    if (std::isfinite(step) && values.size() >= kSamples / 2) largest = std::max(largest, step);
  }
  return largest;
}

template <class... Parts>
std::string sentence(const Parts&... parts) {
  std::ostringstream words;
  words.precision(3);
  (words << ... << parts);
  return words.str();
}

struct Side {
  const char* name;
  const PointsRef& points;
  const DistinctCloud& distinct;
  const Eigen::Vector3d& viewpoint;
  double voxel_size;
};

void add_notes_on(CloudResult& result, const Side& side, bool is_automatic) {
  std::vector<std::string>& notes = result.notes;
  const DistinctCloud& distinct = side.distinct;
  if (distinct.num_copies > 0) {
    const Eigen::Vector3d& p = distinct.point;
    notes.push_back(sentence(distinct.num_copies + 1, " of the ",
                             side.points.cols() + distinct.num_copies, " points of the ", side.name,
                             " are (", p.x(), ", ", p.y(), ", ", p.z(), "), which counts once"));
  }
  const double step = smallest_step(side.points);
  if (side.voxel_size > 0 && step > kCoarseStep * side.voxel_size) {
    notes.push_back(sentence("coordinates of the ", side.name, " come in steps of ", step,
                             ", coarse for voxels of ", side.voxel_size,
                             ": were large ones stored in single precision?"));
    if (result.verdict == Verdict::Trusted) {
      result.verdict = Verdict::Doubtful;
      result.verdict_reason += "; the coordinates come in coarse steps";
    }
  }
  if (is_automatic && is_viewpoint_unknown(side.points, side.viewpoint)) {
    notes.push_back(sentence("the ", side.name,
                             " lies far from the origin, which is not taken for the viewpoint: "
                             "give the viewpoint where it is known"));
  }
}

}  // namespace

DistinctCloud without_repeats(const PointsRef& points) {
  DistinctCloud cloud;
  if (points.cols() == 0) return cloud;
  const Eigen::Vector3d median = median_point(points);
  Index count = 0;
  for (Index i = 0; i < points.cols(); ++i) count += points.col(i) == median;
  if (count < 2 ||
      static_cast<double>(count) <= kRepeatedShare * static_cast<double>(points.cols())) {
    return cloud;
  }
  Points kept(3, points.cols() - count + 1);
  Index num_kept = 0;
  bool is_first = true;
  for (Index i = 0; i < points.cols(); ++i) {
    const bool is_copy = points.col(i) == median;
    if (is_copy && !is_first) continue;
    if (is_copy) is_first = false;
    kept.col(num_kept++) = points.col(i);
  }
  cloud.kept = std::move(kept);
  cloud.num_copies = count - 1;
  cloud.point = median;
  return cloud;
}

void add_notes(CloudResult& result, CloudScales& source, CloudScales& target,
               const DistinctCloud& from, const DistinctCloud& to, const FrontendOptions& frontend,
               const Options& options) {
  if (source.points().cols() == 0 || target.points().cols() == 0) return;
  const bool is_automatic = frontend.orientation == NormalOrientation::Automatic;
  const JudgedVoxels& voxels = result.voxels;
  add_notes_on(
      result,
      {"source", source.points(), from, frontend.source_viewpoint, voxels.source_voxel_size},
      is_automatic);
  add_notes_on(result,
               {"target", target.points(), to, frontend.target_viewpoint, voxels.target_voxel_size},
               is_automatic);
  if (options.scale_mode == ScaleMode::Known) {
    const double source_extent = options.scale * source.extent();
    const double target_extent = target.extent();
    const double ratio =
        std::max(source_extent, target_extent) / std::min(source_extent, target_extent);
    if (ratio > kLeastUnits && ratio < kMostUnits) {
      result.notes.push_back(sentence("the ", source_extent > target_extent ? "source" : "target",
                                      " is ", ratio,
                                      " times as large as the other cloud: metres and millimetres? "
                                      "Give the scale, or have it estimated"));
    }
  }
}

}  // namespace gmcr::frontend
