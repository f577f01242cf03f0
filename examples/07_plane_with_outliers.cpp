// The consensus graph for another model: the plane that most points with normals agree on. Two of
// them can lie on one plane only where their normals agree and each lies in the plane of the other.
#include <Eigen/Eigenvalues>
#include <cmath>
#include <cstdio>
#include <random>

#include "gmcr/clique.hpp"
#include "gmcr/types.hpp"

namespace {

constexpr double kThickness = 0.02;  // metres: largest distance of a point from its plane
constexpr double kTilt = 0.1;        // radians: largest error of a normal

/// Which pairs of points can lie on one plane.
gmcr::BitsetGraph consistency(const gmcr::Points& points, const gmcr::Points& normals) {
  gmcr::BitsetGraph graph(points.cols());
  for (gmcr::Index i = 0; i < points.cols(); ++i) {
    for (gmcr::Index j = 0; j < i; ++j) {
      const Eigen::Vector3d between = points.col(j) - points.col(i);
      const double slack = 2 * kThickness + std::sin(kTilt) * between.norm();
      const bool is_parallel = normals.col(i).dot(normals.col(j)) >= std::cos(2 * kTilt);
      const bool is_flat = std::abs(normals.col(i).dot(between)) <= slack &&
                           std::abs(normals.col(j).dot(between)) <= slack;
      if (is_parallel && is_flat) graph.add_edge(i, j);
    }
  }
  return graph;
}

/// Normal of the least-squares plane of the members.
Eigen::Vector3d fit(const gmcr::Points& points, const std::vector<gmcr::Index>& members) {
  gmcr::Points chosen(3, static_cast<gmcr::Index>(members.size()));
  for (std::size_t k = 0; k < members.size(); ++k) {
    chosen.col(static_cast<gmcr::Index>(k)) = points.col(members[k]);
  }
  chosen.colwise() -= chosen.rowwise().mean().eval();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(chosen * chosen.transpose());
  return axes.eigenvectors().col(0);
}

}  // namespace

int main() {
  constexpr gmcr::Index kNum = 400, kOnPlane = 40;
  std::mt19937 random(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const auto vector = [&] {
    return Eigen::Vector3d(uniform(random), uniform(random), uniform(random));
  };
  const Eigen::Vector3d truth = Eigen::Vector3d(0.2, -0.3, 1).normalized();
  gmcr::Points points(3, kNum), normals(3, kNum);
  for (gmcr::Index i = 0; i < kNum; ++i) {
    const Eigen::Vector3d place = vector();
    const bool is_on_plane = i < kOnPlane;
    points.col(i) = is_on_plane
                        ? place - (place.dot(truth) - 0.5 * kThickness * uniform(random)) * truth
                        : place;
    normals.col(i) = is_on_plane ? (truth + 0.04 * vector()).normalized() : vector().normalized();
  }

  const gmcr::CliqueResult consensus = gmcr::max_clique(consistency(points, normals));
  const Eigen::Vector3d normal = fit(points, consensus.vertices);
  const double degrees = std::acos(std::min(1.0, std::abs(normal.dot(truth)))) * 180 / 3.14159265;
  std::printf("%zu of %td points lie on the plane, no plane has more than %td; %.2f deg off\n",
              consensus.vertices.size(), kNum, consensus.upper_bound, degrees);
  return consensus.proven_optimal && consensus.vertices.size() >= 38 && degrees < 1 ? 0 : 1;
}
