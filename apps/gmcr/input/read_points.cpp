#include "input/read_points.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <fstream>
#include <stdexcept>
#include <utility>

namespace gmcr::cli {

Points read_points(const InputFile& file, const CloudOptions& options) {
  Cloud cloud = file.read([&](const auto& path) { return read_cloud(path, options); });
  say_notes(file, cloud.notes);
  return std::move(cloud.points);
}

ReadPair::ReadPair(const InputFile& source, const InputFile& target, const CloudOptions& options)
    : source_(source, options), target_(target, options) {}

ReadPair::Read::Read(const InputFile& file, const CloudOptions& options) {
  std::array<char, 64> start{};
  std::ifstream(file.path(), std::ios::binary).read(start.data(), start.size());
  if (!PreparedCloud::is_prepared({start.data(), start.size()})) {
    read = read_points(file, options);
    return;
  }
  try {
    prepared = PreparedCloud::from_bytes(file.read(&read_bytes));
  } catch (const std::invalid_argument& error) {
    throw IoError(file.name(), 0, error.what());
  }
}

void say_notes(const InputFile& file, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) spdlog::warn("{}: {}", file.name(), note);
}

}  // namespace gmcr::cli
