#include "clique/search/root_search.hpp"

#include "clique/graph/colouring.hpp"
#include "clique/search/local_search.hpp"
#include "parallel/parallel_for.hpp"

namespace gmcr::clique {
namespace {

// Subproblems searched at a time: enough for many threads, few enough that the first ones, which
// have the largest bounds, are done soon.
constexpr std::size_t kMaxActive = 16;
constexpr Index kMaxWordsOfActive = Index{1} << 25;  // 256 MiB for their neighbourhoods
// Word operations of a subproblem between two rounds, doubled from round to round up to about 0.05
// s.
constexpr Index kFirstWorkPerRound = Index{1} << 20, kMaxWorkPerRound = Index{1} << 24;
constexpr Index kMinNodesPerRound = 16;
// Rounds of less work than this take less time than starting threads.
constexpr std::uint64_t kMinWorkForThreads = std::uint64_t{1} << 19;

// Swaps improve the clique of a graph this dense in about a millisecond, which saves a part of a
// search that takes longer.
constexpr double kMinDensityToSwap = 0.6;
constexpr Index kMaxVerticesToSwap = 2000;
constexpr Index kSwapWork = Index{1} << 19;
constexpr std::uint64_t kMinWorkToSwap = std::uint64_t{1} << 21;

}  // namespace

Index RootSearch::run() {
  branches_ = packed_ ? choose_branches() : branches_by_colouring();
  alive_ = hopeful_vertices();
  known_size_ = incumbent_.to_beat();
  const Index words_each = 3 * graph_.num_vertices * graph_.words_per_row + 1;
  const std::size_t max_active =
      std::clamp<std::size_t>(kMaxWordsOfActive / words_each, 1, kMaxActive);

  // Rounds: all subproblems of a round see the same clique to beat, whatever the threads. The first
  // rounds are small, as they may find better cliques and settle easy graphs.
  std::size_t num_active = 1;
  work_each_ = kFirstWorkPerRound;
  std::uint64_t last_work = 0;
  const std::uint64_t work_at_start = budget_.work();
  while (true) {
    if (!fill(num_active)) break;
    if (active_.empty()) return incumbent_.to_beat();
    const std::uint64_t work_before = budget_.work();
    advance_all(last_work < kMinWorkForThreads ? 1 : num_threads_);
    last_work = budget_.work() - work_before;
    if (budget_.spent()) break;
    if (!has_swapped_ && budget_.work() - work_at_start > kMinWorkToSwap) improve_clique();
    num_active = std::min(2 * num_active, max_active);
    work_each_ = std::min(2 * work_each_, kMaxWorkPerRound);
  }
  Index bound = incumbent_.to_beat();
  if (!branches_.empty()) bound = std::max<Index>(bound, branches_.back().bound);
  for (const auto& subproblem : active_) bound = std::max(bound, subproblem->upper_bound());
  return bound;
}

bool RootSearch::fill(std::size_t num_active) {
  if (incumbent_.to_beat() > known_size_) {
    known_size_ = incumbent_.to_beat();
    drop_light(alive_);
  }
  std::vector<Word> candidates(graph_.words_per_row);
  while (active_.size() < num_active && !branches_.empty()) {
    const auto [v, bound] = branches_.back();
    if (bound <= incumbent_.to_beat()) {  // bounds ascend: so are all before
      branches_.clear();
      return true;
    }
    if (test_bit(alive_.data(), v)) {
      if (!budget_.spend_node(graph_.words_per_row)) return false;
      clear_bit(alive_.data(), v);
      const Word* row = graph_.row(v);
      for (Index w = 0; w < graph_.words_per_row; ++w) candidates[w] = alive_[w] & row[w];
      if (idle_.empty()) idle_.push_back(std::make_unique<Subproblem>());
      active_.push_back(std::move(idle_.back()));
      idle_.pop_back();
      active_.back()->assign(graph_, v, bound, candidates);
    }
    branches_.pop_back();
  }
  return true;
}

void RootSearch::advance_all(int num_threads) {
  const Index count = static_cast<Index>(active_.size());
  const std::uint64_t share = budget_.nodes_left() / active_.size();
  const std::uint64_t num_larger = budget_.nodes_left() % active_.size();
  std::vector<SearchBudget> parts;
  for (Index i = 0; i < count; ++i) {
    const Index nodes_per_round = kMinNodesPerRound + work_each_ / active_[i]->words_per_node();
    parts.push_back(
        budget_.part(std::min<std::uint64_t>(share + (static_cast<std::uint64_t>(i) < num_larger),
                                             static_cast<std::uint64_t>(nodes_per_round))));
  }
  const Index to_beat = incumbent_.to_beat();
  parallel::parallel_for(count, 1, num_threads,
                         [&](Index i, Index) { active_[i]->advance(to_beat, parts[i]); });
  std::vector<std::unique_ptr<Subproblem>> unfinished;
  for (Index i = 0; i < count; ++i) {
    budget_.take(parts[i]);
    incumbent_.offer(active_[i]->clique());
    (active_[i]->finished() ? idle_ : unfinished).push_back(std::move(active_[i]));
  }
  active_ = std::move(unfinished);
  if (!active_.empty() && (budget_.nodes_left() == 0 || budget_.work_left() == 0))
    budget_.spend_all();
}

void RootSearch::improve_clique() {
  has_swapped_ = true;
  const Index n = graph_.num_vertices;
  if (n > kMaxVerticesToSwap) return;
  const auto ends = static_cast<double>(graph_.num_edge_ends());
  if (ends < kMinDensityToSwap * static_cast<double>(n * (n - 1))) return;
  incumbent_.offer(improve_by_swaps(graph_, incumbent_.clique(), kSwapWork, budget_));
}

std::vector<Branch> RootSearch::choose_branches() {
  const kernels::AlignedWords alive = hopeful_vertices();
  BranchSelector selector;
  selector.reset(*packed_);
  std::vector<Branch> seeded, plain;
  selector.select(alive.data(), incumbent_.to_beat(), budget_, seeded, incumbent_.clique());
  if (seeded.empty() || budget_.spent()) return seeded;
  selector.select(alive.data(), incumbent_.to_beat(), budget_, plain);
  return plain.size() < seeded.size() ? plain : seeded;
}

std::vector<Branch> RootSearch::branches_by_colouring() {
  const kernels::AlignedWords alive = hopeful_vertices();
  const Colouring colouring = colour_greedily(graph_, alive, incumbent_.clique(), &budget_);
  std::vector<Branch> branches;
  for (std::size_t i = 0; i < colouring.order.size(); ++i) {
    if (colouring.colour[i] < incumbent_.to_beat()) continue;
    branches.push_back({static_cast<std::int32_t>(colouring.order[i]),
                        static_cast<std::int32_t>(colouring.colour[i] + 1)});
  }
  return branches;
}

kernels::AlignedWords RootSearch::hopeful_vertices() const {
  kernels::AlignedWords vertices(graph_.words_per_row, 0);
  set_first_bits(vertices.data(), graph_.num_vertices);
  drop_light(vertices);
  return vertices;
}

void RootSearch::drop_light(std::span<Word> vertices) const {
  for (Index v = 0; v < graph_.num_vertices; ++v) {
    if (core_[v] < incumbent_.to_beat()) clear_bit(vertices.data(), v);
  }
}

}  // namespace gmcr::clique
