#include "proof/consensus_search.hpp"

#include <algorithm>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "clique/clique.hpp"

namespace gmcr::proof {
namespace {

/// Members for which pairs of the others are still tested: more cost more than they drop.
constexpr std::size_t kMaxKeptForPairs = 3;
/// Least-squares bounds in the time of a minimax fit.
constexpr std::uint64_t kWorkOfFit = 400;

std::vector<Index> without(const std::vector<Index>& members, const std::vector<Index>& removed) {
  std::vector<Index> rest;
  for (const Index i : members) {
    if (std::find(removed.begin(), removed.end(), i) == removed.end()) rest.push_back(i);
  }
  return rest;
}

std::vector<Index> indices_of(const std::vector<bool>& chosen) {
  std::vector<Index> indices;
  for (std::size_t v = 0; v < chosen.size(); ++v) {
    if (chosen[v]) indices.push_back(static_cast<Index>(v));
  }
  return indices;
}

}  // namespace

ConsensusSearch::ConsensusSearch(const geometry::CorrespondenceArrays& arrays,
                                 const BitsetGraph& graph, std::span<const double> weights,
                                 const ScaleRange& scales, TryPose try_pose, const Effort& effort)
    : graph_(graph),
      weights_(weights),
      try_pose_(std::move(try_pose)),
      deadline_(effort.deadline),
      work_left_(effort.work),
      sets_(arrays, scales) {}

double ConsensusSearch::run(double to_beat) {
  to_beat_ = to_beat;
  std::vector<Index> all(static_cast<std::size_t>(graph_.num_vertices()));
  std::iota(all.begin(), all.end(), Index{0});
  Node root;
  root.open = candidates(graph_, all, 0);  // before anything is copied: most are not
  if (is_over()) return std::max(to_beat_, weight_of(root.open));
  root.graph = clique::induced_subgraph(graph_, root.open);
  // best first: colourings then need fewer classes
  select_open(root, clique::core_order(root.graph));
  return search(root);
}

double ConsensusSearch::search(Node& node) {
  spend(1);
  drop_light(node);
  if (!node.kept.empty()) {
    drop_infeasible(node);
    drop_light(node);
  }
  if (!exceeds(node.kept_weight + weight_of(node.open))) return to_beat_;
  if (!node.kept.empty()) sort_by_fit(node);
  return branch(node);
}

double ConsensusSearch::branch(const Node& node) {
  std::vector<clique::Word> all(static_cast<std::size_t>(node.graph.words_per_row()), 0);
  clique::set_first_bits(all.data(), node.graph.num_vertices());
  // L5: a set that one pose holds has at most one member of each colour
  const clique::Colouring colouring = clique::colour_greedily(node.graph, all);
  if (colouring.num_colours == node.graph.num_vertices()) return resolve(node.kept, node.open);

  // bounds[k]: of the sets among the first k + 1 vertices of the order; a class costs its heaviest
  std::vector<double> bounds;
  double classes = node.kept_weight, heaviest = 0;
  for (std::size_t k = 0; k < colouring.order.size(); ++k) {
    if (k > 0 && colouring.colour[k] != colouring.colour[k - 1]) {
      classes += heaviest;
      heaviest = 0;
    }
    const Index i = node.open[static_cast<std::size_t>(colouring.order[k])];
    heaviest = std::max(heaviest, weights_[static_cast<std::size_t>(i)]);
    bounds.push_back(classes + heaviest);
  }
  double upper = to_beat_;
  for (std::size_t k = colouring.order.size(); k-- > 0 && exceeds(bounds[k]);) {
    if (is_over()) return std::max(upper, bounds[k]);
    Node next = child(node, {colouring.order.data(), k}, colouring.order[k]);
    upper = std::max(upper, std::min(bounds[k], search(next)));
  }
  return std::max(upper, to_beat_);
}

ConsensusSearch::Node ConsensusSearch::child(const Node& node, std::span<const Index> before,
                                             Index chosen) const {
  std::vector<Index> vertices;
  for (const Index v : before) {
    if (node.graph.has_edge(chosen, v)) vertices.push_back(v);
  }
  std::sort(vertices.begin(), vertices.end());
  Node next;
  next.graph = clique::induced_subgraph(node.graph, vertices);
  for (const Index v : vertices) next.open.push_back(node.open[static_cast<std::size_t>(v)]);
  const auto i = static_cast<std::size_t>(node.open[static_cast<std::size_t>(chosen)]);
  next.kept = node.kept;
  next.kept.push_back(static_cast<Index>(i));
  next.kept_weight = node.kept_weight + weights_[i];
  return next;
}

void ConsensusSearch::select_open(Node& node, const std::vector<Index>& vertices) const {
  node.graph = clique::induced_subgraph(node.graph, vertices);
  std::vector<Index> open;
  for (const Index v : vertices) open.push_back(node.open[static_cast<std::size_t>(v)]);
  node.open = std::move(open);
}

void ConsensusSearch::keep_open(Node& node, const std::vector<bool>& keep) const {
  const std::vector<Index> kept = indices_of(keep);
  if (kept.size() < node.open.size()) select_open(node, kept);
}

void ConsensusSearch::drop_light(Node& node) const {
  const std::vector<Index> kept = candidates(node.graph, node.open, node.kept_weight);
  if (kept.size() < node.open.size()) select_open(node, kept);
}

std::vector<Index> ConsensusSearch::candidates(const BitsetGraph& graph,
                                               const std::vector<Index>& open,
                                               double kept_weight) const {
  const std::size_t count = open.size();
  std::vector<double> around(count);  // all that a set with the vertex can weigh
  std::vector<bool> keep(count, true);
  std::vector<Index> too_light;
  const auto weight = [&](Index v) {
    return weights_[static_cast<std::size_t>(open[static_cast<std::size_t>(v)])];
  };
  const auto judge = [&](Index v) {
    const auto k = static_cast<std::size_t>(v);
    if (!keep[k] || exceeds(around[k])) return;
    keep[k] = false;
    too_light.push_back(v);
  };
  for (Index v = 0; v < static_cast<Index>(count); ++v) {
    if (is_over()) return indices_of(keep);
    double& sum = around[static_cast<std::size_t>(v)];
    sum = kept_weight + weight(v);
    const auto row = graph.row(v);
    clique::for_each_bit(row.data(), graph.words_per_row(), [&](Index u) { sum += weight(u); });
    judge(v);
  }
  for (std::size_t k = 0; k < too_light.size(); ++k) {
    const auto row = graph.row(too_light[k]);
    clique::for_each_bit(row.data(), graph.words_per_row(), [&](Index u) {
      around[static_cast<std::size_t>(u)] -= weight(too_light[k]);
      judge(u);
    });
  }
  return indices_of(keep);
}

void ConsensusSearch::drop_infeasible(Node& node) {
  if (node.kept.size() > kMaxKeptForPairs) return drop_infeasible_with_many(node);
  const auto num_kept = static_cast<double>(node.kept.size());
  const estimation::Moments kept =
      sets_.mean_moments(node.kept, Eigen::ArrayXd::Ones(static_cast<Index>(num_kept)));
  const auto open = [&](Index v) { return node.open[static_cast<std::size_t>(v)]; };
  if (node.kept.size() > 1) {
    spend(node.open.size());
    std::vector<bool> keep(node.open.size());
    for (Index v = 0; v < node.graph.num_vertices(); ++v) {
      keep[static_cast<std::size_t>(v)] =
          sets_.may_hold(kept, num_kept / (num_kept + 1), {open(v)});
    }
    keep_open(node, keep);
  }
  BitsetGraph graph(node.graph.num_vertices());
  for (Index v = 0; v < graph.num_vertices(); ++v) {
    if (is_over()) return;
    for (Index u = 0; u < v; ++u) {
      if (!node.graph.has_edge(u, v)) continue;
      spend(1);
      if (sets_.may_hold(kept, num_kept / (num_kept + 2), {open(u), open(v)})) {
        graph.add_edge(u, v);
      }
    }
  }
  node.graph = std::move(graph);
}

void ConsensusSearch::drop_infeasible_with_many(Node& node) {
  constexpr double kShares[] = {0.5, 0.75, 0.9};  // a few out of many that are valid
  spend(node.open.size() * std::size(kShares));
  const auto kept = sets_.minimax_moments(node.kept);
  std::vector<bool> keep(node.open.size(), false);
  for (std::size_t v = 0; kept && v < keep.size(); ++v) {
    keep[v] = std::all_of(std::begin(kShares), std::end(kShares), [&](double share) {
      return sets_.may_hold(*kept, share, {node.open[v]});
    });
  }
  keep_open(node, keep);
}

void ConsensusSearch::sort_by_fit(Node& node) const {
  // what fits worst is branched on first: it excludes much else, or is soon excluded
  std::vector<Index> all = node.kept;
  all.insert(all.end(), node.open.begin(), node.open.end());
  estimation::MinimaxFit fit = sets_.fit(all);
  if (!fit.step()) return;
  const auto num_kept = static_cast<Index>(node.kept.size());
  std::vector<Index> order(node.open.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return fit.residuals()[num_kept + a] < fit.residuals()[num_kept + b];
  });
  select_open(node, order);
}

