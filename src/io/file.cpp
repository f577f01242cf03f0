#include "io/file.hpp"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "gmcr/io.hpp"
#include "io/new_file.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

constexpr const char* kGzip = "compressed by gzip: unpack it first";

struct Closer {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Closer>;

File open(const std::filesystem::path& path) {
  errno = 0;
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw IoError(path, 0, std::strerror(errno));
  return file;
}

}  // namespace

std::string read_file(const std::filesystem::path& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw IoError(path, 0, "is a directory");
  const File file = open(path);
  std::string content;
  const auto size = std::filesystem::file_size(path, ignored);
  if (!ignored) content.reserve(size);
  errno = 0;
  std::string chunk(std::size_t{1} << 16, '\0');
  while (const std::size_t count = std::fread(chunk.data(), 1, chunk.size(), file.get())) {
    content.append(chunk, 0, count);
  }
  if (std::ferror(file.get())) throw IoError(path, 0, std::strerror(errno));
  if (content.empty()) throw IoError(path, 0, "file is empty");
  if (content.starts_with("\x1F\x8B\x08")) throw IoError(path, 0, kGzip);
  return content;
}

void write_file(const std::filesystem::path& path, std::string_view content) {
  NewFile file(path);
  file.write(content);
  file.commit();
}

std::string extension_of(const std::filesystem::path& path) {
  const std::string name = to_lower(path.filename().string());
  if (name.ends_with(".pcd.bin")) return ".pcd.bin";
  return std::filesystem::path(name).extension().string();
}

std::string unknown_extension(const std::string& extension, const std::vector<std::string>& known) {
  if (extension == ".gz") return kGzip;
  const std::string what =
      extension.empty() ? "no extension" : "unknown extension '" + extension + "'";
  std::string list;
  for (const std::string& each : known) list += (list.empty() ? "" : ", ") + each;
  return what + " (known: " + list + ")";
}

}  // namespace gmcr::io
