// Readers of files: of whatever bytes they return what they promise, or throw IoError.
#include <Eigen/Core>
#include <Eigen/LU>
#include <cmath>

#include "fuzz/target.hpp"
#include "gmcr/io.hpp"
#include "gmcr/metrics.hpp"
#include "input/read_estimate.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::fuzz {
namespace {

constexpr Index kMeshPoints = 20;

/// A file that has these bytes until the next call.
std::filesystem::path file_of(const std::string& name, std::string_view bytes) {
  static const test::TemporaryFolder folder;
  return folder.write(name, bytes);
}

bool same_bits(const Points& a, const Points& b) {
  return a.cols() == b.cols() && (a.array() == b.array()).all();
}

/// What was read can be written, and reads as the same.
void check_round_trip(const Points& points) {
  for (const char* name : {"again.ply", "again.csv", "again.npy"}) {
    const auto path = file_of(name, "");
    write_cloud(path, points);
    const bool may_drop = (points.array() == 0).colwise().all().any();  // (0, 0, 0), from eleven on
    try {
      const Cloud again = read_cloud(path);
      require(may_drop || same_bits(points, again.points), std::string("the same from ") + name);
    } catch (const IoError&) {
      require(may_drop, std::string("readable: ") + name);
    }
  }
}

/// Runs `read`, which may refuse the file.
template <typename Read>
void read_or_refuse(Read read) {
  try {
    read();
  } catch (const IoError& error) {
    require(!error.reason().empty(), "an error with a reason");
  }
}

void check_matches(const std::filesystem::path& path, const std::string& again) {
  read_or_refuse([&] {
    const Matches matches = read_matches(path);
    require(matches.source.cols() == matches.target.cols(), "pairs");
    require(matches.source.allFinite() && matches.target.allFinite(), "finite matches");
    require(matches.noise_bounds.empty() ||
                static_cast<Index>(matches.noise_bounds.size()) == matches.source.cols(),
            "a bound for each or none");
    for (const double bound : matches.noise_bounds) {
      require(std::isfinite(bound) && bound > 0, "positive bounds");
    }
    if (matches.source.cols() == 0) return;
    const auto copy = file_of(again, "");
    write_matches(copy, matches.source, matches.target, matches.noise_bounds);
    const Matches same = read_matches(copy);
    require(same_bits(same.source, matches.source) && same_bits(same.target, matches.target) &&
                same.noise_bounds == matches.noise_bounds,
            "the same matches again");
  });
}

void check_graph(const std::filesystem::path& path) {
  constexpr std::size_t kMemory = 1 << 16;
  read_or_refuse([&] {
    const BitsetGraph graph = read_graph(path, kMemory);
    const Index n = graph.num_vertices();
    require(n >= 0 && static_cast<std::size_t>(n) * static_cast<std::size_t>(n) / 8 <= kMemory,
            "a graph within the limit");
    for (Index v = 0; v < n; ++v) require(!graph.has_edge(v, v), "no loops");
  });
}

}  // namespace

void check_pose(const Similarity& pose) {
  require(pose.matrix().allFinite() && pose.scale > 0, "a finite pose");
  require(std::abs(pose.rotation.determinant() - 1) < 1e-9, "a rotation");
  require(rotation_error_deg(pose.rotation, Eigen::Matrix3d::Identity()) <= 180, "an angle");
}

void read_cloud_of(const char* extension, std::string_view bytes) {
  const auto path = file_of(std::string("a") + extension, bytes);
  read_or_refuse([&] {
    const Cloud cloud = read_cloud(path, {.mesh_points = kMeshPoints});
    require(cloud.points.cols() >= 1 && cloud.points.allFinite(), "finite points");
    require(
        cloud.points.cols() + cloud.num_dropped <= static_cast<Index>(bytes.size()) + kMeshPoints,
        "no more points than bytes");
    check_round_trip(cloud.points);
    Similarity turn;
    turn.rotation << 0, -1, 0, 1, 0, 0, 0, 0, 1;
    turn.translation << 1, 2, 3;
    for (const char* name : {"moved.ply", "moved.pcd"}) {
      const auto moved = file_of(name, "");
      read_or_refuse([&] { write_moved_cloud(moved, path, turn, {.mesh_points = kMeshPoints}); });
    }
  });
}

void read_matches_csv(std::string_view bytes) {
  check_matches(file_of("a.csv", bytes), "again.csv");
}

void read_matches_npy(std::string_view bytes) {
  check_matches(file_of("a.npy", bytes), "again.npy");
}

void read_pose(std::string_view bytes) {
  const auto path = file_of("a.txt", bytes);
  read_or_refuse([&] {
    const Similarity pose = read_transform(path);
    check_pose(pose);
    const auto copy = file_of("again.txt", "");
    write_transform(copy, pose);
    check_pose(read_transform(copy));
  });
}

void read_estimate(std::string_view bytes) {
  const auto path = file_of("a.json", bytes);
  read_or_refuse([&] { check_pose(cli::read_estimate(path).pose); });
}

void read_graph_clq(std::string_view bytes) { check_graph(file_of("a.clq", bytes)); }

void read_graph_mtx(std::string_view bytes) { check_graph(file_of("a.mtx", bytes)); }

}  // namespace gmcr::fuzz
