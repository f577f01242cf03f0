#include "kernels/features/pair_angles.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "kernels/for_each_isa.hpp"
#include "random_geometry.hpp"

namespace gmcr {
namespace {

using kernels::kAngleBins;
using kernels::kAngleRow;
using kernels::kHistogramStride;
using kernels::kPairAngles;
using kernels::OrientedPoints;

using Counts = std::array<std::int32_t, kPairAngles * kAngleRow>;

/// A point, and many about it: some coincide, some have no normal or the same one.
struct OrientedScene {
  Eigen::MatrixX3d points, normals;
  std::vector<std::int32_t> neighbours;

  OrientedPoints oriented() const {
    return {points.col(0).data(),  points.col(1).data(),  points.col(2).data(),
            normals.col(0).data(), normals.col(1).data(), normals.col(2).data()};
  }
};

OrientedScene oriented_scene(std::uint64_t seed, Index count) {
  testing::RandomGeometry random(seed);
  OrientedScene made;
  made.points.resize(count, 3);
  made.normals.resize(count, 3);
  for (Index i = 0; i < count; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      made.points(i, axis) = random.uniform(-1, 1);
      made.normals(i, axis) = random.uniform(-1, 1);
    }
    made.normals.row(i).normalize();
    if (i % 7 == 3) made.points.row(i) = made.points.row(0);
    if (i % 11 == 5) made.normals.row(i).setZero();
    if (i % 5 == 2) made.normals.row(i) = made.normals.row(0);
    if (i % 13 == 6) made.normals.row(i) = -made.normals.row(0);
    if (i % 17 == 9) made.points.row(i) = made.points.row(0) + 0.1 * made.normals.row(0);
  }
  made.neighbours.resize(static_cast<std::size_t>(count - 1));
  std::iota(made.neighbours.begin(), made.neighbours.end(), 1);
  return made;
}

template <class Count>
Counts counts_by(const Count& count, const OrientedScene& in) {
  Counts counts{};
  count(in.oriented(), 0, in.neighbours.data(), static_cast<Index>(in.neighbours.size()),
        counts.data());
  return counts;
}

TEST(PairAngles, AreThoseOfTheReferenceOnEveryInstructionSet) {
  testing::for_each_isa([] {
    for (Index count = 1; count < 60; ++count) {
      const OrientedScene in = oriented_scene(static_cast<std::uint64_t>(count), count);
      ASSERT_EQ(counts_by(kernels::count_pair_angles, in),
                counts_by(kernels::count_pair_angles_reference, in))
          << count;
    }
  });
}

TEST(PairAngles, AddToTheCounts) {
  const OrientedScene in = oriented_scene(1, 40);
  Counts twice = counts_by(kernels::count_pair_angles, in);
  Counts once = twice;
  kernels::count_pair_angles(in.oriented(), 0, in.neighbours.data(),
                             static_cast<Index>(in.neighbours.size()), twice.data());
  for (std::int32_t& count : once) count *= 2;
  EXPECT_EQ(twice, once);
}

/// By the words of the paper, with an arc tangent.
Counts by_the_paper(const OrientedScene& in) {
  constexpr double kPi = std::numbers::pi;
  Counts counts{};
  const auto bin = [](double value, double min, double max) {
    const double place = std::floor(kAngleBins * (value - min) / (max - min));
    return static_cast<std::size_t>(std::clamp(place, 0.0, kAngleBins - 1.0));
  };
  for (const std::int32_t j : in.neighbours) {
    Eigen::Vector3d offset = in.points.row(j) - in.points.row(0);
    Eigen::Vector3d u = in.normals.row(0), other = in.normals.row(j);
    const double distance = offset.norm();
    if (std::abs(u.dot(offset)) < std::abs(other.dot(offset)) - 1e-9 * distance) {
      u.swap(other);
      offset = -offset;
    }
    const bool has_angles =
        distance > 0 && in.normals.row(j).norm() > 0 && offset.cross(u).norm() > 0;
    if (!has_angles) {
      for (std::size_t a = 0; a < kPairAngles; ++a) ++counts[kAngleRow * a + kAngleBins];
      continue;
    }
    const Eigen::Vector3d v = offset.cross(u).normalized(), w = u.cross(v);
    ++counts[bin(std::atan2(w.dot(other), u.dot(other)), -kPi, kPi)];
    ++counts[kAngleRow + bin(v.dot(other), -1, 1)];
    ++counts[2 * kAngleRow + bin(u.dot(offset) / distance, -1, 1)];
  }
  return counts;
}

TEST(PairAngles, AreThoseOfThePaper) {
  // without pairs of equal or opposite normals, where rounding tells the sign of an angle of 0 or
  // pi
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    OrientedScene in = oriented_scene(seed, 60);
    std::erase_if(in.neighbours,
                  [](std::int32_t i) { return i % 5 == 2 || i % 13 == 6 || i % 17 == 9; });
    EXPECT_EQ(counts_by(kernels::count_pair_angles_reference, in), by_the_paper(in)) << seed;
  }
}

TEST(ThetaEdges, LieBetweenTheBins) {
  for (int k = 0; k < 5; ++k) {
    const double angle = (2 * k + 1) * std::numbers::pi / kAngleBins;
    EXPECT_NEAR(kernels::kThetaEdges[k].cosine, std::cos(angle), 1e-15);
    EXPECT_NEAR(kernels::kThetaEdges[k].sine, std::sin(angle), 1e-15);
  }
}

TEST(AddHistograms, GivesTheBitsOfTheReferenceOnEveryInstructionSet) {
  testing::RandomGeometry random(5);
  std::vector<float> histograms(static_cast<std::size_t>(30 * kHistogramStride));
  for (float& value : histograms) value = static_cast<float>(random.uniform(0, 100));
  std::vector<std::int32_t> indices(77);
  std::vector<float> weights(indices.size());
  for (std::size_t k = 0; k < indices.size(); ++k) {
    indices[k] = static_cast<std::int32_t>(random.uniform(0, 29.9));
    weights[k] = static_cast<float>(random.uniform(0, 3));
  }
  testing::for_each_isa([&] {
    for (const Index count : {0, 1, 2, 77}) {
      std::array<float, kHistogramStride> sum{}, expected{};
      kernels::add_histograms(histograms.data(), indices.data(), weights.data(), count, sum.data());
      kernels::add_histograms_reference(histograms.data(), indices.data(), weights.data(), count,
                                        expected.data());
      EXPECT_EQ(sum, expected);
      EXPECT_EQ(sum[0] > 0, count > 0);
    }
  });
}

}  // namespace
}  // namespace gmcr
