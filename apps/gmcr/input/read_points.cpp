#include "input/read_points.hpp"

#include <spdlog/spdlog.h>

#include <array>
#include <fstream>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "gmcr/invalid_option.hpp"

namespace gmcr::cli {
namespace {

/// What `from_bytes` makes of a prepared file; nullopt where it is another one.
/// @throws IoError where the file does not fit.
template <class FromBytes>
auto read_prepared(const InputFile& file, const FromBytes& from_bytes)
    -> std::optional<decltype(from_bytes(std::string()))> {
  std::array<char, 64> start{};
  std::ifstream(file.path(), std::ios::binary).read(start.data(), start.size());
  if (!PreparedCloud::is_prepared({start.data(), start.size()})) return std::nullopt;
  try {
    return from_bytes(file.read(&read_bytes));
  } catch (const InvalidOption&) {
    throw;  // of the caller, not of the file
  } catch (const std::invalid_argument& error) {
    throw IoError(file.name(), 0, error.what());
  }
}

}  // namespace

Points read_points(const InputFile& file, const CloudOptions& options) {
  Cloud cloud = file.read([&](const auto& path) { return read_cloud(path, options); });
  say_notes(file, cloud.notes);
  return std::move(cloud.points);
}

ReadPair::ReadPair(const InputFile& source, const InputFile& target, const CloudOptions& options)
    : source_(source, options), target_(target, options) {}

ReadPair::Read::Read(const InputFile& file, const CloudOptions& options)
    : prepared(read_prepared(file, &PreparedCloud::from_bytes)) {
  if (!prepared) read = read_points(file, options);
}

PreparedMap read_map(const InputFile& file, const CloudOptions& options,
                     const FrontendOptions& frontend, const Eigen::Vector3d& up, int num_threads) {
  std::optional<PreparedMap> map = read_prepared(file, [&](const std::string& bytes) {
    return PreparedMap::from_bytes(bytes, up, num_threads);
  });
  if (map && frontend.voxel_size > 0 && frontend.voxel_size != map->voxel_size()) {
    throw InvalidOption("voxel_size", "the map was prepared with another one");
  }
  return map ? std::move(*map) : PreparedMap(read_points(file, options), frontend, up, num_threads);
}

void say_notes(const InputFile& file, const std::vector<std::string>& notes) {
  for (const std::string& note : notes) spdlog::warn("{}: {}", file.name(), note);
}

}  // namespace gmcr::cli
