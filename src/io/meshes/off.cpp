#include <string>

#include "gmcr/io.hpp"
#include "io/meshes/mesh.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

class OffFile {
 public:
  OffFile(const std::filesystem::path& path, std::string_view text)
      : path_(path), size_(text.size()), reader_(text) {}

  Mesh read() {
    read_keyword();
    const Index num_vertices = count_at(0);
    const Index num_faces = count_at(1);
    Mesh mesh;
    // a row of a vertex takes 6 bytes at least, one of a face 2
    if (num_vertices > static_cast<Index>(size_ / 6) || num_faces > static_cast<Index>(size_ / 2)) {
      fail("truncated: too few bytes for " + std::to_string(num_vertices) + " vertices and " +
           std::to_string(num_faces) + " faces");
    }
    mesh.vertices.resize(3, num_vertices);
    for (Index i = 0; i < num_vertices; ++i) mesh.vertices.col(i) = vertex();
    for (Index i = 0; i < num_faces; ++i) add_polygon(mesh.triangles, face(num_vertices));
    return mesh;
  }

 private:
  using Words = std::vector<std::string_view>;

  [[noreturn]] void fail(const std::string& reason) const {
    throw IoError(path_, reader_.line(), reason);
  }

  /// The words of the next line that has some, without its comment.
  Words next() {
    while (const auto line = reader_.next()) {
      Words words = split_words(line->substr(0, line->find('#')));
      if (!words.empty()) return words;
    }
    fail("truncated: the file ends before its last vertex or face");
  }

  void read_keyword() {
    counts_ = next();
    // ModelNet40 has files whose first number follows without a blank
    const std::size_t at = counts_[0].find("OFF");
    const std::string_view keyword =
        counts_[0].substr(0, at == std::string_view::npos ? at : at + 3);
    if (keyword.ends_with("OFF")) {
      const std::string_view before = keyword.substr(0, keyword.size() - 3);
      if (before.find_first_not_of("STCN") != std::string_view::npos) {
        fail(io::quoted(keyword) + ": only points of 3 coordinates are read");
      }
      counts_[0].remove_prefix(keyword.size());
      if (counts_[0].empty()) counts_.erase(counts_.begin());
      if (!counts_.empty() && counts_[0] == "BINARY") fail("binary OFF is not read");
      if (counts_.empty()) counts_ = next();
    }
    if (counts_.size() < 2) fail("no OFF file: expected the numbers of vertices and faces");
  }

  Index count_at(std::size_t i) const {
    const auto count = parse_index(counts_[i]);
    if (!count || *count < 0) fail(io::quoted(counts_[i]) + " is no number of vertices or faces");
    return *count;
  }

  Eigen::Vector3d vertex() {
    const Words words = next();
    if (words.size() < 3) fail("a vertex needs x, y and z");
    Eigen::Vector3d point;
    for (Index j = 0; j < 3; ++j) {
      const auto value = parse_cell(words[static_cast<std::size_t>(j)]);
      if (!value) fail(io::quoted(words[static_cast<std::size_t>(j)]) + " is no number");
      point[j] = *value;
    }
    return point;
  }

  std::vector<Index> face(Index num_vertices) {
    const Words words = next();
    const auto count = parse_index(words[0]);
    if (!count || *count < 0 || static_cast<std::size_t>(*count) >= words.size()) {
      fail("a face needs its number of corners, and as many");
    }
    std::vector<Index> corners;
    for (std::size_t i = 1; i <= static_cast<std::size_t>(*count); ++i) {
      const auto corner = parse_index(words[i]);
      if (!corner || *corner < 0 || *corner >= num_vertices) {
        fail(io::quoted(words[i]) + " is none of the " + std::to_string(num_vertices) +
             " vertices");
      }
      corners.push_back(*corner);
    }
    return corners;
  }

  const std::filesystem::path& path_;
  std::size_t size_;
  LineReader reader_;
  Words counts_;
};

}  // namespace

Mesh parse_off(const std::filesystem::path& path, std::string_view text) {
  return OffFile(path, text).read();
}

}  // namespace gmcr::io
