#include "problem/graph/graph_rows.hpp"

#include <gtest/gtest.h>

namespace gmcr::problem {
namespace {

TEST(GraphFromRows, IsTheMemoryThatTheRowsWereWrittenTo) {
  const std::uint64_t* first = nullptr;
  const BitsetGraph graph =
      graph_from_rows(3, 1, parallel::Deadline::never(), [&](Index v, auto row) {
        if (v == 0) first = row.data();
        row[0] = 0b111 & ~(std::uint64_t{1} << v);
      });
  EXPECT_EQ(graph.row(0).data(), first);  // a copy would double the memory
  EXPECT_EQ(graph.num_edges(), 3);
}

TEST(GraphFromRows, HasNoEdgesWhereTheTimeIsUp) {
  for (const Index num_vertices : {3, 1000}) {
    const BitsetGraph graph = graph_from_rows(num_vertices, 2, parallel::Deadline(0),
                                              [](Index, auto row) { row[0] = ~0ull; });
    EXPECT_EQ(graph.num_vertices(), num_vertices);
    EXPECT_EQ(graph.num_edges(), 0);
  }
}

}  // namespace
}  // namespace gmcr::problem
