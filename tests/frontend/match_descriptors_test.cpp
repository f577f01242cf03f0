#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <tuple>
#include <vector>

#include "gmcr/descriptors.hpp"
#include "gmcr/registration.hpp"
#include "gmcr/synthetic.hpp"

namespace gmcr {
namespace {

using Bytes = Eigen::Matrix<std::uint8_t, Eigen::Dynamic, Eigen::Dynamic>;

/// Small whole numbers, so that many distances tie and all are exact.
Eigen::MatrixXf random_descriptors(Index num_values, Index count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> value(-3, 3);
  return Eigen::MatrixXf::NullaryExpr(num_values, count,
                                      [&] { return static_cast<float>(value(generator)); });
}

Bytes random_bytes(Index num_bytes, Index count, unsigned seed) {
  std::mt19937 generator(seed);
  return Bytes::NullaryExpr(num_bytes, count,
                            [&] { return static_cast<std::uint8_t>(generator() & 0xff); });
}

double distance(const Eigen::MatrixXf& a, Index i, const Eigen::MatrixXf& b, Index j) {
  return std::sqrt((a.col(i) - b.col(j)).cast<double>().squaredNorm());
}

double distance(const Bytes& a, Index i, const Bytes& b, Index j) {
  int bits = 0;
  for (Index k = 0; k < a.rows(); ++k) {
    bits += std::popcount(static_cast<std::uint8_t>(a(k, i) ^ b(k, j)));
  }
  return bits;
}

/// Columns of b by their distance from column i of a, then by index.
template <class Descriptors>
std::vector<std::pair<double, Index>> ranked(const Descriptors& a, Index i, const Descriptors& b) {
  std::vector<std::pair<double, Index>> all;
  for (Index j = 0; j < b.cols(); ++j) all.emplace_back(distance(a, i, b, j), j);
  std::sort(all.begin(), all.end());
  return all;
}

using Match = std::tuple<Index, Index, double>;

template <class Descriptors>
std::vector<Match> oracle(const Descriptors& a, const Descriptors& b,
                          const DescriptorMatching& options) {
  std::vector<Match> matches;
  const auto k = static_cast<std::size_t>(options.k);
  for (Index i = 0; i < a.cols(); ++i) {
    const auto there = ranked(a, i, b);
    for (std::size_t rank = 0; rank < std::min(k, there.size()); ++rank) {
      const auto [apart, j] = there[rank];
      if (there.size() > k && apart > options.ratio * there[k].first) continue;
      const auto back = ranked(b, j, a);
      const bool is_mutual = std::any_of(
          back.begin(), back.begin() + static_cast<std::ptrdiff_t>(std::min(k, back.size())),
          [i = i](const auto& entry) { return entry.second == i; });
      if (!options.mutual || is_mutual) matches.emplace_back(i, j, apart);
    }
  }
  return matches;
}

std::vector<Match> listed(const DescriptorMatches& matches) {
  std::vector<Match> list;
  for (std::size_t m = 0; m < matches.distances.size(); ++m) {
    list.emplace_back(matches.source_indices[m], matches.target_indices[m], matches.distances[m]);
  }
  return list;
}

template <class Descriptors>
void expect_those_of_the_oracle(const Descriptors& a, const Descriptors& b) {
  for (const int k : {1, 2, 5, 1000}) {
    for (const bool mutual : {false, true}) {
      for (const double ratio : {0.8, 1.0}) {
        for (const int num_threads : {1, 3}) {
          const DescriptorMatching options{k, mutual, ratio, num_threads};
          EXPECT_EQ(listed(match_descriptors(a, b, options)), oracle(a, b, options))
              << k << mutual << ratio;
        }
      }
    }
  }
}

TEST(MatchDescriptors, OfFloatsFindsWhatComparingAllFinds) {
  for (const Index num_values : {1, 4, 35}) {
    expect_those_of_the_oracle(random_descriptors(num_values, 70, 1),
                               random_descriptors(num_values, 90, 2));
  }
}

TEST(MatchDescriptors, OfBitsFindsWhatComparingAllFinds) {
  for (const Index num_bytes : {1, 8, 13, 32}) {
    expect_those_of_the_oracle(random_bytes(num_bytes, 70, 3), random_bytes(num_bytes, 90, 4));
  }
}

TEST(MatchDescriptors, OfNothingIsNothing) {
  const Eigen::MatrixXf none(4, 0), some = random_descriptors(4, 3, 5);
  EXPECT_TRUE(match_descriptors(none, some).distances.empty());
  EXPECT_TRUE(match_descriptors(some, none).distances.empty());
  EXPECT_TRUE(match_descriptors(Bytes(4, 0), Bytes(4, 0)).distances.empty());
}

TEST(MatchDescriptors, RefusesWhatItCannotCompare) {
  const Eigen::MatrixXf good = random_descriptors(4, 3, 6);
  EXPECT_THROW(match_descriptors(good, random_descriptors(5, 3, 7)), std::invalid_argument);
  for (const float bad :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e30f}) {
    Eigen::MatrixXf values = good;
    values(1, 2) = bad;
    EXPECT_THROW(match_descriptors(good, values), std::invalid_argument) << bad;
    EXPECT_THROW(match_descriptors(values, good), std::invalid_argument) << bad;
  }
  EXPECT_THROW(match_descriptors(good, good, {0, true, 1, 0}), std::invalid_argument);
  EXPECT_THROW(match_descriptors(good, good, {1, true, 0, 0}), std::invalid_argument);
  EXPECT_THROW(match_descriptors(good, good, {1, true, 1.5, 0}), std::invalid_argument);
  EXPECT_THROW(match_descriptors(good, good, {1, true, 1, -1}), std::invalid_argument);
}

TEST(MatchDescriptors, GivesMatchesThatASolveTakes) {
  SyntheticOptions draw;
  draw.num_correspondences = 300;
  draw.outlier_rate = 0.5;
  const SyntheticProblem problem = make_synthetic(draw);
  // each point has a descriptor of its own; those of the targets are noisy and in another order
  std::mt19937 generator(8);
  std::normal_distribution<float> noise(0, 0.2f);
  const Eigen::MatrixXf source =
      Eigen::MatrixXf::NullaryExpr(24, 300, [&] { return 5 * noise(generator); });
  const Index shift = 100;
  Eigen::MatrixXf target(24, 300);
  Points targets(3, 300);
  for (Index i = 0; i < 300; ++i) {
    target.col((i + shift) % 300) =
        source.col(i) + Eigen::VectorXf::NullaryExpr(24, [&] { return noise(generator); });
    targets.col((i + shift) % 300) = problem.target.col(i);
  }
  const DescriptorMatches matches = match_descriptors(source, target, {1, true, 0.9, 0});
  EXPECT_GT(matches.distances.size(), 200u);
  Options options;
  options.noise_bound = problem.noise_bound;
  const Result result =
      register_correspondences(problem.source(Eigen::all, matches.source_indices),
                               targets(Eigen::all, matches.target_indices), options);
  EXPECT_LT((result.target_from_source.rotation - problem.target_from_source.rotation).norm(),
            0.05);
}

}  // namespace
}  // namespace gmcr
