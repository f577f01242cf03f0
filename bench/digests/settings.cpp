#include "digests/settings.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <memory>
#include <numbers>
#include <stdexcept>

namespace gmcr::bench {
namespace {

constexpr double kRadians = std::numbers::pi / 180;  // a degree

Eigen::Matrix3d turn(double degrees, const Eigen::Vector3d& axis) {
  return Eigen::AngleAxisd(degrees * kRadians, axis.normalized()).toRotationMatrix();
}

void use_gravity(Options& options, const Problem& problem) {
  const Eigen::Vector3d up(0.3, -0.2, 1);
  const Eigen::Vector3d tilted = turn(1, {1, 2, -1}) * problem.truth.rotation * up;
  options.gravity = GravityPrior{up, tilted, 3 * kRadians};
}

void use_max_translation(Options& options, const Problem& problem) {
  options.max_translation = 1.1 * problem.truth.translation.norm() + problem.noise_bound;
}

void use_initial_pose(Options& options, const Problem& problem) {
  Similarity guess = problem.truth;
  guess.rotation = turn(8, {-1, 1, 3}) * guess.rotation;
  guess.translation += 10 * problem.noise_bound * Eigen::Vector3d(1, -1, 0.5);
  options.initial_pose = InitialPose{guess, 15 * kRadians, 30 * problem.noise_bound};
}

void use_all_priors(Options& options, const Problem& problem) {
  use_gravity(options, problem);
  use_max_translation(options, problem);
  use_initial_pose(options, problem);
}

/// Half, once and three times the bound in turn.
void use_mixed_bounds(Options& options, const Problem& problem) {
  constexpr double kFactors[] = {0.5, 1, 3};
  options.noise_bound = 0;
  for (Index i = 0; i < problem.source.cols(); ++i) {
    options.noise_bounds.push_back(kFactors[i % 3] * problem.noise_bound);
  }
  if (options.noise_bounds.empty()) options.noise_bound = problem.noise_bound;
}

void use_threshold(Options& options, const Problem& problem) {
  options.noise_bound = 2 * problem.noise_bound / 2;
}

void estimate_noise(Options& options, const Problem&) {
  options.noise_mode = NoiseMode::Estimated;
  options.noise_bound = 0;
}

void use_paper(Options& options, const Problem&) {
  options.method = Method::Paper;
  options.evidence = Evidence::Count;
}

void count(Options& options, const Problem&) { options.evidence = Evidence::Count; }

void certify(Options& options, const Problem&) { options.certify = true; }

class PlainCliques final : public CliqueSolver {
 public:
  CliqueResult solve(const BitsetGraph& graph, const CliqueOptions& options) const override {
    return max_clique(graph, options);
  }
};

void use_clique_solver(Options& options, const Problem&) {
  options.clique_solver = std::make_shared<PlainCliques>();
  options.progress = [](const Progress&) { return true; };
}

void apply_scale(Options& options, const Problem& problem, Scale scale) {
  if (scale == Scale::Known) {
    options.scale = problem.truth.scale;
    return;
  }
  options.scale_mode = ScaleMode::Estimated;
  if (scale == Scale::Range) {
    options.scale_range = ScaleRange{problem.truth.scale / 2, problem.truth.scale * 2};
  }
}

/// The one after the other.
Variant both(const std::string& name, const std::string& first, const std::string& second) {
  const auto variants = variants_named({first, second});
  return {name, [variants](Options& options, const Problem& problem) {
            for (const Variant& variant : variants) variant.apply(options, problem);
          }};
}

const std::vector<Variant>& single_variants() {
  static const std::vector<Variant> variants{
      {"gmcr", [](Options&, const Problem&) {}},
      {"count", count},
      {"paper", use_paper},
      {"paper-distinct", [](Options& options, const Problem&) { options.method = Method::Paper; }},
      {"gravity", use_gravity},
      {"max-translation", use_max_translation},
      {"initial-pose", use_initial_pose},
      {"all-priors", use_all_priors},
      {"one-to-one", [](Options& options, const Problem&) { options.one_to_one = true; }},
      {"hypotheses", [](Options& options, const Problem&) { options.num_hypotheses = 3; }},
      {"mixed-bounds", use_mixed_bounds},
      {"threshold", use_threshold},
      {"clique-solver", use_clique_solver},
      {"auto-noise", estimate_noise},
      {"memory", [](Options& options, const Problem&) { options.memory_limit = 1 << 11; }},
      {"certify", certify},
  };
  return variants;
}

const Variant& single_variant(const std::string& name) {
  const auto& variants = single_variants();
  const auto found = std::find_if(variants.begin(), variants.end(),
                                  [&](const Variant& variant) { return variant.name == name; });
  if (found == variants.end()) throw std::invalid_argument("variants: unknown " + name);
  return *found;
}

Options timeless(int num_threads) {
  Options options;
  options.time_limit = std::numeric_limits<double>::infinity();
  options.num_threads = num_threads;
  return options;
}

}  // namespace

std::string_view name_of(Scale scale) {
  switch (scale) {
    case Scale::Known:
      return "known";
    case Scale::Range:
      return "range";
    case Scale::Free:
      return "free";
  }
  return "";
}

std::vector<Variant> variants_named(const std::vector<std::string>& names) {
  std::vector<Variant> variants;
  for (const std::string& name : names) variants.push_back(single_variant(name));
  return variants;
}

const std::vector<Variant>& all_variants() {
  static const std::vector<Variant> variants = [] {
    std::vector<Variant> all = single_variants();
    std::erase_if(all, [](const Variant& variant) { return variant.name == "certify"; });
    all.push_back(both("paper-gravity", "paper", "gravity"));
    all.push_back(both("paper-mixed-bounds", "paper", "mixed-bounds"));
    all.push_back(both("one-to-one-count", "one-to-one", "count"));
    all.push_back(both("hypotheses-count", "hypotheses", "count"));
    all.push_back(both("auto-noise-gravity", "auto-noise", "gravity"));
    return all;
  }();
  return variants;
}

const std::vector<Variant>& certifying_variants() {
  static const std::vector<Variant> variants{
      single_variant("certify"),
      both("certify-count", "certify", "count"),
      both("certify-gravity", "certify", "gravity"),
      both("certify-mixed-bounds", "certify", "mixed-bounds"),
      both("certify-one-to-one", "certify", "one-to-one"),
      both("certify-hypotheses", "certify", "hypotheses"),
  };
  return variants;
}

Options options_for(const Problem& problem, Scale scale, const Variant& variant, int num_threads) {
  Options options = timeless(num_threads);
  options.noise_bound = problem.noise_bound;
  apply_scale(options, problem, scale);
  variant.apply(options, problem);
  return options;
}

Options cloud_options(Scale scale, double known_scale, int num_threads) {
  Options options = timeless(num_threads);
  Problem problem;
  problem.truth.scale = known_scale;
  apply_scale(options, problem, scale);
  return options;
}

std::vector<FrontendVariant> frontend_variants(double voxel_size) {
  FrontendOptions standard;
  standard.voxel_size = voxel_size;
  std::vector<FrontendVariant> variants{{"standard", standard}};
  const auto vary = [&](const std::string& name, auto change) {
    variants.push_back({name, standard});
    change(variants.back().options);
  };
  vary("one-attempt", [](FrontendOptions& o) { o.max_attempts = 1; });
  vary("unrefined", [](FrontendOptions& o) { o.refine = Refine::None; });
  vary("outward", [](FrontendOptions& o) { o.orientation = NormalOrientation::Outward; });
  vary("viewpoint", [](FrontendOptions& o) {
    o.orientation = NormalOrientation::TowardViewpoint;
    o.source_viewpoint = {0.2, 0.1, 5};
    o.target_viewpoint = {-1, 2, 4};
  });
  vary("one-sided", [](FrontendOptions& o) {
    o.mutual = false;
    o.max_ratio = 0.9;
    o.max_attempts = 2;
  });
  vary("wide", [](FrontendOptions& o) {
    o.normal_radius = 3;
    o.feature_radius = 6;
    o.noise_bound_voxels = 2;
    o.max_attempts = 3;
  });
  return variants;
}

InstanceOptions instance_options(int max_instances, Index min_inliers, double min_share) {
  InstanceOptions options;
  options.max_instances = max_instances;
  options.min_instance_inliers = min_inliers;
  options.min_instance_share = min_share;
  return options;
}

}  // namespace gmcr::bench
