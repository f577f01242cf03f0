#include "frontend/matching/feature_matching.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <utility>
#include <vector>

namespace gmcr::frontend {
namespace {

/// Whole numbers, whose squared distances are exact in float whatever the order of the sums.
Features random_features(Index count, unsigned seed, int largest = 20) {
  std::mt19937 generator(seed);
  std::uniform_int_distribution<int> value(1, largest);
  return Features::NullaryExpr(kFpfhBins, count,
                               [&] { return static_cast<float>(value(generator)); });
}

struct Ranked {
  Index index = -1;
  float squared_distance = std::numeric_limits<float>::infinity();
  float second = std::numeric_limits<float>::infinity();
};

Ranked nearest(const Features& features, const Eigen::Vector<float, kFpfhBins>& query) {
  Ranked best;
  for (Index j = 0; j < features.cols(); ++j) {
    const float d = (features.col(j) - query).squaredNorm();
    if (d < best.squared_distance) {
      best = {j, d, best.squared_distance};
    } else if (d < best.second) {
      best.second = d;
    }
  }
  return best;
}

using Pairs = std::vector<std::pair<Index, Index>>;

Pairs as_pairs(const std::vector<FeatureMatch>& matches) {
  Pairs pairs;
  for (const auto& match : matches) pairs.emplace_back(match.source, match.target);
  return pairs;
}

Pairs oracle(const Features& source, const Features& target, const MatchingOptions& options) {
  Pairs pairs;
  for (Index i = 0; i < source.cols(); ++i) {
    const Ranked best = nearest(target, source.col(i));
    if (options.mutual && nearest(source, target.col(best.index)).index != i) continue;
    if (options.max_ratio < 1 &&
        best.squared_distance > options.max_ratio * options.max_ratio * best.second) {
      continue;
    }
    pairs.emplace_back(i, best.index);
  }
  return pairs;
}

TEST(FeatureMatching, PoolsMatchesOnceAndInOrder) {
  const std::vector<FeatureMatch> matches =
      pooled({{0, 3}, {2, 1}, {4, 4}}, {{4, 4}, {2, 0}, {1, 7}});
  EXPECT_EQ(as_pairs(matches), (Pairs{{0, 3}, {1, 7}, {2, 0}, {2, 1}, {4, 4}}));
}

TEST(FeatureMatching, AgreesWithBruteForceForAllOptionsAndSizes) {
  for (const Index n : {1, 3, 8, 9, 257, 600}) {
    const Features source = random_features(n, 1);
    const Features target = random_features(n + n / 3 + 5, 2);
    for (const bool mutual : {false, true}) {
      for (const float ratio : {1.0f, 0.95f}) {
        const MatchingOptions options{mutual, ratio, 0};
        EXPECT_EQ(as_pairs(match_features(source, target, options).pairs),
                  oracle(source, target, options))
            << n << ' ' << mutual << ' ' << ratio;
      }
    }
  }
}

TEST(FeatureMatching, OneToOneKeepsTheClosestMatchOfEachTarget) {
  // sources at 0, 1 and 5 times a direction, targets at 1.2 and 100 times it
  Features source = Features::Zero(kFpfhBins, 3), target = Features::Zero(kFpfhBins, 2);
  source.row(0) << 0.1f, 1, 5;
  target.row(0) << 1.2f, 100;
  MatchingOptions options;
  options.mutual = false;
  EXPECT_EQ(match_features(source, target, options).pairs.size(), 3u);
  options.one_to_one = true;
  const auto matches = match_features(source, target, options).pairs;
  ASSERT_EQ(matches.size(), 1u);
  EXPECT_EQ(matches[0].source, 1);
  EXPECT_EQ(matches[0].target, 0);
}

TEST(FeatureMatching, BreaksTiesTowardTheSmallestIndex) {
  const Features one = random_features(1, 3);
  const Features many = one.replicate(1, 700);
  EXPECT_EQ(as_pairs(match_features(many, many, {true, 1, 0}).pairs), (Pairs{{0, 0}}));
  const auto all = match_features(many, many, {false, 1, 0}).pairs;
  ASSERT_EQ(all.size(), 700u);
  for (const auto& match : all) EXPECT_EQ(match.target, 0);
}

TEST(FeatureMatching, OfManyEqualFeaturesAgreesWithBruteForce) {
  const Features source = random_features(400, 4, 1);
  Features target = source;
  target.row(5).tail(200).setConstant(2);
  for (const bool mutual : {false, true}) {
    const MatchingOptions options{mutual, 1, 0};
    EXPECT_EQ(as_pairs(match_features(source, target, options).pairs),
              oracle(source, target, options));
  }
}

TEST(FeatureMatching, LeavesOutColumnsOfZeros) {
  Features source = random_features(20, 5);
  Features target = source;
  source.col(3).setZero();
  target.col(7).setZero();
  const auto matches = as_pairs(match_features(source, target, {true, 1, 0}).pairs);
  EXPECT_EQ(matches.size(), 18u);
  for (const auto& [i, j] : matches) {
    EXPECT_EQ(i, j);
    EXPECT_NE(i, 3);
    EXPECT_NE(i, 7);
  }
}

TEST(FeatureMatching, OfNothingIsNothing) {
  const Features none(kFpfhBins, 0);
  const Features some = random_features(5, 6);
  const Features zeros = Features::Zero(kFpfhBins, 5);
  EXPECT_TRUE(match_features(none, some, {}).pairs.empty());
  EXPECT_TRUE(match_features(some, none, {}).pairs.empty());
  EXPECT_TRUE(match_features(some, zeros, {}).pairs.empty());
}

TEST(FeatureMatching, DoesNotDependOnTheNumberOfThreads) {
  const Features source = random_features(2000, 7);
  const Features target = random_features(1500, 8);
  const auto one = as_pairs(match_features(source, target, {true, 1, 1}).pairs);
  for (const int threads : {2, 5}) {
    EXPECT_EQ(as_pairs(match_features(source, target, {true, 1, threads}).pairs), one);
  }
}

TEST(FeaturesInPlaces, OfFewFeaturesAgreeWithBruteForce) {
  // so few that each source is compared with all places
  for (const Index n : {1, 2, 7, 40}) {
    const Features source = random_features(n, 1, 3), target = random_features(n + 5, 2, 3);
    for (const bool mutual : {false, true}) {
      for (const float ratio : {1.0f, 0.95f}) {
        MatchingOptions options{mutual, ratio, 0};
        options.most_pairs = 0;
        EXPECT_EQ(as_pairs(match_features(source, target, options).pairs),
                  oracle(source, target, options))
            << n << ' ' << mutual << ' ' << ratio;
      }
    }
  }
}

/// Histograms of a family with few parameters, as those of surfaces, and others beside each.
struct SimilarFeatures {
  Features source, target;

