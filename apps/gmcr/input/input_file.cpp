#include "input/input_file.hpp"

#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

namespace gmcr::cli {
namespace {

constexpr const char* kStandardInput = "standard input";

/// A pipe or a device, which can be read but once.
bool is_stream(const std::filesystem::path& path) {
  std::error_code ignored;
  const auto status = std::filesystem::status(path, ignored);
  return std::filesystem::exists(status) && !std::filesystem::is_regular_file(status) &&
         !std::filesystem::is_directory(status);
}

std::string bytes_of_standard_input() {
  std::string bytes(std::istreambuf_iterator<char>(std::cin), {});
  if (bytes.empty()) throw IoError(kStandardInput, 0, "empty");
  return bytes;
}

/// Name of a file whose extension tells what the bytes are.
std::string file_name(std::string_view bytes, TextKind kind) {
  if (bytes.starts_with("\x93NUMPY")) return "stdin.npy";
  if (bytes.starts_with("ply")) return "stdin.ply";
  if (bytes.starts_with("# .PCD") || bytes.starts_with("VERSION")) return "stdin.pcd";
  if (bytes.starts_with("%%MatrixMarket")) return "stdin.mtx";
  const std::size_t first = bytes.find_first_not_of(" \t\r\n");
  if (first != std::string_view::npos && bytes[first] == '{') return "stdin.json";
  return kind == TextKind::Graph ? "stdin.clq" : "stdin.csv";
}

}  // namespace

InputFile::InputFile(const std::string& path, TextKind kind)
    : path_(path), name_(path == "-" ? kStandardInput : path) {
  if (path != "-" && !is_stream(path)) return;
  const std::string bytes = path == "-" ? bytes_of_standard_input() : read_bytes(path);
  folder_.emplace();
  path_ = *folder_ / (path_.has_extension() ? path_.filename().string() : file_name(bytes, kind));
  std::ofstream file(path_, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw IoError(path_, 0, "cannot be written");
}

IoError InputFile::named(const IoError& error) const {
  return error.path() == path_ ? IoError(name_, error.line(), error.reason()) : error;
}

}  // namespace gmcr::cli
