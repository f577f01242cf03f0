#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gmcr/clique.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "parallel/deadline.hpp"
#include "parallel/stopwatch.hpp"

namespace gmcr::problem {

/// What all stages of one solve share: the options, the time that is left, and the record of the
/// work.
class Run {
 public:
  /// Starts the clock. Keeps the reference.
  explicit Run(const Options& options);

  const Options& options() const { return options_; }
  Diagnostics& diagnostics() { return diagnostics_; }
  const Diagnostics& diagnostics() const { return diagnostics_; }

  const parallel::Deadline& deadline() const { return deadline_; }

  /// Whether the work has to end now; notes in the diagnostics which limit says so.
  bool stopped();

  /// Whether the caller does not want to wait any more.
  bool cancelled() const { return cancelled_ || options_.stop.stop_requested(); }

  /// The same as `stopped`, without a note.
  bool has_ended() const { return cancelled() || deadline_.expired(); }

  /// Tells the caller how far a stage is; a caller may answer by stopping the solve.
  void report(const char* stage, double fraction);

  /// Notes a limit that made the work less than complete, once.
  void limit(const LimitHit& hit);

  /// What a clique search, by number or by weight, found and proved.
  struct Clique {
    std::vector<Index> vertices;  ///< empty: none exceeds what it must
    double upper_bound = 0;       ///< what it must exceed, where it is proven that none does
    bool proven = false;
    std::uint64_t nodes = 0;
  };

  /// Maximum clique by the caller's solver or ours, within the time that is left.
  Clique max_clique(const BitsetGraph& graph, Index must_exceed, std::uint64_t max_nodes);

  /// The same, untold to the diagnostics; by our solver several threads may search at once, each on
  /// up to `num_threads`.
  Clique find_max_clique(const BitsetGraph& graph, Index must_exceed, std::uint64_t max_nodes,
                         int num_threads) const;

  /// Clique of maximum weight, likewise.
  Clique find_max_weight_clique(const BitsetGraph& graph, std::span<const double> weights,
                                double must_exceed, std::uint64_t max_nodes, int num_threads) const;

  /// Tells the diagnostics of a clique search, and of the limit of time that ended it.
  void note(const Clique& clique);

  /// Vertices of the largest graph that the memory budget takes.
  Index num_in_memory() const;

  /// @throws std::invalid_argument where a graph of that size exceeds the memory budget.
  void require_memory_for_graph(Index num_vertices) const;

  /// Adds the counts and the times of work on a part of the problem.
  void add_work(const Diagnostics& part);

  void add_stage_time(const char* stage, double seconds);

  /// The record so far, with the time since the start.
  Diagnostics record() const;

 private:
  const Options& options_;
  Diagnostics diagnostics_;
  parallel::Deadline deadline_;
  parallel::Stopwatch clock_;
  bool cancelled_ = false;
};

/// What a solve says where memory or time does not suffice for the graph of all correspondences.
LimitHit search_of_a_sample(Limit limit);

/// What it says of evidence then.
LimitHit evidence_counted();

/// What a solve says where distinct evidence does not fit into its share of the memory.
LimitHit weights_incomplete();

/// Reports the begin of a stage and adds the time of its own life to it.
class StageTimer {
 public:
  StageTimer(Run& run, const char* stage) : run_(run), stage_(stage) {
    run.report(stage, 0);
    run.add_stage_time(stage, 0);  // makes its row now: the destructor must not allocate
  }
  ~StageTimer() { run_.add_stage_time(stage_, lifetime_.elapsed()); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  Run& run_;
  const char* stage_;
  parallel::Stopwatch lifetime_;
};

}  // namespace gmcr::problem
