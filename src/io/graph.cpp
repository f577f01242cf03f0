#include <charconv>
#include <optional>

#include "gmcr/io.hpp"
#include "io/file.hpp"
#include "io/tables/text.hpp"

namespace gmcr {
namespace {

using Words = std::vector<std::string_view>;

/// What a graph file says about itself, and where it is being read.
class GraphFile {
 public:
  GraphFile(const std::filesystem::path& path, std::string_view text, std::size_t memory_limit)
      : path_(path), reader_(text), memory_limit_(memory_limit) {}

  BitsetGraph read_dimacs() {
    std::optional<BitsetGraph> graph;
    Index expected = 0, read = 0;
    while (const auto words = next_words('c')) {
      if (words->front() == "p") {
        if (graph) fail("a second problem line");
        if (words->size() != 4 || ((*words)[1] != "edge" && (*words)[1] != "col")) {
          fail("expected 'p edge VERTICES EDGES'");
        }
        graph = make_graph(count((*words)[2]));
        expected = count((*words)[3]);
      } else if (words->front() == "e") {
        if (!graph) fail("an edge before the problem line");
        if (words->size() != 3) fail("expected 'e U V'");
        add_edge(*graph, (*words)[1], (*words)[2]);
        ++read;
      } else if (words->front() != "n" && words->front() != "d" && words->front() != "v" &&
                 words->front() != "x") {
        fail("no DIMACS line: it starts with " + io::quoted(words->front()));
      }
    }
    if (!graph) throw IoError(path_, 0, "no problem line 'p edge VERTICES EDGES'");
    // some collections count each edge twice in the problem line
    if (read < expected && 2 * read != expected) check_count(expected, read);
    return *std::move(graph);
  }

  BitsetGraph read_matrix_market() {
    read_banner();
    const auto sizes = next_words('%');
    if (!sizes || sizes->size() != 3) fail("expected 'ROWS COLUMNS ENTRIES'");
    const Index num_vertices = count((*sizes)[0]);
    if (count((*sizes)[1]) != num_vertices) fail("the matrix is not square");
    const Index expected = count((*sizes)[2]);
    BitsetGraph graph = make_graph(num_vertices);
    Index read = 0;
    while (const auto words = next_words('%')) {
      if (words->size() != words_per_entry_) {
        fail("expected " + std::to_string(words_per_entry_) + " numbers");
      }
      if (words_per_entry_ == 3 && !io::parse_double((*words)[2])) {
        fail(io::quoted((*words)[2]) + " is no number");
      }
      add_edge(graph, (*words)[0], (*words)[1]);
      if (++read > expected)
        fail("more entries than the " + std::to_string(expected) + " promised");
    }
    check_count(expected, read);
    return graph;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const {
    throw IoError(path_, reader_.line(), reason);
  }

  /// Words of the next line that is neither blank nor a comment.
  std::optional<Words> next_words(char comment) {
    while (const auto line = reader_.next()) {
      Words words = io::split_words(*line);
      if (words.empty() || is_comment(words.front(), comment)) continue;
      return words;
    }
    return std::nullopt;
  }

  /// DIMACS comments are the word "c"; those of MatrixMarket start with '%'.
  static bool is_comment(std::string_view word, char comment) {
    return comment == 'c' ? word == "c" : word.front() == comment;
  }

  Index count(std::string_view word) const {
    const auto value = io::parse_index(word);
    if (!value || *value < 0) fail(io::quoted(word) + " is no count");
    return *value;
  }

  BitsetGraph make_graph(Index num_vertices) const {
    // in floating point, since a lying count can overflow the exact figure
    const double bytes = static_cast<double>(num_vertices) * static_cast<double>(num_vertices) / 8;
    if (bytes > static_cast<double>(memory_limit_) ||
        BitsetGraph::bytes_required(num_vertices) > memory_limit_) {
      fail(std::to_string(num_vertices) + " vertices need " +
           std::to_string(static_cast<unsigned long long>(std::min(bytes, 1e19))) +
           " bytes, the memory limit is " + std::to_string(memory_limit_));
    }
    return BitsetGraph(num_vertices);
  }

  Index vertex(const BitsetGraph& graph, std::string_view word) const {
    const auto value = io::parse_index(word);
    if (!value || *value < 1 || *value > graph.num_vertices()) {
      fail(io::quoted(word) + " is no vertex from 1 to " + std::to_string(graph.num_vertices()));
    }
    return *value - 1;
  }

  void add_edge(BitsetGraph& graph, std::string_view first, std::string_view second) const {
    const Index u = vertex(graph, first);
    const Index v = vertex(graph, second);
    if (u != v) graph.add_edge(u, v);
  }

  void check_count(Index expected, Index read) const {
    if (read == expected) return;
    throw IoError(
        path_, 0,
        "truncated: " + std::to_string(read) + " of " + std::to_string(expected) + " edges");
  }

  void read_banner() {
    const auto line = reader_.next();
    const std::string banner = io::to_lower(line.value_or(""));
    const Words words = io::split_words(banner);
    if (words.size() != 5 || words[0] != "%%matrixmarket" || words[1] != "matrix") {
      fail("no MatrixMarket file: expected '%%MatrixMarket matrix coordinate ...'");
    }
    const bool is_pattern = words[3] == "pattern";
    if (words[2] != "coordinate" || (!is_pattern && words[3] != "real" && words[3] != "integer") ||
        (words[4] != "symmetric" && words[4] != "general")) {
      fail("expected coordinate, pattern or real or integer, symmetric or general");
    }
    words_per_entry_ = is_pattern ? 2 : 3;
  }

  const std::filesystem::path& path_;
  io::LineReader reader_;
  std::size_t memory_limit_;
  std::size_t words_per_entry_ = 2;
};

}  // namespace

BitsetGraph read_graph(const std::filesystem::path& path, std::size_t memory_limit) {
  const std::string extension = io::extension_of(path);
  const bool is_dimacs = extension == ".clq" || extension == ".col";
  if (!is_dimacs && extension != ".mtx") {
    throw IoError(path, 0, io::unknown_extension(extension, {".clq", ".col", ".mtx"}));
  }
  const std::string text = io::read_file(path);
  GraphFile file(path, text, memory_limit);
  return is_dimacs ? file.read_dimacs() : file.read_matrix_market();
}

void write_indices(const std::filesystem::path& path, std::span<const Index> indices) {
  std::string text;
  for (const Index index : indices) text += std::to_string(index) + '\n';
  io::write_file(path, text);
}

}  // namespace gmcr
