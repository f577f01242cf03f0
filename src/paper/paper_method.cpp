#include "paper/paper_method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "estimation/constrained_fit.hpp"
#include "paper/scale_consensus.hpp"
#include "problem/consistency_graph.hpp"
#include "proof/certificate.hpp"

namespace gmcr::paper {
namespace {

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// Bytes that a TIM takes while its scale is measured and swept.
constexpr std::size_t kBytesPerTim = sizeof(Pair) + 7 * sizeof(double) + 6 * sizeof(double);

/// The pairs that reach the rotation stage, their scale, and what bounds the consensus.
struct Pruned {
  Tims tims;
  double scale = 1;
  Index upper_bound = 0;
};

void require_memory_for_tims(const problem::SolveContext& context, Index num_correspondences) {
  const auto n = static_cast<std::size_t>(num_correspondences);
  const std::size_t bytes = n * (n - 1) / 2 * kBytesPerTim;
  if (bytes <= context.options().memory_limit) return;
  throw InvalidOption("memory_limit", std::to_string(context.options().memory_limit) +
                                          " bytes, but the scale stage of " +
                                          std::to_string(num_correspondences) +
                                          " correspondences takes " + std::to_string(bytes));
}

/// All pairs that the filter admits, in lexicographic order.
std::vector<Pair> admitted_pairs(Index num_correspondences, const ScaleRange& scales,
                                 const problem::PairFilter& filter) {
  std::vector<Pair> pairs = all_pairs(num_correspondences);
  if (!filter.is_empty()) {
    std::erase_if(pairs, [&](const Pair& pair) {
      return !filter.admits_pair(pair.first, pair.second, scales);
    });
  }
  return pairs;
}

/// Unknown scale: keep the pairs of the maximum clique of the scale consensus graph.
std::optional<Pruned> prune_by_scale(problem::SolveContext& context,
                                     const problem::Correspondences& correspondences,
                                     const ScaleRange& scales, const problem::PairFilter& filter) {
  const problem::StageTimer timer(context, "scale");
  require_memory_for_tims(context, correspondences.size());
  const Tims tims =
      make_tims(correspondences, admitted_pairs(correspondences.size(), scales, filter));
  if (context.stopped()) return std::nullopt;
  const auto consensus = scale_consensus(tims, scales);
  if (!consensus) return std::nullopt;
  return Pruned{select(tims, consensus->tims), consensus->scale,
                proof::max_members(static_cast<Index>(consensus->tims.size()))};
}

/// Known scale: keep the pairs within the maximum clique of the consistency graph (Parra et al.
/// 2019).
std::optional<Pruned> prune_by_consistency(problem::SolveContext& context,
                                           const problem::Correspondences& correspondences,
                                           double scale, const problem::PairFilter& filter) {
  const problem::StageTimer timer(context, "graph");
  BitsetGraph graph =
      problem::consistency_graph(problem::consistency_arrays(correspondences, scale),
                                 {scale, scale}, context.options().num_threads, context.deadline());
  filter.apply(graph, {scale, scale}, context.options().num_threads);
  const auto clique = context.max_clique(graph, 0, kUnlimited);
  const auto size = static_cast<Index>(clique.vertices.size());
  if (size < 2) return std::nullopt;
  require_memory_for_tims(context, size);
  std::vector<Pair> pairs;
  for (const auto [p, q] : all_pairs(size)) {
    pairs.push_back({clique.vertices[static_cast<std::size_t>(p)],
                     clique.vertices[static_cast<std::size_t>(q)]});
  }
  return Pruned{make_tims(correspondences, std::move(pairs)), scale,
                static_cast<Index>(clique.upper_bound)};
}

/// Where the rotation graph of all TIMs would not fit into the memory budget: the longest that do.
Tims within_memory(problem::SolveContext& context, Tims tims) {
  Index count = tims.size();
  const std::size_t budget = context.options().memory_limit;
  const std::size_t taken = std::min(budget / 2, static_cast<std::size_t>(count) * kBytesPerTim);
  while (BitsetGraph::bytes_required(count) > budget - taken) {
    count -= count / 16 + 1;
  }
  if (count == tims.size()) return tims;
  context.limit({Limit::Memory, "the memory budget let " + std::to_string(count) + " of " +
                                    std::to_string(tims.size()) +
                                    " pairs into the rotation graph, the longest ones"});
  std::vector<Index> order(static_cast<std::size_t>(tims.size()));
  std::iota(order.begin(), order.end(), Index{0});
  const Eigen::ArrayXd lengths = tims.source.colwise().squaredNorm();
  std::stable_sort(order.begin(), order.end(),
                   [&](Index k, Index l) { return lengths[k] > lengths[l]; });
  order.resize(static_cast<std::size_t>(count));
  std::sort(order.begin(), order.end());
  return select(tims, order);
}

}  // namespace

search::MethodResult solve_paper(problem::SolveContext& context,
                                 const problem::Correspondences& correspondences,
                                 const estimation::PoseConstraints& constraints,
                                 const problem::PairFilter& filter) {
  const ScaleRange& scales = constraints.scales;
  search::MethodResult result;
  result.upper_bound = correspondences.size();
  result.evidence_upper_bound = static_cast<double>(result.upper_bound);
  const auto pruned = scales.min == scales.max
                          ? prune_by_consistency(context, correspondences, scales.min, filter)
                          : prune_by_scale(context, correspondences, scales, filter);
  if (!pruned || context.stopped()) return result;
  result.upper_bound = std::min(result.upper_bound, pruned->upper_bound);
  result.evidence_upper_bound = static_cast<double>(result.upper_bound);
  const auto fit = [&](const std::vector<Index>& indices) {
    const auto pose =
        estimation::fit_pose(correspondences.source, correspondences.target, correspondences.bounds,
                             indices, estimation::at_scale(constraints, pruned->scale));
    if (pose) result.poses.push_back(*pose);
  };

  const Tims tims = within_memory(context, pruned->tims);
  const auto rotation = [&] {
    const problem::StageTimer timer(context, "rotation");
    return rotation_consensus(context, tims, pruned->scale, kUnlimited);
  }();
  if (!rotation) {
    // the TIMs are parallel: a pose that fits, one of many, so that the result can say so
    std::vector<Index> all(static_cast<std::size_t>(tims.size()));
    std::iota(all.begin(), all.end(), Index{0});
    fit(touched_correspondences(tims, all));
    return result;
  }

  const problem::StageTimer timer(context, "translation");
  const TranslationConsensus translation =
      translation_consensus(context, correspondences, touched_correspondences(tims, rotation->tims),
                            pruned->scale, rotation->rotation, kUnlimited);
  if (!rotation->proven || !translation.proven) {
    context.limit({Limit::CliqueSearch,
                   "the clique search of a rotation or translation graph ended before its proof"});
  }
  if (constraints.priors.admit_all()) {
    result.poses.push_back({pruned->scale, rotation->rotation, translation.translation});
  } else {
    // the stages know of the priors what single pairs say; the pose has to satisfy them
    fit(translation.correspondences);
  }
  return result;
}

}  // namespace gmcr::paper
