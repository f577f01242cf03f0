// A consensus function of one's own: which of many matched directions agree on a rotation. Two
// matches can both be right only where the angle between their directions stays; the largest set in
// which all pairs agree is a maximum clique.
#include <Eigen/Geometry>
#include <Eigen/SVD>
#include <cmath>
#include <cstdio>
#include <random>

#include "gmcr/clique.hpp"
#include "gmcr/metrics.hpp"

namespace {

constexpr double kNoise = 0.01;  // radians: largest error of a right match

double angle_between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.cross(b).norm(), a.dot(b));
}

/// Which pairs of matches can be right together.
gmcr::BitsetGraph consistency(const gmcr::Points& source, const gmcr::Points& target) {
  gmcr::BitsetGraph graph(source.cols());
  for (gmcr::Index i = 0; i < source.cols(); ++i) {
    for (gmcr::Index j = 0; j < i; ++j) {
      const double before = angle_between(source.col(i), source.col(j));
      const double after = angle_between(target.col(i), target.col(j));
      if (std::abs(after - before) <= 2 * kNoise) graph.add_edge(i, j);
    }
  }
  return graph;
}

/// The rotation that turns the members' directions best (Kabsch 1976).
Eigen::Matrix3d fit(const gmcr::Points& source, const gmcr::Points& target,
                    const std::vector<gmcr::Index>& members) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (const gmcr::Index i : members) sum += target.col(i) * source.col(i).transpose();
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(sum, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const double sign = (svd.matrixU() * svd.matrixV().transpose()).determinant();
  return svd.matrixU() * Eigen::Vector3d(1, 1, sign).asDiagonal() * svd.matrixV().transpose();
}

}  // namespace

int main() {
  constexpr gmcr::Index kNum = 300, kRight = 30;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  const auto direction = [&] {
    return Eigen::Vector3d(normal(random), normal(random), normal(random)).normalized();
  };
  const Eigen::Matrix3d truth = Eigen::AngleAxisd(1.2, direction()).matrix();
  gmcr::Points source(3, kNum), target(3, kNum);
  for (gmcr::Index i = 0; i < kNum; ++i) {
    source.col(i) = direction();
    const Eigen::Vector3d noisy = truth * source.col(i) + 0.3 * kNoise * direction();
    target.col(i) = i < kRight ? noisy.normalized() : direction();
  }

  const gmcr::CliqueResult consensus = gmcr::max_clique(consistency(source, target));
  const Eigen::Matrix3d rotation = fit(source, target, consensus.vertices);
  const double error = gmcr::rotation_error_deg(rotation, truth);
  std::printf("%zu of %td agree, at most %td can; rotation %.2f deg off\n",
              consensus.vertices.size(), kNum, consensus.upper_bound, error);
  return consensus.proven_optimal && error < 0.5 ? 0 : 1;
}
