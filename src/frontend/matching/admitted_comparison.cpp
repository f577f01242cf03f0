#include "frontend/matching/admitted_comparison.hpp"

namespace gmcr::frontend {
namespace {

using kernels::NearestFeature;

/// Of a fixed number of bins, so that compilers use the registers that they may use.
template <int kBins>
std::int32_t squared_distance(const std::int16_t* a, const std::int16_t* b) {
  std::int32_t sum = 0;
  for (int bin = 0; bin < kBins; ++bin) {
    const std::int32_t difference = a[bin] - b[bin];
    sum += difference * difference;
  }
  return sum;
}

}  // namespace

AdmittedComparison::Columns AdmittedComparison::columns_of(
    const kernels::IntegerFeatures& features) {
  Columns columns = Columns::Zero(Columns::RowsAtCompileTime, features.size());
  for (Index i = 0; i < features.size(); ++i) {
    for (Index bin = 0; bin < 2 * features.num_pairs(); ++bin) {
      columns(bin, i) = features.value(i, bin / 2, bin % 2);
    }
  }
  return columns;
}

AdmittedComparison::AdmittedComparison(const Described& source, const Described& target,
                                       const MatchPriors& priors)
    : source_columns_(source.columns),
      priors_(priors),
      source_(columns_of(source.features)),
      target_(columns_of(target.features)) {
  if (target.columns.empty()) return;
  number_of_.assign(static_cast<std::size_t>(target.columns.back()) + 1, -1);
  for (std::size_t j = 0; j < target.columns.size(); ++j) {
    number_of_[static_cast<std::size_t>(target.columns[j])] = static_cast<std::int32_t>(j);
  }
}

NearestFeature AdmittedComparison::nearest(Index source,
                                           kernels::NearestSources& of_targets) const {
  NearestFeature best;
  best.index = kNoPartner;
  const Index column = source_columns_[static_cast<std::size_t>(source)];
  for (const Index partner : priors_.partners_of(column)) {
    if (partner >= static_cast<Index>(number_of_.size())) break;
    const std::int32_t number = number_of_[static_cast<std::size_t>(partner)];
    if (number < 0) continue;
    const std::int32_t distance = squared_distance<Columns::RowsAtCompileTime>(
        source_.col(source).data(), target_.col(number).data());
    best.offer(distance, number);
    const auto target = static_cast<std::size_t>(number);
    if (distance >= of_targets.squared_distances[target]) continue;
    of_targets.squared_distances[target] = distance;
    of_targets.indices[target] = static_cast<std::int32_t>(source);
  }
  return best;
}

}  // namespace gmcr::frontend
