#include "read_points.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace gmcr::cli {

Points read_points(const std::filesystem::path& path, const CloudOptions& options) {
  Cloud cloud = read_cloud(path, options);
  say_notes(path, cloud.notes);
  return std::move(cloud.points);
}

ReadPair::ReadPair(const std::filesystem::path& source, const std::filesystem::path& target,
                   const CloudOptions& options)
    : source_(source, options), target_(target, options) {}

ReadPair::Read::Read(const std::filesystem::path& path, const CloudOptions& options) {
  std::array<char, 64> start{};
  std::ifstream(path, std::ios::binary).read(start.data(), start.size());
  if (!PreparedCloud::is_prepared({start.data(), start.size()})) {
    read = read_points(path, options);
    return;
  }
  try {
    prepared = PreparedCloud::from_bytes(read_bytes(path));
  } catch (const std::invalid_argument& error) {
    throw IoError(path, 0, error.what());
  }
}

void say_notes(const std::filesystem::path& path, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) spdlog::warn("{}: {}", path.string(), note);
}

}  // namespace gmcr::cli
