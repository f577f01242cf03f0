#include "clique/search/local_search.hpp"

#include <random>

#include "clique/graph/complement.hpp"

namespace gmcr::clique {
namespace {

constexpr int kForcedCandidates = 4;
constexpr std::uint64_t kSeed = 0x9e3779b97f4a7c15;

class SwapSearch {
 public:
  SwapSearch(RowsView graph, std::span<const Index> clique)
      : graph_(graph),
        missing_(complement_lists(graph)),
        conflicts_(graph.num_vertices, 0),
        is_member_(graph.num_vertices, 0),
        left_at_(graph.num_vertices, 0),
        generator_(kSeed) {
    for (const Index v : clique) insert(v);
    for (Index v = 0; v < graph.num_vertices; ++v) {
      if (!is_member_[v] && conflicts_[v] == 0) insert(v);
    }
    for (Index v = 0; v < graph.num_vertices; ++v) {
      if (is_member_[v]) to_check_.push_back(v);
    }
    swap_while_possible();
    log_.clear();
  }

  std::vector<Index> run(Index max_work, SearchBudget& budget) {
    std::vector<Index> best = members();
    while (work_ < max_work && size_ < graph_.num_vertices) {
      const Index work_before = work_, size_before = size_;
      force_one();
      swap_while_possible();
      if (size_ < size_before) undo();
      log_.clear();
      if (size_ > static_cast<Index>(best.size())) best = members();
      if (!budget.spend_work(work_ - work_before)) break;
    }
    return best;
  }

 private:
  void insert(Index v) {
    is_member_[v] = 1;
    ++size_;
    work_ += 1 + static_cast<Index>(missing_[v].size());
    for (const std::int32_t u : missing_[v]) ++conflicts_[u];
    log_.push_back(v);
  }

  void remove(Index v) {
    is_member_[v] = 0;
    --size_;
    left_at_[v] = ++clock_;
    work_ += 1 + static_cast<Index>(missing_[v].size());
    for (const std::int32_t u : missing_[v]) --conflicts_[u];
    log_.push_back(v);
  }

  /// Each logged vertex entered or left; takes back the latest first.
  void undo() {
    for (std::vector<Index> log = std::move(log_); !log.empty(); log.pop_back()) {
      is_member_[log.back()] ? remove(log.back()) : insert(log.back());
    }
  }

  std::vector<Index> members() const {
    std::vector<Index> result;
    for (Index v = 0; v < graph_.num_vertices; ++v) {
      if (is_member_[v]) result.push_back(v);
    }
    return result;
  }

  /// Brings in the outsider that left longest ago among a few, and what then fits.
  void force_one() {
    Index forced = -1;
    for (int found = 0; found < kForcedCandidates;) {
      const Index v =
          static_cast<Index>(generator_() % static_cast<std::uint64_t>(graph_.num_vertices));
      ++work_;
      if (is_member_[v]) continue;
      ++found;
      if (forced < 0 || left_at_[v] < left_at_[forced]) forced = v;
    }
    for (const std::int32_t u : missing_[forced]) {
      if (is_member_[u]) take_out(u);
    }
    put_in(forced);
    fill();
  }

  void put_in(Index v) {
    insert(v);
    to_check_.push_back(v);
  }

  void take_out(Index v) {
    remove(v);
    freed_.push_back(v);
  }

  /// Inserts what has no conflict left around the vertices that went, then lists members to check.
  void fill() {
    for (const Index gone : freed_) {
      for (const std::int32_t u : missing_[gone]) {
        if (!is_member_[u] && conflicts_[u] == 0) put_in(u);
      }
      if (!is_member_[gone] && conflicts_[gone] == 0) put_in(gone);
    }
    for (const Index gone : freed_) {
      for (const std::int32_t u : missing_[gone]) {
        if (!is_member_[u] && conflicts_[u] == 1) to_check_.push_back(only_conflict(u));
      }
    }
    freed_.clear();
  }

  Index only_conflict(Index v) {
    for (const std::int32_t u : missing_[v]) {
      ++work_;
      if (is_member_[u]) return u;
    }
    return v;
  }

  void swap_while_possible() {
    while (!to_check_.empty()) {
      const Index v = to_check_.back();
      to_check_.pop_back();
      if (is_member_[v]) swap_for_two(v);
    }
  }

  void swap_for_two(Index v) {
    loose_.clear();
    for (const std::int32_t u : missing_[v]) {
      if (conflicts_[u] == 1) loose_.push_back(u);
    }
    work_ += static_cast<Index>(missing_[v].size());
    for (std::size_t i = 0; i < loose_.size(); ++i) {
      const Word* row = graph_.row(loose_[i]);
      for (std::size_t j = 0; j < i; ++j) {
        ++work_;
        if (!test_bit(row, loose_[j])) continue;
        const Index first = loose_[j], second = loose_[i];
        take_out(v);
        put_in(first);
        put_in(second);
        fill();
        return;
      }
    }
  }

  RowsView graph_;
  ComplementLists missing_;
  std::vector<std::int32_t> conflicts_;  // members that each vertex is not adjacent to
  std::vector<char> is_member_;
  std::vector<Index> left_at_;
  std::mt19937_64 generator_;
  std::vector<Index> log_, to_check_, freed_;
  std::vector<std::int32_t> loose_;
  Index size_ = 0, work_ = 0, clock_ = 0;
};

}  // namespace

std::vector<Index> improve_by_swaps(RowsView graph, std::span<const Index> clique, Index max_work,
                                    SearchBudget& budget) {
  return SwapSearch(graph, clique).run(max_work, budget);
}

}  // namespace gmcr::clique
