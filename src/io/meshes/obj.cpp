#include <string>

#include "gmcr/io.hpp"
#include "io/meshes/mesh.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

class ObjFile {
 public:
  ObjFile(const std::filesystem::path& path, std::string_view text) : path_(path), reader_(text) {}

  Mesh read() {
    while (const auto line = reader_.next()) {
      std::string joined(*line);
      while (trim(joined).ends_with('\\')) {  // a statement goes on in the next line
        joined = std::string(trim(joined));
        joined.back() = ' ';
        const auto more = reader_.next();
        if (!more) break;
        joined += *more;
      }
      const auto words = split_words(joined);
      if (words.empty()) continue;
      if (words[0] == "v") add_vertex(words);
      if (words[0] == "f") add_face(words);
    }
    if (coordinates_.empty()) throw IoError(path_, 0, "no vertices: no line that starts with 'v'");
    check_corners();
    const auto count = static_cast<Index>(coordinates_.size() / 3);
    return {Eigen::Map<const Points>(coordinates_.data(), 3, count), std::move(triangles_)};
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw IoError(path_, reader_.line(), reason);
  }

  void add_vertex(const std::vector<std::string_view>& words) {
    if (words.size() < 4) fail("a vertex needs x, y and z");
    for (std::size_t i = 1; i <= 3; ++i) {
      const auto value = parse_cell(words[i]);
      if (!value) fail(io::quoted(words[i]) + " is no number");
      coordinates_.push_back(*value);
    }
  }

  void add_face(const std::vector<std::string_view>& words) {
    std::vector<Index> corners;
    for (std::size_t i = 1; i < words.size(); ++i) {
      // "vertex/texture/normal"
      const auto number = parse_index(words[i].substr(0, words[i].find('/')));
      const auto num_vertices = static_cast<Index>(coordinates_.size() / 3);
      const Index corner = !number ? -1 : *number < 0 ? num_vertices + *number : *number - 1;
      if (corner < 0) fail(io::quoted(words[i]) + " is no vertex");
      if (largest_ < corner) {
        largest_ = corner;
        largest_line_ = reader_.line();
      }
      corners.push_back(corner);
    }
    add_polygon(triangles_, corners);
  }

  /// A face may come before its vertices.
  void check_corners() const {
    const auto num_vertices = static_cast<Index>(coordinates_.size() / 3);
    if (largest_ < num_vertices) return;
    throw IoError(path_, largest_line_,
                  "vertex " + std::to_string(largest_ + 1) + " of a face, but there are " +
                      std::to_string(num_vertices));
  }

  const std::filesystem::path& path_;
  LineReader reader_;
  std::vector<double> coordinates_;
  std::vector<Triangle> triangles_;
  Index largest_ = -1;
  std::size_t largest_line_ = 0;
};

}  // namespace

Mesh parse_obj(const std::filesystem::path& path, std::string_view text) {
  return ObjFile(path, text).read();
}

}  // namespace gmcr::io
