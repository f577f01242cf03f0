#include "search/scales/scale_bins.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "problem/scale_buckets.hpp"

namespace gmcr::search {
namespace {

/// The bin of a scale by its edges, the upper one exclusive.
Index bin_of(const ScaleBins& bins, double scale) {
  Index bin = 0;
  while (bin + 1 < bins.size() && scale > bins[bin].max) ++bin;
  return bin;
}

TEST(ScaleBins, CoverTheRangeWithoutGaps) {
  const ScaleBins bins({0.3, 7}, 1.1);
  EXPECT_EQ(bins[0].min, 0.3);
  EXPECT_EQ(bins[bins.size() - 1].max, 7);
  for (Index bin = 0; bin < bins.size(); ++bin) {
    EXPECT_LE(bins[bin].max / bins[bin].min, std::exp2(1.0 / 7) * (1 + 1e-9));  // 1.104
    if (bin == 0) continue;
    EXPECT_EQ(bins[bin].min, bins[bin - 1].max);
  }
}

TEST(ScaleBins, HoldNoTwoOctaves) {
  for (const ScaleRange& range : {ScaleRange{0.3, 7}, {1, 1.05}, {1.4, 1.42}, {1e-9, 1e9}}) {
    const ScaleBins bins(range, 1.02, problem::ScaleBuckets(0.8));
    for (Index bin = 0; bin < bins.size(); ++bin) {
      const double above = bins[bin].min * (1 + 1e-13);
      EXPECT_EQ(problem::ScaleBuckets(0.8).centre_of(above),
                problem::ScaleBuckets(0.8).centre_of(bins[bin].max));
    }
  }
}

TEST(ScaleBins, OfOneScaleAreOneBin) {
  const ScaleBins bins({2, 2}, 1.02);
  EXPECT_EQ(bins.size(), 1);
  EXPECT_EQ(kernels::covered_bins(bins.cells(), 1, 3, 0).end(), 1);
  EXPECT_EQ(kernels::covered_bins(bins.cells(), 2.1, 3, 0).end(), 0);
}

TEST(ScaleBins, NameTheBinOfEachScaleInTheirTable) {
  for (const ScaleRange& range : {ScaleRange{0.3, 7}, {1, 1.05}, {1, 1.001}, {0.999, 1.001}}) {
    const ScaleBins bins(range, 1.02, problem::ScaleBuckets(0.8));
    for (int k = 0; k <= 1000; ++k) {
      const double scale = range.min + (range.max - range.min) * k / 1000.0;
      const kernels::BinSpan span = kernels::covered_bins(bins.cells(), scale, scale, 0);
      EXPECT_EQ(span.begin(), bin_of(bins, scale));
      EXPECT_EQ(span.end(), span.begin() + 1);
    }
    for (Index bin = 0; bin < bins.size(); ++bin) {
      const double edge = bins[bin].max;
      EXPECT_EQ(kernels::covered_bins(bins.cells(), edge, edge, 0).begin(), bin);
      if (bin + 1 == bins.size()) continue;
      const double beyond = std::nextafter(edge, 2 * edge);
      EXPECT_EQ(kernels::covered_bins(bins.cells(), beyond, beyond, 0).begin(), bin + 1);
    }
  }
}

TEST(ScaleBins, OfTheWidestRangeAreWiderAndNotMore) {
  using Limits = std::numeric_limits<double>;
  for (const double min : {Limits::denorm_min(), 1e-300, Limits::min()}) {
    const ScaleBins bins({min, Limits::max()}, 1.02);
    EXPECT_LE(bins.size(), ScaleBins::kMaxBins);
    EXPECT_GT(bins.size(), ScaleBins::kMaxBins / 2);
    EXPECT_EQ(bins[0].min, min);
    EXPECT_EQ(bins[bins.size() - 1].max, Limits::max());
    for (Index bin = 0; bin < bins.size(); ++bin) EXPECT_LT(bins[bin].min, bins[bin].max);
    EXPECT_EQ(kernels::covered_bins(bins.cells(), 1, 1, 0).begin(), bin_of(bins, 1));
  }
}

}  // namespace
}  // namespace gmcr::search
