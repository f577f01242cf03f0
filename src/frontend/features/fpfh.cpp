#include "frontend/features/fpfh.hpp"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "frontend/features/normals.hpp"
#include "gmcr/frontend.hpp"
#include "kernels/features/pair_angles.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::frontend {
namespace {

constexpr Index kFeatureGrain = 256;
static_assert(kFpfhBins == kernels::kPairAngles * kernels::kAngleBins);

/// Histograms of floats, `kernels::kHistogramStride` apart.
using Histograms = Eigen::Matrix<float, kernels::kHistogramStride, Eigen::Dynamic>;

/// Histograms of the angles between each point and its neighbours; each sums to 100 an angle.
Histograms simplified_histograms(const PointsRef& points, const Points& normals,
                                 const Neighbourhoods& neighbourhoods, int num_threads) {
  const Eigen::MatrixX3d p = points.transpose(), n = normals.transpose();
  const kernels::OrientedPoints oriented{p.col(0).data(), p.col(1).data(), p.col(2).data(),
                                         n.col(0).data(), n.col(1).data(), n.col(2).data()};
  Histograms histograms = Histograms::Zero(Histograms::RowsAtCompileTime, points.cols());
  parallel::parallel_for(points.cols(), kFeatureGrain, num_threads, [&](Index begin, Index end) {
    using Counts = Eigen::Matrix<std::int32_t, kernels::kAngleRow, kernels::kPairAngles>;
    for (Index i = begin; i < end; ++i) {
      if (normals.col(i).isZero(0)) continue;
      Counts counts = Counts::Zero();
      const auto indices = neighbourhoods.indices_of(i);
      kernels::count_pair_angles(oriented, i, indices.data(), static_cast<Index>(indices.size()),
                                 counts.data());
      const auto angles = counts.topRows<kernels::kAngleBins>().cast<float>();
      const float count = angles.col(0).sum();  // whole numbers: exact
      if (count == 0) continue;
      histograms.col(i).head<kFpfhBins>() = (angles * (100 / count)).reshaped();
    }
  });
  return histograms;
}

/// Adds the weighted mean of the neighbours' histograms to that of point i.
Eigen::Vector<float, kFpfhBins> full_histogram(const Histograms& simplified,
                                               const Neighbourhoods& neighbourhoods, Index i,
                                               std::vector<float>& weights) {
  const auto indices = neighbourhoods.indices_of(i);
  const auto squared_distances = neighbourhoods.squared_distances_of(i);
  weights.resize(indices.size());
  std::transform(squared_distances.begin(), squared_distances.end(), weights.begin(),
                 [](double squared) { return squared == 0 ? 0 : static_cast<float>(1 / squared); });
  Eigen::Vector<float, kernels::kHistogramStride> sum;
  kernels::add_histograms(simplified.data(), indices.data(), weights.data(),
                          static_cast<Index>(indices.size()), sum.data());
  float total = 0;
  for (Index bin = 0; bin < kernels::kAngleBins; ++bin) total += sum[bin];
  if (total > 0) sum *= 100 / total;
  return sum.head<kFpfhBins>() + simplified.col(i).head<kFpfhBins>();
}

}  // namespace

Features compute_fpfh(const PointsRef& points, const Points& normals,
                      const Neighbourhoods& neighbourhoods, int num_threads) {
  const Histograms simplified = simplified_histograms(points, normals, neighbourhoods, num_threads);
  Features features = Features::Zero(kFpfhBins, points.cols());
  parallel::parallel_for(points.cols(), kFeatureGrain, num_threads, [&](Index begin, Index end) {
    std::vector<float> weights;
    for (Index i = begin; i < end; ++i) {
      if (normals.col(i).isZero(0)) continue;
      features.col(i) = full_histogram(simplified, neighbourhoods, i, weights);
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
