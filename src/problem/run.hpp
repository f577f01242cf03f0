#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "gmcr/clique.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"
#include "parallel/deadline.hpp"

namespace gmcr::problem {

/// What all stages of one solve share: the options, the time that is left, and the record of the
/// work.
class SolveContext {
 public:
  SolveContext(const Options& options, Diagnostics& diagnostics);

  const Options& options() const { return options_; }
  Diagnostics& diagnostics() { return diagnostics_; }

  const parallel::Deadline& deadline() const { return deadline_; }

  /// Whether the work has to end now; notes in the diagnostics which limit says so.
  bool stopped();

  /// Tells the caller how far a stage is; a caller may answer by stopping the solve.
  void report(const char* stage, double fraction);

  /// Notes a limit that made the work less than complete, once.
  void limit(const LimitHit& hit);

  /// What a clique search, by number or by weight, found and proved.
  struct Clique {
    std::vector<Index> vertices;  ///< empty: none exceeds what it must
    double upper_bound = 0;
    bool proven = false;
  };

  /// Maximum clique by the caller's solver or ours, within the time that is left.
  Clique max_clique(const BitsetGraph& graph, Index must_exceed, std::uint64_t max_nodes);

  /// Clique of maximum weight, within the time that is left.
  Clique max_weight_clique(const BitsetGraph& graph, std::span<const double> weights,
                           double must_exceed, std::uint64_t max_nodes);

  /// @throws std::invalid_argument where a graph of that size exceeds the memory budget.
  void require_memory_for_graph(Index num_vertices) const;

  void add_stage_time(const char* stage, double seconds);

 private:
  const Options& options_;
  Diagnostics& diagnostics_;
  parallel::Deadline deadline_;
  bool cancelled_ = false;
};

/// Reports the begin of a stage and adds the time of its own life to it.
class StageTimer {
 public:
  StageTimer(SolveContext& context, const char* stage) : context_(context), stage_(stage) {
    context.report(stage, 0);
  }
  ~StageTimer() { context_.add_stage_time(stage_, lifetime_.elapsed()); }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  SolveContext& context_;
  const char* stage_;
  parallel::Deadline lifetime_{0};
};

}  // namespace gmcr::problem
