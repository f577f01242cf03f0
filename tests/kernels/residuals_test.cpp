#include "kernels/points/residuals.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

struct Matched {
  Similarity pose;
  Eigen::MatrixX3d source, target;
  Eigen::ArrayXd squared_bounds;
};

/// Residuals around the bounds, some of them exactly at it.
Matched random_matched(std::uint64_t seed, Index count) {
  testing::RandomGeometry random(seed);
  Matched m{random.similarity(0.5, 2, 1), random.in_cube(count).transpose(), {}, {}};
  m.target = m.pose.apply(m.source.transpose()).transpose();
  for (Index i = 0; i < count; ++i) m.target.row(i) += random.in_ball(0.2).transpose();
  m.squared_bounds = kernels::squared_residuals_reference(m.pose, m.source, m.target);
  for (Index i = 0; i < count; ++i) {
    if (i % 3 != 0) m.squared_bounds[i] = random.uniform(0, 0.02);
  }
  return m;
}

std::vector<std::uint64_t> bits(const Eigen::ArrayXd& values) {
  std::vector<std::uint64_t> result;
  for (const double value : values) result.push_back(std::bit_cast<std::uint64_t>(value));
  return result;
}

TEST(SquaredResiduals, AreTheDistancesToTheMappedPoints) {
  const Matched m = random_matched(1, 150);
  const Eigen::ArrayXd squared = kernels::squared_residuals(m.pose, m.source, m.target);
  const Points mapped = m.pose.apply(m.source.transpose());
  for (Index i = 0; i < 150; ++i) {
    EXPECT_NEAR(squared[i], (m.target.row(i).transpose() - mapped.col(i)).squaredNorm(), 1e-15);
  }
}

TEST(SquaredResiduals, HaveTheBitsOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (Index count = 0; count <= 200; ++count) {
      const Matched m = random_matched(static_cast<std::uint64_t>(count), count);
      ASSERT_EQ(bits(kernels::squared_residuals(m.pose, m.source, m.target)),
                bits(kernels::squared_residuals_reference(m.pose, m.source, m.target)))
          << count;
    }
  });
}

TEST(Consensus, IsWhereTheReferenceIsWithinTheBoundOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (Index count = 0; count <= 200; ++count) {
      const Matched m = random_matched(static_cast<std::uint64_t>(count), count);
      const auto squared = kernels::squared_residuals_reference(m.pose, m.source, m.target);
      for (const double factor : {1.0, 0.3, 4.0}) {
        kernels::Consensus expected;
        for (Index i = 0; i < count; ++i) {
          if (!(squared[i] <= factor * m.squared_bounds[i])) continue;
          expected.indices.push_back(i);
          expected.squared_residuals.push_back(squared[i]);
        }
        const kernels::Consensus found =
            kernels::consensus(m.pose, m.source, m.target, m.squared_bounds, factor);
        ASSERT_EQ(found.indices, expected.indices) << count << ' ' << factor;
        ASSERT_EQ(found.squared_residuals, expected.squared_residuals) << count << ' ' << factor;
      }
    }
  });
}

TEST(Consensus, LeavesOutWhatIsNoNumber) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Matched m = random_matched(2, 150);
  m.squared_bounds.setConstant(10);
  m.source(3, 0) = kNan;
  m.target(70, 2) = kNan;
  m.squared_bounds[80] = kNan;
  m.target(130, 1) = kNan;
  m.target(140, 1) = kInfinity;
  m.squared_bounds[145] = -1;
  testing::for_each_isa([&] {
    const auto found = kernels::consensus(m.pose, m.source, m.target, m.squared_bounds);
    std::vector<Index> missing;
    for (Index i = 0; i < 150; ++i) {
      if (!std::binary_search(found.indices.begin(), found.indices.end(), i)) missing.push_back(i);
    }
    EXPECT_EQ(missing, (std::vector<Index>{3, 70, 80, 130, 140, 145}));
  });
}

}  // namespace
}  // namespace gmcr
