#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

#include "gmcr/metrics.hpp"
#include "problems.hpp"

namespace gmcr::registration {
namespace {

using Eigen::Vector3d;

/// What a solve of numbers of some kind must come to.
enum class Outcome {
  Refused,        ///< by name, before any work
  TooFew,         ///< that status
  Pose,           ///< the true one
  PoseByWeights,  ///< the true one, but the method of the paper weighs no bounds
  Degenerate,     ///< or no pose: the method of the paper finds none of some
  Sound,          ///< whatever the status
};

/// Matches of a kind, the first ones right, and what they must come to.
struct Numbers {
  std::string name;
  Points source, target;
  std::vector<double> bounds;  ///< one for all, or one of each
  Outcome outcome = Outcome::Pose;
  Similarity truth = {};
};

constexpr double kBound = 0.01;

/// 30 right matches in a cube of edge 2 and 15 wrong ones; no coordinate is near 0.
Numbers plain(const std::string& name, double unit = 1, std::uint64_t seed = 1) {
  testing::RandomGeometry random(seed);
  Numbers n{name, {}, {}, {kBound * unit}, Outcome::Pose, random.similarity(1, 1, 0)};
  n.truth.translation = unit * Vector3d(3, 4, 5);
  n.source = unit * (random.in_cube(45).array() + 2).matrix();
  n.target = n.truth.apply(n.source);
  for (Index i = 0; i < 30; ++i) n.target.col(i) += unit * random.in_ball(kBound);
  for (Index i = 30; i < 45; ++i) n.target.col(i) += unit * (Vector3d(1, 1, 1) + random.in_ball(3));
  return n;
}

/// The right matches alone.
Numbers right_only(const std::string& name, Index count) {
  Numbers n = plain(name);
  n.source.conservativeResize(3, count);
  n.target.conservativeResize(3, count);
  return n;
}

/// Right matches without noise of given source points.
Numbers exact(const std::string& name, const Points& source, Outcome outcome) {
  Numbers n = right_only(name, 3);
  n.source = source;
  n.target = n.truth.apply(source);
  n.outcome = outcome;
  return n;
}

/// `plain`, changed.
Numbers with(const std::string& name, Outcome outcome,
             const std::function<void(Numbers&)>& change) {
  Numbers n = plain(name);
  n.outcome = outcome;
  change(n);
  return n;
}

Numbers with_bound(const std::string& name, Outcome outcome, double bound) {
  return with(name, outcome, [&](Numbers& n) { n.bounds = {bound}; });
}

/// Both clouds moved away from the origin.
Numbers moved(const std::string& name, double by) {
  return with(name, Outcome::Pose, [&](Numbers& n) {
    const Vector3d source(by, -by, 2 * by), target(-by, by / 2, by);
    n.source.colwise() += source;
    n.target.colwise() += target;
    n.truth.translation += target - n.truth.rotation * source;
    n.bounds = {kBound + 1e-14 * by};
  });
}

/// A share of the matches has a mark for "no point" at one or both ends.
Numbers marked(const std::string& name, double mark, Index count, bool at_source, bool at_target) {
  return with(name, Outcome::Pose, [&](Numbers& n) {
    for (Index k = 0; k < count; ++k) {
      if (at_source) n.source.col(44 - k).setConstant(mark);
      if (at_target) n.target.col(44 - k).setConstant(mark);
    }
  });
}

Points on_line(Index count) {
  Points points(3, count);
  for (Index i = 0; i < count; ++i)
    points.col(i) = (1 + 0.1 * static_cast<double>(i)) * Vector3d(1, 2, 3);
  return points;
}

Points cube_corners() {
  Points corners(3, 8);
  for (Index i = 0; i < 8; ++i) {
    corners.col(i) = Vector3d(i % 2 == 0 ? 1 : 2, i / 2 % 2 == 0 ? 1 : 2, i / 4 == 0 ? 1 : 2);
  }
  return corners;
}

void add_refused(std::vector<Numbers>& all) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const double nan = std::nan("");
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, double>>{{"NaN", nan},
                                                   {"Infinity", kInfinity},
                                                   {"MinusInfinity", -kInfinity},
                                                   {"Denormal", 1e-310},
                                                   {"TooSmall", 9e-51},
                                                   {"TooLarge", -1.1e50},
                                                   {"Huge", 1e155},
                                                   {"LargestDouble", DBL_MAX}}) {
    all.push_back(with("SourceCoordinate" + name, Outcome::Refused,
                       [&](Numbers& n) { n.source(1, 4) = value; }));
    all.push_back(with("TargetCoordinate" + name, Outcome::Refused,
                       [&](Numbers& n) { n.target(2, 44) = value; }));
  }
  for (const auto& [name, value] :
       std::vector<std::pair<std::string, double>>{{"Zero", 0},
                                                   {"NaN", nan},
                                                   {"Infinity", kInfinity},
                                                   {"Negative", -1},
                                                   {"TooSmall", 1e-60},
                                                   {"TooLarge", 1e158}}) {
    all.push_back(with_bound("Bound" + name, Outcome::Refused, value));
    all.push_back(with("OneBound" + name, Outcome::Refused, [&](Numbers& n) {
      n.bounds.assign(45, kBound);
      n.bounds[7] = value;
    }));
  }
  all.push_back(plain("Extent1e150", 1e150));
  all.back().outcome = Outcome::Refused;
  all.push_back(plain("ExtentMinus150", 1e-150));
  all.back().outcome = Outcome::Refused;
}

