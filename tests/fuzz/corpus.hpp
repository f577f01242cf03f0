#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gmcr::fuzz {

/// The inputs of a corpus, which tools/fuzz writes: one a line, bytes that are not printable as
/// `\xHH`; lines that start with `#` are comments.
std::vector<std::string> read_corpus(const std::filesystem::path& path);

}  // namespace gmcr::fuzz
