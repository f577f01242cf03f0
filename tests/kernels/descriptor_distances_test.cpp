#include "kernels/features/descriptor_distances.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

using kernels::GroupedDescriptors;

template <class Value, class Compare>
std::vector<float> distances_by(const Compare& compare, const GroupedDescriptors<Value>& targets,
                                const std::vector<Value>& query) {
  std::vector<float> distances(
      static_cast<std::size_t>(GroupedDescriptors<Value>::kGroup * targets.num_groups()));
  compare(targets, query.data(), distances.data());
  return distances;
}

TEST(SquaredDistances, HaveTheBitsOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    testing::RandomGeometry random(1);
    for (const Index num_values : {0, 1, 3, 32, 33, 130}) {
      for (const Index count : {1, 31, 32, 33, 100}) {
        const auto value = [&] { return static_cast<float>(random.uniform(-1, 1)); };
        const GroupedDescriptors<float> targets(num_values, count,
                                                [&](Index, Index) { return value(); });
        std::vector<float> query(static_cast<std::size_t>(num_values));
        for (float& v : query) v = value();
        ASSERT_EQ(distances_by(kernels::squared_distances, targets, query),
                  distances_by(kernels::squared_distances_reference, targets, query));
      }
    }
  });
}

TEST(HammingDistances, AreThoseOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    std::mt19937_64 random(2);
    for (const Index num_values : {0, 1, 4, 9}) {
      for (const Index count : {1, 31, 32, 33, 100}) {
        const GroupedDescriptors<std::uint64_t> targets(num_values, count,
                                                        [&](Index, Index) { return random(); });
        std::vector<std::uint64_t> query(static_cast<std::size_t>(num_values));
        for (std::uint64_t& v : query) v = random();
        ASSERT_EQ(distances_by(kernels::hamming_distances, targets, query),
                  distances_by(kernels::hamming_distances_reference, targets, query));
      }
    }
  });
}

TEST(SquaredDistances, AreThoseOfTheDescriptors) {
  const float values[] = {1, 2, 3, 4, 5, 7};
  const GroupedDescriptors<float> targets(2, 3,
                                          [&](Index d, Index i) { return values[2 * i + d]; });
  const auto distances = distances_by(kernels::squared_distances_reference, targets, {1, 1});
  EXPECT_EQ(distances[0], 1);
  EXPECT_EQ(distances[1], 4 + 9);
  EXPECT_EQ(distances[2], 16 + 36);
}

TEST(HammingDistances, CountTheBitsThatDiffer) {
  const std::uint64_t values[] = {0, 0xff, ~std::uint64_t{0}};
  const GroupedDescriptors<std::uint64_t> targets(1, 3, [&](Index, Index i) { return values[i]; });
  const auto distances =
      distances_by(kernels::hamming_distances_reference, targets, std::vector<std::uint64_t>{1});
  EXPECT_EQ(distances[0], 1);
  EXPECT_EQ(distances[1], 7);
  EXPECT_EQ(distances[2], 63);
}

}  // namespace
}  // namespace gmcr