void add_magnitudes(std::vector<Numbers>& all) {
  for (const auto& [name, unit] : std::vector<std::pair<std::string, double>>{{"1eMinus47", 1e-47},
                                                                              {"1eMinus40", 1e-40},
                                                                              {"1eMinus20", 1e-20},
                                                                              {"Micrometres", 1e-6},
                                                                              {"Millimetres", 1e-3},
                                                                              {"Kilometres", 1e3},
                                                                              {"1e10", 1e10},
                                                                              {"1e20", 1e20},
                                                                              {"1e40", 1e40},
                                                                              {"1e48", 1e48}}) {
    all.push_back(plain("Extent" + name, unit));
  }
  for (const auto& [name, by] : std::vector<std::pair<std::string, double>>{
           {"1e3", 1e3}, {"1e6", 1e6}, {"1e9", 1e9}, {"1e12", 1e12}}) {
    all.push_back(moved("Offset" + name, by));
  }
  for (const auto& [name, mark] : std::vector<std::pair<std::string, double>>{
           {"1e12", 1e12}, {"1e20", 1e20}, {"FloatMax", FLT_MAX}, {"1e49", -1e49}}) {
    all.push_back(marked("OneFarSource" + name, mark, 1, true, false));
    all.push_back(marked("OneFarTarget" + name, mark, 1, false, true));
    all.push_back(marked("OneFarMatch" + name, mark, 1, true, true));
    all.push_back(marked("FifteenFarMatches" + name, mark, 15, true, true));
  }
}

void add_bounds(std::vector<Numbers>& all) {
  all.push_back(with_bound("BoundBelowTheNoise", Outcome::Sound, 1e-6));
  all.push_back(with_bound("BoundTiny", Outcome::Sound, 1e-50));
  all.push_back(with_bound("BoundLargerThanTheCloud", Outcome::Degenerate, 1e3));
  all.push_back(with_bound("BoundLargest", Outcome::Degenerate, 1e50));
  all.push_back(exact("BoundOfRounding", plain("").source.leftCols(30), Outcome::Pose));
  all.back().bounds = {1e-13};
  all.push_back(with("BoundsMixed", Outcome::Pose, [](Numbers& n) {
    n.bounds.assign(45, kBound);
    for (std::size_t i = 0; i < 45; i += 3) n.bounds[i] = 3 * kBound;
  }));
  all.push_back(with("BoundsMixedWidely", Outcome::Sound, [](Numbers& n) {
    n.bounds.assign(45, kBound);
    n.bounds[0] = 1e-40;
    n.bounds[1] = 1e40;
  }));
  // of five tight matches and a loose one all are held, and the tight ones determine the pose
  Points parabola(3, 6);
  for (Index i = 0; i < 5; ++i) parabola.col(i) = Vector3d(i, i * i, i % 2);
  parabola.col(5) = Vector3d(0, 0, 5);
  all.push_back(exact("OneLooseBound", parabola, Outcome::PoseByWeights));
  all.back().target(2, 5) += 1;
  all.back().bounds = {kBound, kBound, kBound, kBound, kBound, 100};
}

