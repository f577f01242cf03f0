#include "read_points.hpp"

#include <spdlog/spdlog.h>

#include <utility>

namespace gmcr::cli {

Points read_points(const InputFile& file, const CloudOptions& options) {
  Cloud cloud = file.read([&](const auto& path) { return read_cloud(path, options); });
  say_notes(file, cloud.notes);
  return std::move(cloud.points);
}

void say_notes(const InputFile& file, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) spdlog::warn("{}: {}", file.name(), note);
}

}  // namespace gmcr::cli
