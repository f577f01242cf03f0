#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <stop_token>
#include <vector>

#include "gmcr/bitset_graph.hpp"
#include "gmcr/types.hpp"
#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// How a clique search may end early and what it may start from.
struct CliqueOptions {
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds, >= 0
  std::uint64_t max_nodes =
      std::numeric_limits<std::uint64_t>::max();  ///< search nodes, never exceeded; deterministic
  /// Word operations, about, of the search and of what prepares it; deterministic. 2^30 take about
  /// a second.
  std::uint64_t max_work = std::numeric_limits<std::uint64_t>::max();
  std::vector<Index> initial_clique;  ///< known clique to start from; may be empty
  /// Report only a clique with more vertices than this; 0 reports any. A search that proves that
  /// there is none returns the best clique it met (maybe none) and `upper_bound` <= this value.
  Index must_exceed = 0;
  int num_threads = 0;  ///< 0 ... 1024; 0 uses every core. The result is the same for any number.
  /// Bytes for copies of large parts of the graph; where they do not suffice, it is searched in
  /// place, which takes longer and may bound less tightly.
  std::size_t max_memory = std::numeric_limits<std::size_t>::max();
  std::stop_token stop;  ///< a request, from any thread, ends the search as if its time were up

  /// @throws std::invalid_argument naming field and value.
  void validate() const;
};

/// What a clique search found and proved.
struct CliqueResult {
  std::vector<Index> vertices;  ///< ascending; a clique of the graph
  Index upper_bound = 0;        ///< proven: no clique is larger; valid also after an early end
  bool proven_optimal = false;  ///< upper_bound <= max(vertices.size(), must_exceed)
  std::uint64_t nodes = 0;      ///< search nodes visited
};

/// Maximum clique of `graph`, exact unless a limit of `options` binds.
///
/// Bounds from cheap to costly, each of which may settle it: degrees, greedy cliques from vertices
/// of high degree, a filter by degrees among what is left, a colouring seeded with the best clique,
/// core numbers with more greedy cliques. Then branch and bound over bit rows on the vertices that
/// a colouring leaves over (Tomita and Seki 2003; San Segundo et al. 2011), one neighbourhood after
/// the other, with re-colouring (Tomita et al. 2010) and conflicts of classes by unit propagation
/// (Li and Quan 2010). Nearly complete graphs are first reduced and split on their complement and
/// their clique improved by swaps.
/// Deterministic: the same graph and options without a time limit give the same vertices, bound and
/// number of nodes, for any number of threads and any instruction set. A search that takes less
/// than milliseconds starts no threads.
/// @throws std::invalid_argument where an option is out of range or `initial_clique` is no clique.
/// Cost O(E + n^2 / 64) before the search, plus up to 20 greedy cliques; exponential in the worst
/// case, so set a limit for unknown graphs. Memory: a copy of the vertices that the bounds leave
/// over (none above 64 MiB where these are most of the graph), and up to 256 MiB for the
/// neighbourhoods that are searched at a time.
CliqueResult max_clique(const BitsetGraph& graph, const CliqueOptions& options = {});

/// How a search for a clique of maximum weight may end early.
struct WeightedCliqueOptions {
  double time_limit = std::numeric_limits<double>::infinity();  ///< seconds, >= 0
  std::uint64_t max_nodes =
      std::numeric_limits<std::uint64_t>::max();  ///< search nodes; deterministic
  /// As in `CliqueOptions`. What may take more for its first colouring alone is not begun.
  std::uint64_t max_work = std::numeric_limits<std::uint64_t>::max();
  /// Bytes for copies of parts of the graph; what needs more is not searched, only bounded.
  std::size_t max_memory = std::numeric_limits<std::size_t>::max();
  /// Report only a clique that weighs more than this, >= 0; 0 reports any. As in `CliqueOptions`,
  /// a search that proves that there is none may return none or a lighter one.
  double must_exceed = 0;
  int num_threads = 0;   ///< 0 ... 1024; 0 uses every core. The result is the same for any number.
  std::stop_token stop;  ///< as in `CliqueOptions`

  /// @throws std::invalid_argument naming field and value.
  void validate() const;
};

/// What a search for a clique of maximum weight found and proved.
struct WeightedCliqueResult {
  std::vector<Index> vertices;  ///< ascending; a clique of the graph
  double weight = 0;            ///< sum of the weights of `vertices`, in that order
  double upper_bound = 0;       ///< proven: no clique weighs more; valid also after an early end
  bool proven_optimal = false;  ///< upper_bound <= max(weight, must_exceed) but for rounding
  std::uint64_t nodes = 0;      ///< search nodes visited
};

/// Clique of maximum weight, exact unless a limit of `options` binds.
///
/// Bounds from cheap to costly, each of which may settle it: a weighted colouring, whose classes
/// cost their heaviest vertex; the weight of each neighbourhood, peeled like a core; greedy cliques
/// from the heaviest neighbourhoods. Then branch and bound, one neighbourhood after the other, with
/// colourings that split a vertex over several classes (Held, Cook and Sewell 2012; Tavares et al.
/// 2015). Where all weights are equal it is `max_clique`.
///
/// Rounding: sums are taken in whole numbers of a unit, at most 2^-60 of the sum of all weights, to
/// which weights round up, so `upper_bound` is never too low. Cliques whose weights differ by less
/// than 1e-12 of them count as equally heavy, and `upper_bound` then includes this margin. Where
/// sums of the weights do not round in double (whole numbers, halves, ...), there is no margin and
/// `upper_bound` equals the weight of a proven maximum.
/// @param weights  one a vertex, >= 0, finite, with a finite sum. Vertices that weigh 0 are never
///                 part of the result.
/// @throws std::invalid_argument where an option is out of range or the weights do not fit.
/// Deterministic as `max_clique`. Cost O(E + n^2 / 64) before the search, plus 16 greedy cliques, 2
/// where there is a weight to exceed; exponential in the worst case, so set a limit for unknown
/// graphs. Memory: up to two copies of the part of the graph that the bounds leave over.
WeightedCliqueResult max_weight_clique(const BitsetGraph& graph, std::span<const double> weights,
                                       const WeightedCliqueOptions& options = {});

/// A maximum clique solver that the registration can be told to use instead of `max_clique`.
class CliqueSolver {
 public:
  virtual ~CliqueSolver() = default;

  /// Same contract as `max_clique`; called from one thread at a time.
  virtual CliqueResult solve(const BitsetGraph& graph, const CliqueOptions& options) const = 0;
};

}  // namespace gmcr
