#include "registration/joint_search.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

#include "clique/bit_rows.hpp"
#include "clique/coloring.hpp"
#include "clique/degeneracy.hpp"
#include "clique/packed_graph.hpp"
#include "estimation/minimax_fit.hpp"

namespace gmcr {
namespace {

constexpr double kInfeasible = 1 + 1e-9;  // beyond the rounding of a mean of squares

/// Members for which pairs of the others are still tested: more cost more than they drop.
constexpr std::size_t kMaxKeptForPairs = 3;

Points columns(const Eigen::MatrixX3d& points, const std::vector<Index>& indices) {
  return points(indices, Eigen::all).transpose();
}

std::vector<Index> without(const std::vector<Index>& members, const std::vector<Index>& removed) {
  std::vector<Index> rest;
  for (const Index i : members) {
    if (std::find(removed.begin(), removed.end(), i) == removed.end()) rest.push_back(i);
  }
  return rest;
}

BitsetGraph unpack(const PackedGraph& packed) {
  BitsetGraph graph(packed.num_vertices());
  for (Index v = 0; v < packed.num_vertices(); ++v) {
    std::copy_n(packed.row(v), packed.words_per_row(), graph.mutable_row(v).begin());
  }
  return graph;
}

}  // namespace

JointSearch::JointSearch(const kernels::CorrespondenceArrays& arrays, const BitsetGraph& graph,
                         std::span<const double> weights, const ScaleRange& scales, Offer offer,
                         const Deadline& deadline)
    : arrays_(arrays),
      graph_(graph),
      weights_(weights),
      scales_(scales),
      offer_(std::move(offer)),
      deadline_(deadline),
      moments_(static_cast<std::size_t>(arrays.size())) {
  for (Index i = 0; i < arrays.size(); ++i) {
    moments_[static_cast<std::size_t>(i)] = point_moments(
        arrays.source.row(i), arrays.target.row(i), 1 / (arrays.bounds[i] * arrays.bounds[i]));
  }
}

double JointSearch::run(double to_beat) {
  to_beat_ = to_beat;
  // best first: colourings then need fewer classes
  std::vector<Index> order = degeneracy_order(graph_).order;
  std::reverse(order.begin(), order.end());
  Node root;
  root.open.resize(order.size());
  std::iota(root.open.begin(), root.open.end(), Index{0});
  root.graph = graph_;
  select_open(root, order);
  return search(root);
}

double JointSearch::search(Node& node) {
  drop_hopeless(node);
  if (!node.kept.empty()) {
    drop_misfits(node);
    drop_hopeless(node);
  }
  if (!exceeds(node.kept_weight + weight_of(node.open))) return to_beat_;
  if (!node.kept.empty()) sort_by_fit(node);
  return branch(node);
}

double JointSearch::branch(const Node& node) {
  std::vector<Word> all(static_cast<std::size_t>(node.graph.words_per_row()), 0);
  for (Index v = 0; v < node.graph.num_vertices(); ++v) set_bit(all.data(), v);
  const Coloring coloring = color_greedily(node.graph, all);
  if (coloring.num_colors == node.graph.num_vertices()) return resolve(node.kept, node.open);

  // bounds[k]: of the sets among the first k + 1 vertices of the order; a class costs its heaviest
  std::vector<double> bounds;
  double classes = node.kept_weight, heaviest = 0;
  for (std::size_t k = 0; k < coloring.order.size(); ++k) {
    if (k > 0 && coloring.color[k] != coloring.color[k - 1]) {
      classes += heaviest;
      heaviest = 0;
    }
    const Index i = node.open[static_cast<std::size_t>(coloring.order[k])];
    heaviest = std::max(heaviest, weights_[static_cast<std::size_t>(i)]);
    bounds.push_back(classes + heaviest);
  }
  double upper = to_beat_;
  for (std::size_t k = coloring.order.size(); k-- > 0 && exceeds(bounds[k]);) {
    if (deadline_.expired()) return std::max(upper, bounds[k]);
    Node next = child(node, {coloring.order.data(), k}, coloring.order[k]);
    upper = std::max(upper, std::min(bounds[k], search(next)));
  }
  return std::max(upper, to_beat_);
}

JointSearch::Node JointSearch::child(const Node& node, std::span<const Index> before,
                                     Index chosen) const {
  std::vector<bool> keep(node.open.size(), false);
  for (const Index v : before) {
    keep[static_cast<std::size_t>(v)] = node.graph.has_edge(chosen, v);
  }
  Node next = node;
  keep_open(next, keep);
  const auto i = static_cast<std::size_t>(node.open[static_cast<std::size_t>(chosen)]);
  next.kept.push_back(static_cast<Index>(i));
  next.kept_weight += weights_[i];
  return next;
}

void JointSearch::select_open(Node& node, const std::vector<Index>& vertices) const {
  PackedGraph packed;
  packed.assign(node.graph, vertices);
  node.graph = unpack(packed);
  std::vector<Index> open;
  for (const Index v : vertices) open.push_back(node.open[static_cast<std::size_t>(v)]);
  node.open = std::move(open);
}

void JointSearch::keep_open(Node& node, const std::vector<bool>& keep) const {
  std::vector<Index> kept;
  for (std::size_t v = 0; v < keep.size(); ++v) {
    if (keep[v]) kept.push_back(static_cast<Index>(v));
  }
  if (kept.size() < node.open.size()) select_open(node, kept);
}

void JointSearch::drop_hopeless(Node& node) const {
  const std::size_t count = node.open.size();
  std::vector<double> around(count);  // all that a set with the vertex can weigh
  std::vector<bool> keep(count, true);
  std::vector<Index> hopeless;
  const auto weight = [&](Index v) {
    return weights_[static_cast<std::size_t>(node.open[static_cast<std::size_t>(v)])];
  };
  const auto judge = [&](Index v) {
    const auto k = static_cast<std::size_t>(v);
    if (!keep[k] || exceeds(around[k])) return;
    keep[k] = false;
    hopeless.push_back(v);
  };
  for (Index v = 0; v < static_cast<Index>(count); ++v) {
    double& sum = around[static_cast<std::size_t>(v)];
    sum = node.kept_weight + weight(v);
    const auto row = node.graph.row(v);
    for_each_bit(row.data(), node.graph.words_per_row(), [&](Index u) { sum += weight(u); });
    judge(v);
  }
  for (std::size_t k = 0; k < hopeless.size(); ++k) {
    const auto row = node.graph.row(hopeless[k]);
    for_each_bit(row.data(), node.graph.words_per_row(), [&](Index u) {
      around[static_cast<std::size_t>(u)] -= weight(hopeless[k]);
      judge(u);
    });
  }
  if (!hopeless.empty()) keep_open(node, keep);
}

bool JointSearch::fit_jointly(const Moments& kept, double kept_share,
                              std::initializer_list<Index> others) const {
  Moments sum = kept * kept_share;
  for (const Index i : others) {
    sum += moments_[static_cast<std::size_t>(i)] *
           ((1 - kept_share) / static_cast<double>(others.size()));
  }
  return least_squares_bound(sum, scales_) <= kInfeasible;
}

void JointSearch::drop_misfits(Node& node) const {
  if (node.kept.size() > kMaxKeptForPairs) return drop_misfits_of_many(node);
  const auto num_kept = static_cast<double>(node.kept.size());
  const Moments kept = mean_moments(node.kept, Eigen::ArrayXd::Ones(static_cast<Index>(num_kept)));
  const auto open = [&](Index v) { return node.open[static_cast<std::size_t>(v)]; };
  if (node.kept.size() > 1) {
    std::vector<bool> keep(node.open.size());
    for (Index v = 0; v < node.graph.num_vertices(); ++v) {
      keep[static_cast<std::size_t>(v)] = fit_jointly(kept, num_kept / (num_kept + 1), {open(v)});
    }
    keep_open(node, keep);
  }
  BitsetGraph graph(node.graph.num_vertices());
  for (Index v = 0; v < graph.num_vertices(); ++v) {
    if (deadline_.expired()) return;
    for (Index u = 0; u < v; ++u) {
      if (!node.graph.has_edge(u, v)) continue;
      if (fit_jointly(kept, num_kept / (num_kept + 2), {open(u), open(v)})) graph.add_edge(u, v);
    }
  }
  node.graph = std::move(graph);
}

void JointSearch::drop_misfits_of_many(Node& node) const {
  // minimax weights of the kept ones bring their mean close to the limit, so that one misfit more
  // exceeds it; the shares are a few out of many that are valid
  constexpr int kSteps = 20;
  constexpr double kShares[] = {0.5, 0.75, 0.9};
  MinimaxFit fit = fit_of(node.kept);
  Eigen::ArrayXd weights = fit.weights();
  for (int step = 0; step < kSteps; ++step) {
    weights = fit.weights();
    if (!fit.step()) break;
    if (fit.lower_bound() > kInfeasible) return keep_open(node, {});
  }
  const Moments kept = mean_moments(node.kept, weights);
  std::vector<bool> keep(node.open.size());
  for (std::size_t v = 0; v < keep.size(); ++v) {
    keep[v] = std::all_of(std::begin(kShares), std::end(kShares),
                          [&](double share) { return fit_jointly(kept, share, {node.open[v]}); });
  }
  keep_open(node, keep);
}

Moments JointSearch::mean_moments(const std::vector<Index>& members,
                                  const Eigen::ArrayXd& weights) const {
  Moments sum;
  for (std::size_t k = 0; k < members.size(); ++k) {
    sum += moments_[static_cast<std::size_t>(members[k])] *
           (weights[static_cast<Index>(k)] / weights.sum());
  }
  return sum;
}

MinimaxFit JointSearch::fit_of(const std::vector<Index>& members) const {
  return MinimaxFit(columns(arrays_.source, members), columns(arrays_.target, members),
                    arrays_.bounds(members), PoseConstraints{scales_});
}

void JointSearch::sort_by_fit(Node& node) const {
  // what fits worst is branched on first: it excludes much else, or is soon excluded
  std::vector<Index> all = node.kept;
  all.insert(all.end(), node.open.begin(), node.open.end());
  MinimaxFit fit = fit_of(all);
  if (!fit.step()) return;
  const auto num_kept = static_cast<Index>(node.kept.size());
  std::vector<Index> order(node.open.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) {
    return fit.residuals()[num_kept + a] < fit.residuals()[num_kept + b];
  });
  select_open(node, order);
}

