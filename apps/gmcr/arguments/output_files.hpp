#pragma once

#include <string>
#include <vector>

namespace gmcr::cli {

/// What the tool writes into a file.
enum class Content { Text, Transform, Cloud, Matches };

/// A file that an option asks for; an empty path: it was not given.
struct OutputFile {
  std::string path;
  Content content;
};

/// Refuses before the work what could not be written after it, and what would be lost by it.
/// @param inputs  paths of the files that are read; "-" and empty ones are none.
/// @throws std::invalid_argument where a path is that of an input or of another output, or where a
///   transform has the name of a cloud; IoError as `check_output`.
void check_outputs(const std::vector<OutputFile>& outputs, const std::vector<std::string>& inputs);

}  // namespace gmcr::cli
