#include "read_points.hpp"

#include <spdlog/spdlog.h>

#include <utility>

namespace gmcr::cli {

Points read_points(const std::filesystem::path& path, const CloudOptions& options) {
  Cloud cloud = read_cloud(path, options);
  say_notes(path, cloud.notes);
  return std::move(cloud.points);
}

void say_notes(const std::filesystem::path& path, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) spdlog::warn("{}: {}", path.string(), note);
}

}  // namespace gmcr::cli
