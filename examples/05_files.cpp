// Files of clouds and meshes: what is written comes back as the same bits, and notes say what was
// decided.
#include <cstdio>
#include <filesystem>

#include "gmcr/io.hpp"

int main() {
  const auto folder = std::filesystem::temp_directory_path();
  const auto cloud_path = folder / "gmcr_example_cloud.ply";
  const auto table_path = folder / "gmcr_example_cloud.txt";
  const gmcr::Points points{{0.1, 4, 7}, {2, 5.25, 8}, {3, -6, 1e-3}};

  gmcr::write_cloud(cloud_path, points);  // aside, renamed once it is whole
  gmcr::write_text(table_path, "x;y;z;intensity\n0,5;2;3;17\n4;5,25;-6;18\n");
  const gmcr::Cloud cloud = gmcr::read_cloud(cloud_path);
  const gmcr::Cloud table = gmcr::read_cloud(table_path);
  for (const std::string& note : table.notes)
    std::printf("%s: %s\n", table_path.c_str(), note.c_str());

  bool is_refused = false;
  try {
    gmcr::read_cloud(folder / "gmcr_example_cloud.docx");
  } catch (const gmcr::IoError& error) {  // path, line where there is one, reason
    std::printf("%s\n", error.what());
    is_refused = true;
  }
  std::filesystem::remove(cloud_path);
  std::filesystem::remove(table_path);
  return cloud.points == points && table.points.cols() == 2 && is_refused ? 0 : 1;
}
