#include "fuzz/target.hpp"

namespace gmcr::fuzz {

const std::vector<Target>& targets() {
  static const std::vector<Target> all = {
      {"bin", [](std::string_view bytes) { read_cloud_of(".bin", bytes); }},
      {"cliques", find_cliques},
      {"clouds", register_small_clouds},
      {"csv", [](std::string_view bytes) { read_cloud_of(".csv", bytes); }},
      {"estimate", read_estimate},
      {"graph_clq", read_graph_clq},
      {"graph_mtx", read_graph_mtx},
      {"matches_csv", read_matches_csv},
      {"matches_npy", read_matches_npy},
      {"npy", [](std::string_view bytes) { read_cloud_of(".npy", bytes); }},
      {"obj", [](std::string_view bytes) { read_cloud_of(".obj", bytes); }},
      {"off", [](std::string_view bytes) { read_cloud_of(".off", bytes); }},
      {"pcd", [](std::string_view bytes) { read_cloud_of(".pcd", bytes); }},
      {"ply", [](std::string_view bytes) { read_cloud_of(".ply", bytes); }},
      {"pose", read_pose},
      {"prepared", read_prepared_cloud},
      {"solve", solve},
      {"stl", [](std::string_view bytes) { read_cloud_of(".stl", bytes); }},
      {"xyz", [](std::string_view bytes) { read_cloud_of(".xyz", bytes); }},
  };
  return all;
}

}  // namespace gmcr::fuzz