  explicit SimilarFeatures(Index count) : source(kFpfhBins, count), target(kFpfhBins, count) {
    std::mt19937 generator(9);
    std::uniform_real_distribution<float> place(0, 1), noise(-1, 1);
    for (Index i = 0; i < count; ++i) {
      const float a = 3 + 27 * place(generator), b = 2 + 6 * place(generator);
      for (Index bin = 0; bin < kFpfhBins; ++bin) {
        const float offset = (static_cast<float>(bin) - a) / b;
        source(bin, i) = 60 * std::exp(-offset * offset) + 2 + noise(generator);
        target(bin, i) = source(bin, i) + noise(generator);
      }
    }
  }
};

TEST(FeaturesInPlaces, KeepNearlyAllMatchesThatAllWithAllFinds) {
  const SimilarFeatures features(10000);  // more than are compared between two looks at the clock
  MatchingOptions all{true, 1, 0}, in_places = all;
  in_places.most_pairs = 0;
  const auto right = [&](const MatchingOptions& options) {
    const FeatureMatches matches = match_features(features.source, features.target, options);
    EXPECT_EQ(matches.share_compared, 1);
    return std::count_if(matches.pairs.begin(), matches.pairs.end(),
                         [](const FeatureMatch& match) { return match.source == match.target; });
  };
  const auto by_all = right(all), by_places = right(in_places);
  EXPECT_GT(by_all, 4000);
  EXPECT_GE(static_cast<double>(by_places), 0.99 * static_cast<double>(by_all));
}

TEST(FeaturesInPlaces, DoNotDependOnTheNumberOfThreads) {
  const SimilarFeatures features(2000);
  const auto with = [&](int threads) {
    MatchingOptions options{true, 0.99f, threads};
    options.most_pairs = 0;
    return as_pairs(match_features(features.source, features.target, options).pairs);
  };
  const Pairs one = with(1);
  EXPECT_FALSE(one.empty());
  for (const int threads : {2, 5}) EXPECT_EQ(with(threads), one);
}

TEST(FeaturesInPlaces, EndWithTheDeadline) {
  const SimilarFeatures features(2000);
  MatchingOptions options;
  options.most_pairs = 0;
  options.deadline = parallel::Deadline(0);
  const FeatureMatches none = match_features(features.source, features.target, options);
  EXPECT_TRUE(none.pairs.empty());
  EXPECT_EQ(none.share_compared, 0);
}

TEST(MatchFeatures, EndWithTheDeadlineAndSayHowFarTheyCame) {
  const Features features = Features::Random(kFpfhBins, 2000);
  MatchingOptions options;
  options.deadline = parallel::Deadline(0);
  const FeatureMatches none = match_features(features, features, options);
  EXPECT_TRUE(none.pairs.empty());
  EXPECT_EQ(none.share_compared, 0);
  options.deadline = parallel::Deadline::never();
  EXPECT_EQ(match_features(features, features, options).share_compared, 1);
}

}  // namespace
}  // namespace gmcr::frontend
