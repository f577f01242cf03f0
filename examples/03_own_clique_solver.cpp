// Another maximum clique solver in place of the library's own, and the library's own by itself.
#include <cstdio>
#include <memory>

#include "gmcr/registration.hpp"

/// Wraps the library's solver; yours would wrap another one.
class ReportingSolver : public gmcr::CliqueSolver {
 public:
  gmcr::CliqueResult solve(const gmcr::BitsetGraph& graph,
                           const gmcr::CliqueOptions& options) const override {
    gmcr::CliqueResult result = gmcr::max_clique(graph, options);
    std::printf("graph of %td vertices: clique of %zu, at most %td\n", graph.num_vertices(),
                result.vertices.size(), result.upper_bound);
    return result;
  }
};

int main() {
  gmcr::BitsetGraph pentagon(5);
  for (int v = 0; v < 5; ++v) pentagon.add_edge(v, (v + 1) % 5);
  const bool pentagon_is_right = gmcr::max_clique(pentagon).vertices.size() == 2;

  const gmcr::Points source = gmcr::Points::Random(3, 40);
  gmcr::Points target = source.colwise() + Eigen::Vector3d(1, 2, 3);
  target.rightCols(20) = gmcr::Points::Random(3, 20);
  gmcr::Options options;
  options.noise_bound = 0.01;
  options.method = gmcr::Method::Paper;
  options.clique_solver = std::make_shared<ReportingSolver>();
  const gmcr::Result result = gmcr::register_correspondences(source, target, options);
  return pentagon_is_right && result.status == gmcr::Status::Ok ? 0 : 1;
}
