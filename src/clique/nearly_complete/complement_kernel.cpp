#include "clique/nearly_complete/complement_kernel.hpp"

#include "clique/graph/complement.hpp"

namespace gmcr::clique {
namespace {

constexpr Index kMaxDegreeToDominate = 64;  // the test is quadratic in it

class Reduction {
 public:
  Reduction(RowsView graph, SearchBudget& budget)
      : graph_(graph),
        budget_(budget),
        missing_(complement_lists(graph)),
        alive_(graph.num_vertices, 1),
        queued_(graph.num_vertices, 1),
        queue_(graph.num_vertices) {
    for (Index v = 0; v < graph.num_vertices; ++v) queue_[v] = v;
  }

  ComplementKernel run() {
    for (std::size_t next = 0; next < queue_.size() && !budget_.spent(); ++next) {
      const Index v = queue_[next];
      queued_[v] = 0;
      if (alive_[v]) drop_dominated_by(v);
    }
    return kernel();
  }

 private:
  /// Lists lose their dead entries when they are read.
  std::vector<std::int32_t>& live_missing(Index v) {
    std::erase_if(missing_[v], [&](std::int32_t w) { return !alive_[w]; });
    return missing_[v];
  }

  void drop_dominated_by(Index v) {
    const std::vector<std::int32_t>& rivals = live_missing(v);
    const Index degree = static_cast<Index>(rivals.size());
    if (degree > kMaxDegreeToDominate) return;
    budget_.spend_work(degree * degree);
    std::vector<std::int32_t> dropped;
    for (const std::int32_t w : rivals) {
      const Word* row = graph_.row(w);
      const bool dominated = std::all_of(rivals.begin(), rivals.end(), [&](std::int32_t u) {
        return u == w || !alive_[u] || !test_bit(row, u);
      });
      if (!dominated) continue;
      alive_[w] = 0;
      dropped.push_back(w);
    }
    for (const std::int32_t w : dropped) {
      for (const std::int32_t u : missing_[w]) enqueue(u);
    }
  }

  void enqueue(Index v) {
    if (!alive_[v] || queued_[v]) return;
    queued_[v] = 1;
    queue_.push_back(v);
  }

  ComplementKernel kernel() {
    ComplementKernel result;
    std::vector<char> reached(graph_.num_vertices, 0);
    for (Index v = 0; v < graph_.num_vertices; ++v) {
      if (!alive_[v] || reached[v]) continue;
      std::vector<Index> part{v};
      reached[v] = 1;
      for (std::size_t i = 0; i < part.size(); ++i) {
        for (const std::int32_t u : live_missing(part[i])) {
          if (!reached[u]) part.push_back(u);
          reached[u] = 1;
        }
      }
      if (part.size() == 1) {
        result.taken.push_back(v);
      } else {
        std::sort(part.begin(), part.end());
        result.parts.push_back(std::move(part));
      }
    }
    return result;
  }

  RowsView graph_;
  SearchBudget& budget_;
  ComplementLists missing_;
  std::vector<char> alive_, queued_;
  std::vector<Index> queue_;
};

}  // namespace

ComplementKernel reduce_by_complement(RowsView graph, SearchBudget& budget) {
  return Reduction(graph, budget).run();
}

}  // namespace gmcr::clique
