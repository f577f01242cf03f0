#include "read_points.hpp"

#include <spdlog/spdlog.h>

#include <utility>

#include "gmcr/io.hpp"

namespace gmcr::cli {

Points read_points(const std::filesystem::path& path) {
  Cloud cloud = read_cloud(path);
  if (cloud.num_dropped > 0) {
    spdlog::warn("{}: dropped {} points that are not finite", path.string(), cloud.num_dropped);
  }
  return std::move(cloud.points);
}

}  // namespace gmcr::cli
