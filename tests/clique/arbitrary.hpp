#pragma once

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "clique/graphs.hpp"

namespace gmcr::test {

/// A value of [begin, end), the large ones as likely as the small ones from the first case on.
inline Index uniform_in(Index begin, Index end) {
  return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange<Index>(begin, end));
}

inline BitsetGraph arbitrary_graph(Index min_vertices, Index max_vertices, Index max_percent) {
  const Index n = uniform_in(min_vertices, max_vertices + 1);
  const double density = static_cast<double>(uniform_in(0, max_percent + 1)) / 100.0;
  return random_graph(n, density, *rc::gen::arbitrary<std::uint64_t>());
}

}  // namespace gmcr::test