void add_shapes(std::vector<Numbers>& all) {
  testing::RandomGeometry random(5);
  const Points cube = plain("").source.leftCols(20);
  Points flat = cube, sphere = cube, twice(3, 40), level = cube;
  flat.row(2).setConstant(2);
  level.row(2).setZero();
  for (Index i = 0; i < sphere.cols(); ++i) sphere.col(i) = 2 * Vector3d::Ones() + random.unit();
  twice << cube, cube;
  all.push_back(exact("Duplicates", twice, Outcome::Pose));
  all.push_back(exact("Coplanar", flat, Outcome::Pose));
  all.push_back(exact("CoplanarAtZero", level, Outcome::Pose));
  all.push_back(exact("Spherical", sphere, Outcome::Pose));
  all.push_back(exact("Symmetric", cube_corners(), Outcome::Pose));
  all.push_back(exact("Collinear", on_line(20), Outcome::Degenerate));
  all.push_back(exact("CollinearThree", on_line(3), Outcome::Degenerate));
  all.push_back(exact("CollinearTwice", on_line(2).replicate(1, 3), Outcome::Degenerate));
  all.push_back(exact("Coincident", Points::Constant(3, 30, 4), Outcome::Degenerate));
  all.push_back(exact("CoincidentAtZero", Points::Zero(3, 30), Outcome::Degenerate));
  all.push_back(with("SourcesCoincide", Outcome::Sound,
                     [](Numbers& n) { n.source.colwise() = Vector3d(1, 2, 3); }));
  all.push_back(with("TargetsCoincide", Outcome::Sound,
                     [](Numbers& n) { n.target.colwise() = Vector3d(1, 2, 3); }));
  all.push_back(with("Mirrored", Outcome::Sound, [](Numbers& n) { n.target.row(0) *= -1; }));
  all.push_back(with("AllWrong", Outcome::Sound,
                     [](Numbers& n) { n.target = n.target.rowwise().reverse().eval(); }));
  all.push_back(right_only("AllRight", 30));
}

void add_counts(std::vector<Numbers>& all) {
  for (const Index count : {0, 1, 2, 3, 4, 5}) {
    all.push_back(right_only("Of" + std::to_string(count), count));
    if (count < 3) all.back().outcome = Outcome::TooFew;
  }
}

std::vector<Numbers> all_numbers() {
  std::vector<Numbers> all;
  add_refused(all);
  add_magnitudes(all);
  add_bounds(all);
  add_shapes(all);
  add_counts(all);
  return all;
}

const std::vector<Numbers>& table() {
  static const std::vector<Numbers> all = all_numbers();
  return all;
}

class Solve : public ::testing::TestWithParam<std::tuple<std::size_t, Method, ScaleMode>> {
 protected:
  static const Numbers& numbers() { return table()[std::get<0>(GetParam())]; }

  static Options options() {
    Options options;
    options.method = std::get<1>(GetParam());
    options.scale_mode = std::get<2>(GetParam());
    const std::vector<double>& bounds = numbers().bounds;
    if (bounds.size() == 1) {
      options.noise_bound = bounds[0];
    } else {
      options.noise_bounds = bounds;
    }
    return options;
  }

