#include <cstdint>
#include <string>

#include "gmcr/io.hpp"
#include "io/bytes.hpp"
#include "io/meshes/mesh.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

constexpr std::size_t kHeaderBytes = 84;
constexpr std::size_t kTriangleBytes = 50;

Mesh mesh_of(const std::vector<double>& coordinates) {
  Mesh mesh;
  const auto count = static_cast<Index>(coordinates.size() / 3);
  mesh.vertices = Eigen::Map<const Points>(coordinates.data(), 3, count);
  for (Index i = 0; i + 2 < count; i += 3) mesh.triangles.push_back({i, i + 1, i + 2});
  return mesh;
}

Mesh parse_binary(std::string_view bytes) {
  std::vector<double> coordinates;
  for (std::size_t at = kHeaderBytes; at < bytes.size(); at += kTriangleBytes) {
    const char* corners = bytes.data() + at + 3 * sizeof(float);  // behind the normal
    for (std::size_t i = 0; i < 9; ++i) {
      coordinates.push_back(load<float>(corners + i * sizeof(float)));
    }
  }
  return mesh_of(coordinates);
}

Mesh parse_text(const std::filesystem::path& path, std::string_view text) {
  LineReader reader(text);
  const auto fail = [&](const std::string& reason) { throw IoError(path, reader.line(), reason); };
  std::vector<double> coordinates;
  bool has_end = false;
  while (const auto line = reader.next()) {
    const auto words = split_words(*line);
    if (words.empty()) continue;
    const std::string keyword = to_lower(words[0]);
    if (keyword == "endfacet" && coordinates.size() % 9 != 0) fail("a facet without 3 vertices");
    has_end = keyword == "endsolid";
    if (keyword != "vertex") continue;
    if (words.size() != 4) fail("a vertex needs x, y and z");
    for (std::size_t i = 1; i < 4; ++i) {
      const auto value = parse_cell(words[i]);
      if (!value) fail(io::quoted(words[i]) + " is no number");
      coordinates.push_back(*value);
    }
  }
  if (!has_end) fail("truncated: no endsolid");
  return mesh_of(coordinates);
}

/// Whether a text starts; a binary file may say so too.
bool says_solid(std::string_view bytes) {
  if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
  return to_lower(trim(bytes.substr(0, 80))).starts_with("solid");
}

}  // namespace

Mesh parse_stl(const std::filesystem::path& path, std::string_view bytes) {
  // binary files may start with "solid" too, so the size decides
  const bool may_be_text = says_solid(bytes) && bytes.find('\0') == std::string_view::npos;
  if (bytes.size() >= kHeaderBytes) {
    const std::size_t count = load<std::uint32_t>(bytes.data() + kHeaderBytes - 4);
    const std::size_t size = kHeaderBytes + count * kTriangleBytes;
    if (bytes.size() == size) return parse_binary(bytes);
    if (!may_be_text) {
      throw IoError(path, 0,
                    "truncated or no STL: " + std::to_string(bytes.size()) + " bytes where " +
                        std::to_string(count) + " triangles of a binary file take " +
                        std::to_string(size));
    }
  }
  if (!may_be_text) throw IoError(path, 0, "truncated or no STL: it does not start with 'solid'");
  return parse_text(path, bytes);
}

}  // namespace gmcr::io
