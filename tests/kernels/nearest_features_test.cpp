#include "kernels/features/nearest_features.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

using kernels::IntegerFeatures;
using kernels::NearestFeature;
using kernels::NearestSources;

std::vector<float> random_values(std::uint64_t seed, Index num_bins, Index count, double largest) {
  testing::RandomGeometry random(seed);
  std::vector<float> values(static_cast<std::size_t>(num_bins * count));
  for (float& value : values) value = static_cast<float>(random.uniform(0, largest));
  return values;
}

struct Answer {
  std::vector<NearestFeature> nearest;
  NearestSources of_targets;
};

template <class Compare>
Answer answer_of(const IntegerFeatures& sources, const IntegerFeatures& targets,
                 const Compare& compare) {
  Answer answer{std::vector<NearestFeature>(static_cast<std::size_t>(sources.size())),
                NearestSources(targets)};
  for (Index first = 0; first < sources.size(); first += kernels::kFeatureQueries) {
    compare(sources, first, std::min(kernels::kFeatureQueries, sources.size() - first), targets,
            answer.nearest.data() + first, answer.of_targets);
  }
  return answer;
}

void expect_equal(const Answer& a, const Answer& b) {
  for (std::size_t i = 0; i < a.nearest.size(); ++i) {
    ASSERT_EQ(a.nearest[i].squared_distance, b.nearest[i].squared_distance) << i;
    ASSERT_EQ(a.nearest[i].second, b.nearest[i].second) << i;
    ASSERT_EQ(a.nearest[i].index, b.nearest[i].index) << i;
  }
  EXPECT_EQ(a.of_targets.squared_distances, b.of_targets.squared_distances);
  EXPECT_EQ(a.of_targets.indices, b.of_targets.indices);
}

TEST(NearestFeatures, AreThoseOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (const Index num_bins : {1, 2, 33, 40}) {
      for (Index count = 1; count <= 70; count += 1 + count / 6) {
        const auto seed = static_cast<std::uint64_t>(100 * num_bins + count);
        const double largest = count % 2 == 0 ? 200 : 1.0 / 32;  // the latter with many ties
        const Index num_targets = 1 + count * 3 / 2;
        const auto a = random_values(seed, num_bins, count, largest);
        const auto b = random_values(seed + 1, num_bins, num_targets, largest);
        const double resolution =
            IntegerFeatures::resolution_for(static_cast<double>(num_bins) * largest * largest);
        const IntegerFeatures sources(a.data(), num_bins, count, resolution);
        const IntegerFeatures targets(b.data(), num_bins, num_targets, resolution);
        expect_equal(answer_of(sources, targets, kernels::nearest_features),
                     answer_of(sources, targets, kernels::nearest_features_reference));
      }
    }
  });
}

TEST(NearestFeatures, AreExactWhereValuesAreTheLargest) {
  // opposite corners: nothing overflows
  const Index num_bins = 34;
  std::vector<float> values(static_cast<std::size_t>(2 * num_bins), 0.0f);
  for (Index bin = 0; bin < num_bins; ++bin) {
    values[static_cast<std::size_t>(bin % 2 == 0 ? bin : num_bins + bin)] = 200;
  }
  const double squared_norm = 17 * 200.0 * 200.0;
  const double resolution = IntegerFeatures::resolution_for(squared_norm);
  const IntegerFeatures features(values.data(), num_bins, 2, resolution);
  EXPECT_EQ(features.squared_norms()[0], squared_norm * resolution * resolution);
  const Answer answer = answer_of(features, features, kernels::nearest_features);
  EXPECT_EQ(answer.nearest[0].index, 0);
  EXPECT_EQ(answer.nearest[0].squared_distance, 0);
  EXPECT_EQ(answer.nearest[0].second, 2 * squared_norm * resolution * resolution);
}

TEST(NearestFeatures, OfOneTargetHaveNoSecond) {
  const std::vector<float> values{1, 2, 3};
  const IntegerFeatures one(values.data(), 3, 1, 64);
  const Answer answer = answer_of(one, one, kernels::nearest_features);
  EXPECT_EQ(answer.nearest[0].index, 0);
  EXPECT_GE(answer.nearest[0].second, IntegerFeatures::kFarAway);
}

TEST(IntegerFeatures, RoundToTheResolution) {
  const std::vector<float> values{0.5f, 199.99f, 0.0078f};
  const IntegerFeatures features(values.data(), 3, 1, 64);
  EXPECT_EQ(features.value(0, 0, 0), 32);
  EXPECT_EQ(features.value(0, 0, 1), 12799);
  EXPECT_EQ(features.value(0, 1, 0), 0);
  EXPECT_EQ(features.value(0, 1, 1), 0);  // no such bin
  EXPECT_EQ(features.squared_norms()[0], 32 * 32 + 12799 * 12799);
}

}  // namespace
}  // namespace gmcr
