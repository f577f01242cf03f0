#pragma once

#include <filesystem>
#include <string>

namespace gmcr::cli {

/// Spaces a level of the JSON that the tool writes.
inline constexpr int kJsonIndent = 2;

/// Prints the text of an object on stdout.
/// @throws IoError where that fails.
void print_json(const std::string& text);

/// Writes the text of an object to a file.
/// @throws IoError where that fails.
void write_json(const std::filesystem::path& path, const std::string& text);

}  // namespace gmcr::cli
