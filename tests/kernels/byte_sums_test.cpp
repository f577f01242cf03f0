#include "kernels/pairs/byte_sums.hpp"

#include <gtest/gtest.h>

#include <cstdint>
#include <random>
#include <vector>

#include "kernels/for_each_isa.hpp"

namespace gmcr::kernels {
namespace {

TEST(ByteSums, AreThoseOfTheReferenceOnEveryInstructionSet) {
  std::mt19937 generator(3);
  for (const Index length : {0, 1, 15, 16, 17, 31, 32, 33, 63, 64, 65, 200}) {
    for (const Index num_rows : {0, 1, 2, 250, 300}) {
      const Index first = 5;
      std::vector<std::vector<std::uint8_t>> values;
      std::vector<const std::uint8_t*> rows;
      for (Index r = 0; r < num_rows; ++r) {
        auto& row = values.emplace_back(static_cast<std::size_t>(first + length + kByteSlack));
        for (std::uint8_t& value : row) value = static_cast<std::uint8_t>(generator());
      }
      for (const auto& row : values) rows.push_back(row.data());
      const auto size = static_cast<std::size_t>(length) + 1;  // one that is not to be touched
      std::vector<std::uint8_t> expected(size, 77);
      sum_bytes_reference(rows.data(), num_rows, first, length, expected.data());
      testing::for_each_isa([&] {
        std::vector<std::uint8_t> found(size, 77);
        sum_bytes(rows.data(), num_rows, first, length, found.data());
        EXPECT_EQ(found, expected) << length << " bytes of " << num_rows << " rows";
      });
    }
  }
}

}  // namespace
}  // namespace gmcr::kernels
