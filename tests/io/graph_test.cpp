#include <gtest/gtest.h>

#include "gmcr/io.hpp"
#include "io/expect_io_error.hpp"
#include "io/temporary_folder.hpp"

namespace gmcr::io {
namespace {

using test::TemporaryFolder;

constexpr std::size_t kLimit = 1 << 20;

class GraphText : public testing::Test {
 protected:
  BitsetGraph read(const std::string& name, const std::string& text) const {
    return read_graph(folder_.write(name, text), kLimit);
  }

  void expect_error(const std::string& name, const std::string& text, std::size_t line,
                    const std::string& words) const {
    const auto path = folder_.write(name, text);
    test::expect_io_error([&] { read_graph(path, kLimit); }, path, line, words);
  }

  TemporaryFolder folder_;
};

void expect_path_of_three(const BitsetGraph& graph) {
  EXPECT_EQ(graph.num_vertices(), 3);
  EXPECT_EQ(graph.num_edges(), 2);
  EXPECT_TRUE(graph.has_edge(0, 1));
  EXPECT_TRUE(graph.has_edge(2, 1));
}

TEST_F(GraphText, OfDimacsIsRead) {
  expect_path_of_three(read("a.clq", "c a path\nc\np edge 3 2\ne 1 2\ne 3 2\n"));
  expect_path_of_three(read("a.col", "p col 3 2\r\ne 2 1\r\ne 2 3\r\n"));
  expect_path_of_three(read("twice.col", "p edge 3 4\ne 2 1\ne 2 3\n"));
  expect_path_of_three(read("loop.clq", "p edge 3 4\ne 1 2\ne 2 1\ne 3 3\ne 3 2\n"));
}

TEST_F(GraphText, OfMatrixMarketIsRead) {
  expect_path_of_three(read(
      "a.mtx", "%%MatrixMarket matrix coordinate pattern symmetric\n% a path\n3 3 2\n2 1\n3 2\n"));
  expect_path_of_three(read(
      "a.mtx", "%%matrixmarket MATRIX coordinate real general\n3 3 3\n1 2 .5\n2 3 1e3\n3 3 7\n"));
}

TEST_F(GraphText, OfDimacsWithAnErrorNamesTheLine) {
  expect_error("a.clq", "c\ne 1 2\n", 2, "before the problem line");
  expect_error("a.clq", "p edge 3\n", 1, "'p edge VERTICES EDGES'");
  expect_error("a.clq", "p edge x 2\n", 1, "'x' is no count");
  expect_error("a.clq", "p edge 3 2\np edge 3 2\n", 2, "second problem line");
  expect_error("a.clq", "p edge 3 2\ne 1 4\n", 2, "'4' is no vertex from 1 to 3");
  expect_error("a.clq", "p edge 3 2\ne 0 1\n", 2, "'0' is no vertex");
  expect_error("a.clq", "p edge 3 2\ne 1\n", 2, "'e U V'");
  expect_error("a.clq", "p edge 3 2\nhello\n", 2, "'hello'");
  expect_error("a.clq", "p edge 5 5\ne 1 2\n", 0, "truncated: 1 of 5 edges");
  expect_error("a.clq", "c nothing else\n", 0, "no problem line");
}

TEST_F(GraphText, OfMatrixMarketWithAnErrorNamesTheLine) {
  const std::string banner = "%%MatrixMarket matrix coordinate pattern symmetric\n";
  expect_error("a.mtx", "3 3 2\n", 1, "no MatrixMarket file");
  expect_error("a.mtx", "%%MatrixMarket matrix array real general\n3 3\n", 1, "coordinate");
  expect_error("a.mtx", "%%MatrixMarket matrix coordinate complex general\n", 1, "pattern");
  expect_error("a.mtx", banner, 1, "'ROWS COLUMNS ENTRIES'");
  expect_error("a.mtx", banner + "3 4 2\n", 2, "not square");
  expect_error("a.mtx", banner + "3 3 2\n1 2\n1 2 3\n", 4, "expected 2 numbers");
  expect_error("a.mtx", banner + "3 3 2\n1 2\n", 0, "truncated: 1 of 2");
  expect_error("a.mtx", banner + "3 3 1\n1 2\n2 3\n", 4, "more entries");
  expect_error("a.mtx", banner + "3 3 1\n1 9\n", 3, "'9' is no vertex");
}

TEST_F(GraphText, ThatWouldNotFitTheMemoryLimitIsRefused) {
  expect_error("a.clq", "c\np edge 100000 1\ne 1 2\n", 2, "100000 vertices need 1250000000 bytes");
  expect_error("a.clq", "p edge 9000000000000000000 1\n", 1, "memory limit is 1048576");
  EXPECT_EQ(read("a.clq", "p edge 2048 1\ne 1 2\n").num_vertices(), 2048);
}

TEST_F(GraphText, OfAnotherKindIsRefused) {
  expect_error("a.clq", "", 0, "empty");
  expect_error("a.dot", "graph {}", 0, "unknown extension '.dot' (known: .clq, .col, .mtx)");
  const auto path = folder_ / "missing.mtx";
  test::expect_io_error([&] { read_graph(path, kLimit); }, path, 0, "No such file");
}

}  // namespace
}  // namespace gmcr::io
