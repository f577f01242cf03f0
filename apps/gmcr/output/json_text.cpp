#include "output/json_text.hpp"

#include <fmt/core.h>

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "gmcr/io.hpp"

namespace gmcr::cli {

void print_json(const std::string& text) {
  fmt::print("{}\n", text);
  if (std::fflush(stdout) != 0) throw IoError("standard output", 0, std::strerror(errno));
}

void write_json(const std::filesystem::path& path, const std::string& text) {
  write_text(path, text + '\n');
}

}  // namespace gmcr::cli
