#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>

#include "gmcr/types.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::clique {

/// Time, search nodes and work that a clique search may still spend.
class SearchBudget {
 public:
  static constexpr std::uint64_t kNoLimit = std::numeric_limits<std::uint64_t>::max();

  /// @param max_work  word operations; counted in steps of about 0.1 ms.
  SearchBudget(parallel::Deadline deadline, std::uint64_t max_nodes,
               std::uint64_t max_work = kNoLimit)
      : deadline_(std::move(deadline)), max_nodes_(max_nodes), max_work_(max_work) {}

  /// @param time_limit  seconds from now.
  SearchBudget(double time_limit, std::uint64_t max_nodes, std::uint64_t max_work = kNoLimit)
      : SearchBudget(parallel::Deadline(time_limit), max_nodes, max_work) {}

  /// Takes one search node that costs about `num_words` word operations.
  /// @return false where the budget is spent; from then on always.
  bool spend_node(Index num_words) {
    if (spent_ || nodes_ >= max_nodes_) return !(spent_ = true);
    ++nodes_;
    return spend_work(num_words);
  }

  /// Takes about `num_words` word operations; loops that may last call it now and then.
  /// @return false where the budget is spent; from then on always.
  bool spend_work(Index num_words) {
    words_since_poll_ += num_words;
    work_ += static_cast<std::uint64_t>(num_words);
    if (words_since_poll_ >= kWordsPerPoll) {
      words_since_poll_ = 0;
      spent_ = spent_ || work_ >= max_work_;
      out_of_time();
    }
    return !spent_;
  }

  /// Reads the clock.
  bool out_of_time() {
    out_of_time_ = out_of_time_ || deadline_.expired();
    spent_ = spent_ || out_of_time_;
    return spent_;
  }

  /// Leaves nothing.
  void spend_all() { spent_ = true; }

  /// A part of this budget: at most `max_nodes` nodes, the work left, the same deadline.
  SearchBudget part(std::uint64_t max_nodes) const {
    SearchBudget part(*this);
    part.max_nodes_ = max_nodes;
    part.max_work_ = work_left();
    part.nodes_ = part.work_ = 0;
    part.words_since_poll_ = 0;
    return part;
  }

  /// Takes what a part of it spent.
  void take(const SearchBudget& part) {
    nodes_ += part.nodes_;
    work_ += part.work();
    out_of_time_ = out_of_time_ || part.out_of_time_;
    spent_ = spent_ || out_of_time_;
  }

  std::uint64_t work() const { return work_; }  ///< word operations so far, about
  std::uint64_t work_left() const { return max_work_ - std::min(work_, max_work_); }
  std::uint64_t nodes_left() const { return max_nodes_ - nodes_; }
  bool spent() const { return spent_; }
  std::uint64_t nodes() const { return nodes_; }

 private:
  static constexpr Index kWordsPerPoll = Index{1} << 18;  // about 0.1 ms of work

  parallel::Deadline deadline_;
  std::uint64_t max_nodes_;
  std::uint64_t max_work_;
  std::uint64_t nodes_ = 0;
  std::uint64_t work_ = 0;
  Index words_since_poll_ = 0;
  bool spent_ = false;
  bool out_of_time_ = false;
};

}  // namespace gmcr::clique
