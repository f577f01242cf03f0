#include "arguments/output_files.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "gmcr/io.hpp"

namespace gmcr::cli {
namespace {

namespace fs = std::filesystem;

/// Whether one would be written over the other: pipes and devices are not.
bool are_same(const fs::path& a, const fs::path& b) {
  std::error_code ignored;
  if (fs::exists(a, ignored) && !fs::is_regular_file(a, ignored)) return false;
  const auto whole = [&](const fs::path& path) {
    return fs::weakly_canonical(fs::absolute(path, ignored), ignored);
  };
  const fs::path path = whole(a);
  return fs::equivalent(a, b, ignored) || (!path.empty() && path == whole(b));
}

/// A transform is a text, so the name of a cloud is most likely meant for the moved one.
void check_transform(const fs::path& path) {
  std::vector<std::string> clouds = cloud_extensions();
  clouds.insert(clouds.end(), {".las", ".laz", ".e57"});
  std::erase_if(clouds,
                [](const std::string& known) { return known == ".txt" || known == ".csv"; });
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  if (std::find(clouds.begin(), clouds.end(), extension) == clouds.end()) return;
  throw std::invalid_argument(
      fmt::format("{} is the name of a cloud, but a transform of 4 x 4 numbers would be written; "
                  "--aligned of register and localise writes the moved cloud",
                  path.string()));
}

}  // namespace

void check_outputs(const std::vector<OutputFile>& outputs, const std::vector<std::string>& inputs) {
  std::vector<std::string> taken;
  std::copy_if(inputs.begin(), inputs.end(), std::back_inserter(taken),
               [](const std::string& path) { return !path.empty() && path != "-"; });
  const std::size_t num_inputs = taken.size();
  for (const OutputFile& output : outputs) {
    const std::string& path = output.path;
    if (path.empty()) continue;
    const auto other = std::find_if(taken.begin(), taken.end(),
                                    [&](const std::string& each) { return are_same(path, each); });
    if (other != taken.end()) {
      const bool is_input = static_cast<std::size_t>(other - taken.begin()) < num_inputs;
      throw std::invalid_argument(
          fmt::format("{} would be written over {}", path,
                      is_input ? "a file that is read" : "another file that is written"));
    }
    taken.push_back(path);
    if (output.content == Content::Transform) check_transform(path);
    if (output.content == Content::Cloud) {
      check_cloud_output(path);
    } else if (output.content == Content::Matches) {
      check_matches_output(path);
    } else {
      check_output(path);
    }
  }
}

}  // namespace gmcr::cli
