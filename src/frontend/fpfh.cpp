#include "frontend/fpfh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <stdexcept>

#include "frontend/normals.hpp"
#include "gmcr/frontend.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr int kBinsPerAngle = 11;
constexpr Index kGrain = 256;

struct PairAngles {
  double theta;      ///< radians, (-pi, pi]
  double cos_alpha;  ///< [-1, 1]
  double cos_phi;    ///< [-1, 1]
};

/// Angles of the Darboux frame of two oriented points (Rusu et al. 2009, eq. 1 and 2); nullopt
/// where the frame is not defined: the offset is 0 or parallel to the normal.
std::optional<PairAngles> pair_angles(const Eigen::Vector3d& offset, const Eigen::Vector3d& n1,
                                      const Eigen::Vector3d& n2) {
  const double distance = offset.norm();
  if (distance == 0) return std::nullopt;
  const double cos1 = n1.dot(offset) / distance;
  const double cos2 = n2.dot(offset) / distance;
  // the frame sits at the point whose normal is closer to the line between the two, the first where
  // they are equal: parallel normals are common, and rounding must not decide
  constexpr double kTie = 1e-9;
  const bool at_first = std::abs(cos1) >= std::abs(cos2) - kTie;
  const Eigen::Vector3d& u = at_first ? n1 : n2;
  const Eigen::Vector3d& other = at_first ? n2 : n1;
  Eigen::Vector3d v =
      at_first ? Eigen::Vector3d(offset.cross(u)) : Eigen::Vector3d(u.cross(offset));
  const double sine = v.norm();
  if (sine == 0) return std::nullopt;
  v /= sine;
  const Eigen::Vector3d w = u.cross(v);
  return PairAngles{std::atan2(w.dot(other), u.dot(other)), v.dot(other), at_first ? cos1 : -cos2};
}

int bin_of(double value, double min, double max) {
  const double bin = std::floor(kBinsPerAngle * (value - min) / (max - min));
  return std::clamp(static_cast<int>(bin), 0, kBinsPerAngle - 1);
}

/// Simplified histogram: angles between point i and each of its neighbours; sums to 100 an angle.
Eigen::Vector<float, kFpfhBins> simplified_histogram(const PointsRef& points, const Points& normals,
                                                     const Neighbourhoods& neighbourhoods,
                                                     Index i) {
  Eigen::Vector<float, kFpfhBins> histogram = Eigen::Vector<float, kFpfhBins>::Zero();
  const auto indices = neighbourhoods.indices_of(i);
  if (indices.empty()) return histogram;
  constexpr double kPi = std::numbers::pi;
  for (const std::int32_t j : indices) {
    if (normals.col(j).isZero(0)) continue;
    const auto angles = pair_angles(points.col(j) - points.col(i), normals.col(i), normals.col(j));
    if (!angles) continue;
    histogram[bin_of(angles->theta, -kPi, kPi)] += 1;
    histogram[kBinsPerAngle + bin_of(angles->cos_alpha, -1, 1)] += 1;
    histogram[2 * kBinsPerAngle + bin_of(angles->cos_phi, -1, 1)] += 1;
  }
  const float count = histogram.head<kBinsPerAngle>().sum();
  if (count > 0) histogram *= 100 / count;
  return histogram;
}

/// Adds the weighted mean of the neighbours' histograms to that of point i.
Eigen::Vector<float, kFpfhBins> full_histogram(const Features& simplified,
                                               const Neighbourhoods& neighbourhoods, Index i) {
  const auto indices = neighbourhoods.indices_of(i);
  const auto squared_distances = neighbourhoods.squared_distances_of(i);
  Eigen::Vector<float, kFpfhBins> sum = Eigen::Vector<float, kFpfhBins>::Zero();
  for (std::size_t k = 0; k < indices.size(); ++k) {
    if (squared_distances[k] == 0) continue;
    sum += simplified.col(indices[k]) * static_cast<float>(1 / squared_distances[k]);
  }
  const float total = sum.head<kBinsPerAngle>().sum();
  if (total > 0) sum *= 100 / total;
  return sum + simplified.col(i);
}

}  // namespace

Features compute_fpfh(const PointsRef& points, const Points& normals,
                      const Neighbourhoods& neighbourhoods, int num_threads) {
  const Index n = points.cols();
  Features simplified = Features::Zero(kFpfhBins, n);
  parallel::parallel_for(n, kGrain, num_threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      if (normals.col(i).isZero(0)) continue;
      simplified.col(i) = simplified_histogram(points, normals, neighbourhoods, i);
    }
  });
  Features features = Features::Zero(kFpfhBins, n);
  parallel::parallel_for(n, kGrain, num_threads, [&](Index begin, Index end) {
    for (Index i = begin; i < end; ++i) {
      if (normals.col(i).isZero(0)) continue;
      features.col(i) = full_histogram(simplified, neighbourhoods, i);
    }
  });
  return features;
}

}  // namespace gmcr::frontend

namespace gmcr {

Eigen::Matrix<float, 33, Eigen::Dynamic> fpfh(const PointsRef& points,
                                              const FrontendOptions& frontend, double voxel_size,
                                              int num_threads) {
  static_assert(frontend::kFpfhBins == 33);
  frontend.validate();
  if (!points.allFinite()) throw std::invalid_argument("points: not all are finite");
  const auto neighbourhoods =
      frontend::find_neighbourhoods(points, frontend.feature_radius * voxel_size, num_threads);
  const Points normals = frontend::estimate_normals(
      points, neighbourhoods, frontend.normal_radius * voxel_size, num_threads);
  return frontend::compute_fpfh(
      points,
      frontend.orientation == NormalOrientation::Outward
          ? frontend::orient_outward(points, normals)
          : frontend::orient_toward(points, normals, frontend.source_viewpoint),
      neighbourhoods, num_threads);
}

}  // namespace gmcr