double ConsensusSearch::resolve(const std::vector<Index>& kept, const std::vector<Index>& open) {
  const double weight = weight_of(kept) + weight_of(open);
  if (!exceeds(weight)) return to_beat_;
  if (is_over()) return weight;
  std::vector<Index> all = kept;
  all.insert(all.end(), open.begin(), open.end());
  const InfeasibleSets::Conflict conflict = find_conflict(all);
  if (conflict.pose) to_beat_ = std::max(to_beat_, try_pose_({*conflict.pose}));
  if (conflict.members.empty()) return std::max(to_beat_, weight);

  std::vector<Index> removable;
  for (const Index i : conflict.members) {
    if (std::find(open.begin(), open.end(), i) != open.end()) removable.push_back(i);
  }
  if (removable.empty()) return to_beat_;
  if (!exceeds(weight - loss_bound(kept, open, weight - to_beat_))) return to_beat_;
  double upper = to_beat_;
  std::vector<Index> fixed = kept, rest = open;
  for (const Index i : removable) {
    rest = without(rest, {i});
    upper = std::max(upper, resolve(fixed, rest));
    fixed.push_back(i);
  }
  return std::max(upper, to_beat_);
}

double ConsensusSearch::loss_bound(const std::vector<Index>& kept, std::vector<Index> open,
                                   double enough) {
  // conflicts that share no member that may go: each costs its lightest one
  double loss = 0;
  while (loss < enough && !is_over()) {
    std::vector<Index> all = kept;
    all.insert(all.end(), open.begin(), open.end());
    const std::vector<Index> members = find_conflict(all).members;
    const std::vector<Index> rest = without(open, members);
    if (members.empty()) break;
    if (rest.size() == open.size()) return enough;  // the kept ones alone exclude each other
    double lightest = std::numeric_limits<double>::infinity();
    for (const Index i : without(open, rest)) {
      lightest = std::min(lightest, weights_[static_cast<std::size_t>(i)]);
    }
    loss += lightest;
    open = rest;
  }
  return loss;
}

InfeasibleSets::Conflict ConsensusSearch::find_conflict(const std::vector<Index>& members) {
  spend(kWorkOfFit);
  return sets_.find_conflict(members);
}

double ConsensusSearch::weight_of(const std::vector<Index>& members) const {
  double sum = 0;
  for (const Index i : members) sum += weights_[static_cast<std::size_t>(i)];
  return sum;
}

}  // namespace gmcr::proof
