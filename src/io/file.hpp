#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace gmcr::io {

/// All bytes of a file.
/// @throws IoError where it is missing, a directory, unreadable, empty or compressed by gzip.
std::string read_file(const std::filesystem::path& path);

/// Replaces the file by `content`, whole or not at all (`NewFile`).
/// @throws IoError where that fails, also at the last byte (a full disk).
void write_file(const std::filesystem::path& path, std::string_view content);

/// Extension in lower case with its dot; ".pcd.bin" counts as one.
std::string extension_of(const std::filesystem::path& path);

/// "unknown extension '.foo' (known: ...)", or "no extension (known: ...)"; of ".gz"
/// what to do.
std::string unknown_extension(const std::string& extension, const std::vector<std::string>& known);

}  // namespace gmcr::io
