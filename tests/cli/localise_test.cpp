#include "cli/tool.hpp"
#include "gmcr/io.hpp"
#include "synthetic/town/lidar.hpp"

namespace gmcr {
namespace {

using nlohmann::json;
using test::expect_failure;
using test::run_json;
using test::TemporaryFolder;

/// A town, and one scan of it.
class Localise : public testing::Test {
 protected:
  Localise() {
    synthetic::TownOptions options;
    options.extent = 50;
    options.block = 50;
    const synthetic::Town town = make_town(options);
    write_cloud(folder_ / "map.ply", map_of(town, 20, 0.25, 1));
    synthetic::Random random(2);
    truth_ = sensor_at({{20, 0.5}, 1.3}, 1, random);
    write_cloud(folder_ / "scan.ply",
                scan(synthetic::RayCaster(town), truth_, synthetic::lidar_of(32), 1));
  }

  std::string path(const std::string& name) const { return "'" + (folder_ / name).string() + "'"; }

  void expect_truth(const json& result, const std::string& command) const {
    EXPECT_EQ(result.at("status"), "ok") << command;
    EXPECT_EQ(result.at("verdict"), "trusted") << result.at("verdict_reason");
    const auto& rows = result.at("target_from_source");
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_NEAR(rows.at(axis).at(3).get<double>(), truth_.translation[static_cast<Index>(axis)],
                  0.1);
    }
  }

  TemporaryFolder folder_;
  Similarity truth_;
};

TEST_F(Localise, FindsTheScanInACloudAndInAPreparedMap) {
  const std::string scan = "localise " + path("scan.ply") + " ";
  const json result = run_json(scan + path("map.ply") + " --voxel 0.5 -o " + path("T.txt") +
                               " --aligned " + path("aligned.ply"));
  expect_truth(result, "of a cloud");
  EXPECT_EQ(result.at("voxel_size"), 0.5);
  EXPECT_LT((read_transform(folder_ / "T.txt").translation - truth_.translation).norm(), 0.1);
  EXPECT_EQ(read_cloud(folder_ / "aligned.ply").points.cols(),
            read_cloud(folder_ / "scan.ply").points.cols());

  const json prepared =
      run_json("prepare " + path("map.ply") + " --map --voxel 0.5 -o " + path("town.ply"));
  EXPECT_LT(prepared.at("num_points").get<Index>(), read_cloud(folder_ / "map.ply").points.cols());
  const json again = run_json(scan + path("town.ply"));
  EXPECT_EQ(again.at("num_target_points"), result.at("num_target_points"));
  EXPECT_EQ(result.at("num_target_points"), read_cloud(folder_ / "map.ply").points.cols());
  EXPECT_EQ(again.at("target_from_source"), result.at("target_from_source"));
  expect_failure(scan + path("town.ply") + " --voxel 0.4", 2, "voxel");
  expect_failure(scan + path("town.ply") + " --up 0 0 0", 2, "up");
  expect_failure(scan + path("absent.ply"), 3, "absent.ply");
  expect_failure("localise - -", 2, "only one can be stdin");
}

}  // namespace
}  // namespace gmcr