  static double bound(Index i) {
    const std::vector<double>& bounds = numbers().bounds;
    return bounds.size() == 1 ? bounds[0] : bounds[static_cast<std::size_t>(i)];
  }

  static std::vector<Index> held_by(const Similarity& pose) {
    std::vector<Index> held;
    for (Index i = 0; i < numbers().source.cols(); ++i) {
      const Vector3d residual = numbers().target.col(i) - pose * numbers().source.col(i);
      if (residual.norm() <= bound(i) * (1 + 1e-9)) held.push_back(i);
    }
    return held;
  }

  /// What holds of every result.
  static void expect_sound(const Result& result) {
    const Certificate& certificate = result.certificate;
    EXPECT_TRUE(result.target_from_source.matrix().allFinite());
    EXPECT_NEAR(result.target_from_source.rotation.determinant(), 1, 1e-9);
    EXPECT_LE(certificate.lower, certificate.upper);
    EXPECT_LE(certificate.upper, numbers().source.cols());
    EXPECT_EQ(certificate.lower, static_cast<Index>(certificate.inliers.size()));
    EXPECT_EQ(certificate.certified, certificate.lower == certificate.upper);
    if (certificate.lower == 0) return;
    const std::vector<Index> held = held_by(result.target_from_source);
    EXPECT_TRUE(
        std::includes(held.begin(), held.end(), result.inliers.begin(), result.inliers.end()));
    const std::vector<Index> most = held_by(certificate.target_from_source);
    EXPECT_TRUE(std::includes(most.begin(), most.end(), certificate.inliers.begin(),
                              certificate.inliers.end()));
    if (numbers().outcome != Outcome::Pose) return;
    const Consensus of_truth =
        evaluate_consensus(numbers().truth, numbers().source, numbers().target, options());
    EXPECT_GE(certificate.upper, static_cast<Index>(of_truth.inliers.size()));
  }
};

TEST_P(Solve, ComesToWhatItsNumbersAllow) {
  const Numbers& n = numbers();
  if (n.outcome == Outcome::Refused) {
    try {
      register_correspondences(n.source, n.target, options());
      ADD_FAILURE() << "accepted";
    } catch (const std::invalid_argument& error) {
      EXPECT_NE(std::string(error.what()).find(": "), std::string::npos) << error.what();
    }
    return;
  }
  const Result result = register_correspondences(n.source, n.target, options());
  expect_sound(result);
  switch (n.outcome) {
    case Outcome::TooFew:
      EXPECT_EQ(result.status, Status::TooFewCorrespondences);
      break;
    case Outcome::Degenerate:
      EXPECT_NE(result.status, Status::Ok);
      break;
    case Outcome::PoseByWeights:
      if (options().method == Method::Paper) break;
      [[fallthrough]];
    case Outcome::Pose: {
      EXPECT_EQ(result.status, Status::Ok) << result.status_reason;
      const Points right = n.source.leftCols(std::min<Index>(30, n.source.cols()));
      EXPECT_LT(mean_point_error(result.target_from_source, n.truth, right), 3 * bound(0));
      break;
    }
    default:
      break;
  }
}

std::string name_of(const ::testing::TestParamInfo<Solve::ParamType>& info) {
  const auto& [index, method, scale_mode] = info.param;
  return table()[index].name + (method == Method::Gmcr ? "ByGmcr" : "ByPaper") +
         (scale_mode == ScaleMode::Known ? "KnownScale" : "UnknownScale");
}

std::vector<std::size_t> all_rows() {
  std::vector<std::size_t> rows(table().size());
  std::iota(rows.begin(), rows.end(), std::size_t{0});
  return rows;
}

INSTANTIATE_TEST_SUITE_P(Numbers, Solve,
                         ::testing::Combine(::testing::ValuesIn(all_rows()),
                                            ::testing::Values(Method::Gmcr, Method::Paper),
                                            ::testing::Values(ScaleMode::Known,
                                                              ScaleMode::Estimated)),
                         name_of);

}  // namespace
}  // namespace gmcr::registration
