#include "io/file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "gmcr/io.hpp"
#include "io/text.hpp"

namespace gmcr::io {
namespace {

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

File open(const std::filesystem::path& path, const char* mode) {
  errno = 0;
  File file(std::fopen(path.c_str(), mode));
  if (!file) throw IoError(path, 0, std::strerror(errno));
  return file;
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError(path, 0, "is a directory");
  const File file = open(path, "rb");
  std::string content;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored) content.reserve(size);
  std::string chunk(std::size_t{1} << 16, '\0');
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    content.append(chunk, 0, count);
  }
  if (std::ferror(file.get())) throw IoError(path, 0, std::strerror(errno));
  if (content.empty()) throw IoError(path, 0, "file is empty");
  return content;
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  File file = open(path, "wb");
  const std::size_t written = std::fwrite(content.data(), 1, content.size(), file.get());
  // the close flushes what is buffered, so it can be what fails
  const bool closed = std::fclose(file.release()) == 0;
  if (written != content.size() || !closed) throw IoError(path, 0, std::strerror(errno));
}

std::string extension_of(const std::filesystem::path& path) {
  const std::string name = to_lower(path.filename().string());
  if (name.ends_with(".pcd.bin")) return ".pcd.bin";
  return std::filesystem::path(name).extension().string();
}

std::string unknown_extension(const std::string& extension, std::string_view known) {
  const std::string what =
      extension.empty() ? "no extension" : "unknown extension '" + extension + "'";
  return what + " (known: " + std::string(known) + ")";
}

}  // namespace gmcr::io
