#include "paper/paper_method.hpp"

#include <algorithm>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

#include "estimation/fits/constrained_fit.hpp"
#include "paper/rotation_consensus.hpp"
#include "paper/scale_consensus.hpp"
#include "paper/translation_consensus.hpp"
#include "problem/graph/consistency_graph.hpp"

namespace gmcr::paper {
namespace {

using problem::Problem;
using problem::Run;
using problem::StageTimer;

constexpr std::uint64_t kUnlimited = std::numeric_limits<std::uint64_t>::max();

/// Bytes that a TIM takes while its scale is measured and swept.
constexpr std::size_t kBytesPerTim = sizeof(Pair) + 7 * sizeof(double) + 6 * sizeof(double);

/// The pairs that reach the rotation stage, their scale, and what bounds the consensus.
struct Pruned {
  Tims tims;
  double scale = 1;
  Index upper_bound = 0;
};

void require_memory_for_tims(const Run& run, Index num_correspondences) {
  const auto n = static_cast<std::size_t>(num_correspondences);
  const std::size_t bytes = n * (n - 1) / 2 * kBytesPerTim;
  if (bytes <= run.options().memory_limit) return;
  throw InvalidOption("memory_limit", std::to_string(run.options().memory_limit) +
                                          " bytes, but the scale stage of " +
                                          std::to_string(num_correspondences) +
                                          " correspondences takes " + std::to_string(bytes));
}

/// Whether the time is far from sufficing for the scales of all pairs, whose stage looks at no
/// clock.
bool exceeds_time(const Run& run, Index num_correspondences) {
  constexpr double kSecondsPerTim = 9e-8, kFarBeyond = 2;
  const auto n = static_cast<double>(num_correspondences);
  return kSecondsPerTim * n * n / 2 > kFarBeyond * run.options().time_limit;
}

std::vector<Index> all_of(const Problem& problem) {
  std::vector<Index> all(static_cast<std::size_t>(problem.size()));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

/// All pairs of the given correspondences.
std::vector<Pair> pairs_of(const std::vector<Index>& members) {
  std::vector<Pair> pairs = all_pairs(static_cast<Index>(members.size()));
  for (auto& [p, q] : pairs) {
    p = members[static_cast<std::size_t>(p)];
    q = members[static_cast<std::size_t>(q)];
  }
  return pairs;
}

/// All pairs that the filter admits and that say anything, in lexicographic order.
std::vector<Pair> admitted_pairs(const Problem& problem) {
  std::vector<Pair> pairs = pairs_of(problem.clear_of_rounding(all_of(problem)));
  if (!problem.filter().is_empty()) {
    std::erase_if(pairs, [&](const Pair& pair) {
      return !problem.filter().admits_pair(pair.first, pair.second, problem.scales());
    });
  }
  return pairs;
}

/// Unknown scale: keep the pairs of the maximum clique of the scale consensus graph.
std::optional<Pruned> prune_by_scale(const Problem& problem, Run& run) {
  const StageTimer timer(run, "scale");
  require_memory_for_tims(run, problem.size());
  if (exceeds_time(run, problem.size())) {
    run.limit({Limit::Time, "the time budget does not suffice for the scales of all pairs"});
    return std::nullopt;
  }
  const Index num_clear = static_cast<Index>(problem.clear_of_rounding(all_of(problem)).size());
  const Tims tims = make_tims(problem.correspondences(), admitted_pairs(problem));
  if (run.stopped()) return std::nullopt;
  const auto consensus = scale_consensus(tims, problem.scales());
  if (!consensus) return std::nullopt;
  // those that were left out may be inliers
  return Pruned{
      select(tims, consensus->tims), consensus->scale,
      max_members(static_cast<Index>(consensus->tims.size())) + problem.size() - num_clear};
}

/// Known scale: keep the pairs within the maximum clique of the consistency graph (Parra et al.
/// 2019).
std::optional<Pruned> prune_by_consistency(const Problem& problem, Run& run) {
  const StageTimer timer(run, "graph");
  const int num_threads = run.options().num_threads;
  BitsetGraph graph =
      problem::consistency_graph(problem.arrays(), problem.scales(), num_threads, run.deadline());
  problem.filter().apply(graph, problem.scales(), num_threads, run.deadline());
  const auto clique = run.max_clique(graph, 0, kUnlimited);
  const auto size = static_cast<Index>(clique.vertices.size());
  if (size < 2) return std::nullopt;
  require_memory_for_tims(run, size);
  return Pruned{
      make_tims(problem.correspondences(), pairs_of(problem.clear_of_rounding(clique.vertices))),
      problem.scales().min, static_cast<Index>(clique.upper_bound)};
}

/// Where the rotation graph of all TIMs would not fit into the memory budget: the longest that do.
Tims within_memory(Run& run, Tims tims) {
  Index count = tims.size();
  const std::size_t budget = run.options().memory_limit;
  const std::size_t taken = std::min(budget / 2, static_cast<std::size_t>(count) * kBytesPerTim);
  while (BitsetGraph::bytes_required(count) > budget - taken) {
    count -= count / 16 + 1;
  }
  if (count == tims.size()) return tims;
  run.limit({Limit::Memory, "the memory budget let " + std::to_string(count) + " of " +
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

/// Least-squares pose of some correspondences among those that the priors admit.
std::vector<problem::CentredPose> fit(const Problem& problem, double scale,
                                      const std::vector<Index>& indices) {
  const problem::Correspondences& c = problem.correspondences();
  const auto pose = estimation::fit_pose(c.source, c.target, c.bounds, indices,
                                         estimation::at_scale(problem.constraints(), scale));
  if (!pose) return {};
  return {problem::CentredPose{*pose}};
}

}  // namespace

problem::Found solve(const Problem& problem, Run& run) {
  problem::Found found{{}, problem.size(), static_cast<double>(problem.size())};

  // Eq. (9) to (11), the scale; where it is known, L1
  const auto pruned =
      problem.scale_is_known() ? prune_by_consistency(problem, run) : prune_by_scale(problem, run);
  if (!pruned || run.stopped()) return found;
  found.upper_bound = std::min(found.upper_bound, pruned->upper_bound);
  found.evidence_upper_bound = static_cast<double>(found.upper_bound);

  // Eq. (12) to (15), the rotation
  const Tims tims = within_memory(run, pruned->tims);
  const auto rotation = [&] {
    const StageTimer timer(run, "rotation");
    return rotation_consensus(run, tims, pruned->scale, kUnlimited);
  }();
  if (!rotation) {
    // the TIMs are parallel: a pose that fits, one of many, so that the result can say so
    std::vector<Index> all(static_cast<std::size_t>(tims.size()));
    std::iota(all.begin(), all.end(), Index{0});
    found.poses = fit(problem, pruned->scale, touched_correspondences(tims, all));
    return found;
  }

  // Eq. (16), the translation
  const StageTimer timer(run, "translation");
  const TranslationConsensus translation = translation_consensus(
      run, problem.correspondences(), touched_correspondences(tims, rotation->tims), pruned->scale,
      rotation->rotation, kUnlimited);
  if (!rotation->proven || !translation.proven) {
    run.limit({Limit::CliqueSearch,
               "the clique search of a rotation or translation graph ended before its proof"});
  }
  if (problem.constraints().priors.admit_all()) {
    found.poses = {{{pruned->scale, rotation->rotation, translation.translation}}};
  } else {
    // the stages know of the priors what single pairs say; the pose has to satisfy them
    found.poses = fit(problem, pruned->scale, translation.correspondences);
  }
  return found;
}

}  // namespace gmcr::paper
