#include "search/conflict_bounds.hpp"

#include <algorithm>
#include <bit>
#include <numeric>
#include <vector>

#include "kernels/pairs/consistency_row.hpp"
#include "problem/selection.hpp"

namespace gmcr::search {
namespace {

constexpr Index kBitsPerWord = 64;
constexpr Index kMostPairs = Index{1} << 20;

/// A correspondence that the pose does not hold, or its weight, and that of the inliers that it
/// conflicts with.
struct Other {
  double weight, conflicts;
};

/// L8: base + max over c of (weight of those with conflicts <= c) - c, and no less than the base.
double bound(double base, std::vector<Other> others) {
  constexpr double kRounding = 1e-12;
  std::sort(others.begin(), others.end(),
            [](const Other& a, const Other& b) { return a.conflicts < b.conflicts; });
  double gain = 0, weight = 0;
  for (const Other& other : others) {
    weight += other.weight;
    gain = std::max(gain, weight - other.conflicts);
  }
  return (base + gain) * (1 + kRounding);
}

}  // namespace

problem::PerMeasure bounds_by_conflicts(const problem::Problem& problem,
                                        const problem::Hypothesis& best) {
  const auto weight = [&](Index i) { return problem.objective().weight(i, problem.scales().max); };
  std::vector<Index> others;
  double total = 0;
  for (Index i = 0, next = 0; i < problem.size(); ++i) {
    total += weight(i);
    if (next < best.num_inliers() && best.inliers[static_cast<std::size_t>(next)] == i) {
      ++next;
    } else {
      others.push_back(i);
    }
  }
  const auto num_others = static_cast<Index>(others.size());
  // as many as the others, where a random one conflicts with most
  const Index num_judges = std::min(best.num_inliers(), num_others + num_others / 4 + kBitsPerWord);
  if (num_judges == 0 || !problem.scale_is_known() || num_others * num_judges > kMostPairs) {
    return {static_cast<double>(problem.size()), total};
  }
  // the others first, then some inliers: a row is read from where these begin
  std::vector<Index> chosen = others;
  for (const Index k : problem::stratified_selection(best.num_inliers(), num_judges)) {
    chosen.push_back(best.inliers[static_cast<std::size_t>(k)]);
  }
  const geometry::CorrespondenceArrays& all = problem.arrays();
  const geometry::CorrespondenceArrays arrays{all.source(chosen, Eigen::all),
                                              all.target(chosen, Eigen::all), all.bounds(chosen)};
  double judging = 0;
  for (Index k = num_others; k < arrays.size(); ++k) {
    judging += weight(chosen[static_cast<std::size_t>(k)]);
  }
  const auto num_words =
      static_cast<std::size_t>((arrays.size() + kBitsPerWord - 1) / kBitsPerWord);
  const Index first_word = num_others / kBitsPerWord;
  std::vector<std::uint64_t> row(num_words);
  std::vector<Other> by_number, by_weight;
  for (Index k = 0; k < num_others; ++k) {
    kernels::consistency_row(arrays, k, problem.scales().min, problem.scales().max, row,
                             first_word);
    row[static_cast<std::size_t>(first_word)] &= ~std::uint64_t{0} << (num_others % kBitsPerWord);
    Index num_agreeing = 0;
    double agreeing = 0;
    for (Index w = first_word; w < static_cast<Index>(num_words); ++w) {
      for (std::uint64_t rest = row[static_cast<std::size_t>(w)]; rest != 0; rest &= rest - 1) {
        ++num_agreeing;
        agreeing +=
            weight(chosen[static_cast<std::size_t>(w * kBitsPerWord + std::countr_zero(rest))]);
      }
    }
    by_number.push_back({1, static_cast<double>(num_judges - num_agreeing)});
    by_weight.push_back({weight(others[static_cast<std::size_t>(k)]), judging - agreeing});
  }
  return {bound(static_cast<double>(best.num_inliers()), std::move(by_number)),
          bound(best.evidence, std::move(by_weight))};
}

}  // namespace gmcr::search
