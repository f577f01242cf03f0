#include "gmcr/io.hpp"

namespace gmcr {
namespace {

std::string message(const std::filesystem::path& path, std::size_t line,
                    const std::string& reason) {
  std::string text = path.string();
  if (line > 0) text.append(":").append(std::to_string(line));
  return text.append(": ").append(reason);
}

}  // namespace

IoError::IoError(const std::filesystem::path& path, std::size_t line, const std::string& reason)
    : std::runtime_error(message(path, line, reason)), path_(path), line_(line), reason_(reason) {}

}  // namespace gmcr
