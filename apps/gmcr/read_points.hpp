#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gmcr/io.hpp"

namespace gmcr::cli {

/// Reads a cloud; what the reader notes, such as points that it dropped, is said on stderr.
Points read_points(const std::filesystem::path& path, const CloudOptions& options);

/// Says what a reader noted of a file, on stderr.
void say_notes(const std::filesystem::path& path, const std::vector<std::string>& notes);

}  // namespace gmcr::cli