double JointSearch::resolve(const std::vector<Index>& kept, const std::vector<Index>& open) {
  const double weight = weight_of(kept) + weight_of(open);
  if (!exceeds(weight)) return to_beat_;
  if (deadline_.expired()) return weight;
  std::vector<Index> all = kept;
  all.insert(all.end(), open.begin(), open.end());
  const Conflict conflict = find_conflict(all);
  if (conflict.pose) to_beat_ = std::max(to_beat_, offer_(*conflict.pose));
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

double JointSearch::loss_bound(const std::vector<Index>& kept, std::vector<Index> open,
                               double enough) const {
  // conflicts that share no member that may go: each costs its lightest one
  double loss = 0;
  while (loss < enough) {
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

JointSearch::Conflict JointSearch::find_conflict(const std::vector<Index>& members) const {
  constexpr int kMaxSteps = 200;
  constexpr std::array<std::size_t, 8> kSizes{4, 5, 6, 7, 8, 10, 14, 20};
  const auto settle = [&](const std::vector<Index>& some, auto&& fit) {
    for (int step = 0; step < kMaxSteps; ++step) {
      if (!fit.step() || fit.residuals().maxCoeff() <= 1 || fit.lower_bound() > kInfeasible) break;
    }
    return some.size() >= 3 && fit.lower_bound() > kInfeasible;
  };
  MinimaxFit fit = fit_of(members);
  if (!settle(members, fit)) {
    const bool holds = members.size() >= 3 && fit.residuals().maxCoeff() <= 1;
    return {{}, holds ? std::optional(fit.pose()) : std::nullopt};
  }
  std::vector<Index> order(members.size());
  std::iota(order.begin(), order.end(), Index{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](Index a, Index b) { return fit.weights()[a] > fit.weights()[b]; });
  for (const std::size_t size : kSizes) {
    if (size >= members.size()) break;
    std::vector<Index> few;
    for (std::size_t k = 0; k < size; ++k)
      few.push_back(members[static_cast<std::size_t>(order[k])]);
    if (settle(few, fit_of(few))) return {few, std::nullopt};
  }
  std::vector<Index> all;
  for (const Index k : order) all.push_back(members[static_cast<std::size_t>(k)]);
  return {all, std::nullopt};
}

double JointSearch::weight_of(const std::vector<Index>& members) const {
  double sum = 0;
  for (const Index i : members) sum += weights_[static_cast<std::size_t>(i)];
  return sum;
}

}  // namespace gmcr
