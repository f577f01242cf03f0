#include "input/input_file.hpp"

#include <fstream>
#include <iostream>
#include <iterator>
#include <string_view>

namespace gmcr::cli {
namespace {

constexpr const char* kStandardInput = "standard input";

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

InputFile::InputFile(const std::string& path, TextKind kind) : path_(path), name_(path) {
  if (path != "-") return;
  name_ = kStandardInput;
  const std::string bytes(std::istreambuf_iterator<char>(std::cin), {});
  if (bytes.empty()) throw IoError(name_, 0, "empty");
  folder_.emplace();
  path_ = *folder_ / file_name(bytes, kind);
  std::ofstream file(path_, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw IoError(path_, 0, "cannot be written");
}

IoError InputFile::named(const IoError& error) const {
  return error.path() == path_ ? IoError(name_, error.line(), error.reason()) : error;
}

}  // namespace gmcr::cli
