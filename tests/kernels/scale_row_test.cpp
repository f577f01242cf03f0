#include "kernels/pairs/scale_row.hpp"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "for_each_isa.hpp"
#include "random_geometry.hpp"
#include "search/scales/scale_bins.hpp"

namespace gmcr {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Some source points, target points or both coincide; some bounds are 0; some points are far off,
/// as near as the smallest numbers, or nowhere.
geometry::CorrespondenceArrays random_arrays(std::uint64_t seed, Index count) {
  testing::RandomGeometry random(seed);
  geometry::CorrespondenceArrays arrays{random.in_cube(count).transpose(),
                                        random.in_cube(count, 2).transpose(),
                                        Eigen::ArrayXd(count)};
  for (double& bound : arrays.bounds) bound = random.index(4) == 0 ? 0 : random.uniform(0, 0.2);
  for (Index i = 1; i < count; ++i) {
    const Index kind = random.index(40);
    if (kind < 4) arrays.source.row(i) = arrays.source.row(i - 1);
    if (kind == 2 || kind == 3 || kind == 4) arrays.target.row(i) = arrays.target.row(i - 1);
    if (kind == 5) arrays.source.row(i).setConstant(1e200);
    if (kind == 6) arrays.target.row(i).setConstant(1e200);
    if (kind == 7) arrays.target.row(i).setConstant(std::numeric_limits<double>::quiet_NaN());
    if (kind == 8) arrays.source.row(i).setConstant(1e-120 * static_cast<double>(i));
    if (kind == 9) arrays.source.row(i).setConstant(1e-90 * static_cast<double>(i));
    if (kind == 10) arrays.bounds[i] = 1e300;
  }
  return arrays;
}

TEST(ScaleRow, GivesTheBinsOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (const Index count : {1, 2, 3, 4, 7, 8, 9, 63, 64, 65, 200}) {
      const auto arrays = random_arrays(static_cast<std::uint64_t>(count), count);
      for (const ScaleRange& range : {ScaleRange{0.05, 20}, {1, 1}, {1e-300, 1e300}}) {
        const search::ScaleBins bins(range, 1.02);
        std::vector<kernels::BinSpan> spans(static_cast<std::size_t>(count));
        for (Index i = 0; i < count; ++i) {
          for (const Index begin : {Index{0}, i + 1}) {
            kernels::scale_row(arrays, bins.cells(), i, begin, spans);
            for (Index j = begin; j < count; ++j) {
              if (j == i) continue;
              ASSERT_EQ(spans[static_cast<std::size_t>(j)],
                        kernels::agreeing_bins(arrays, bins.cells(), i, j))
                  << count << ' ' << i << ' ' << j;
            }
          }
        }
      }
    }
  });
}

TEST(AgreeingBins, AreThoseWhereThePairIsConsistent) {
  const Index count = 150;
  testing::RandomGeometry random(5);
  geometry::CorrespondenceArrays arrays{random.in_cube(count).transpose(),
                                        random.in_cube(count, 2).transpose(),
                                        Eigen::ArrayXd::Constant(count, 0.02)};
  arrays.source.row(5) = arrays.source.row(4);
  arrays.source.row(7) = arrays.source.row(6);
  arrays.target.row(7) = arrays.target.row(6);
  const search::ScaleBins bins({0.1, 20}, 1.1);
  Index num_touched = 0;
  for (Index i = 0; i < count; ++i) {
    for (Index j = 0; j < i; ++j) {
      const kernels::BinSpan span = kernels::agreeing_bins(arrays, bins.cells(), i, j);
      EXPECT_EQ(span, kernels::agreeing_bins(arrays, bins.cells(), j, i));
      for (Index bin = 0; bin < bins.size(); ++bin) {
        const bool named = span.begin() <= bin && bin < span.end();
        const bool agrees = kernels::is_consistent(arrays, i, j, bins[bin].min, bins[bin].max);
        EXPECT_TRUE(named || !agrees) << i << ' ' << j << ' ' << bin;
        num_touched += named && !agrees;
      }
    }
  }
  EXPECT_LE(num_touched, 1);
}

TEST(CoveredBins, AreNoneMissedAndNoneButNeighboursTooMany) {
  testing::RandomGeometry random(1);
  const search::ScaleBins bins({0.05, 50}, 1.02);
  for (int trial = 0; trial < 2000; ++trial) {
    double lower = std::exp(random.uniform(-4, 5)), upper = lower * std::exp(random.uniform(0, 2));
    if (trial % 10 == 0) lower = bins[random.index(bins.size())].max;  // exactly on an edge
    if (trial % 11 == 0) upper = bins[random.index(bins.size())].min;
    if (trial % 7 == 0) lower = -upper;
    upper = std::max(lower, upper);
    const kernels::BinSpan span = kernels::covered_bins(bins.cells(), lower, upper, 1e-16 * upper);
    for (Index bin = 0; bin < bins.size(); ++bin) {
      const bool meets = lower <= bins[bin].max && upper >= bins[bin].min;
      const bool named = span.begin() <= bin && bin < span.end();
      EXPECT_TRUE(named || bins[bin].max == lower || bins[bin].min == upper || !meets);
      EXPECT_TRUE(meets || !named || bin == span.begin() || bin == span.end() - 1);
    }
  }
}

TEST(CoveredBins, OfNoNumberAreNoneAndOfAllScalesAreAll) {
  const search::ScaleBins bins({0.5, 2}, 1.02);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(kernels::covered_bins(bins.cells(), nan, 1, 0), kernels::BinSpan{});
  EXPECT_EQ(kernels::covered_bins(bins.cells(), 1, nan, 0), kernels::BinSpan{});
  EXPECT_EQ(kernels::covered_bins(bins.cells(), 2.1, 3, 0), kernels::BinSpan{});
  EXPECT_EQ(kernels::covered_bins(bins.cells(), -1, 0.4, 0), kernels::BinSpan{});
  const kernels::BinSpan all = kernels::covered_bins(bins.cells(), -kInfinity, kInfinity, 0);
  EXPECT_EQ(all.begin(), 0);
  EXPECT_EQ(all.end(), bins.size());
}

}  // namespace
}  // namespace gmcr
