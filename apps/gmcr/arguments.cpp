#include "arguments.hpp"

#include "validators.hpp"

namespace gmcr::cli {

namespace {

void add_scale(CLI::App& command, Options& options, std::vector<double>& range) {
  constexpr const char* kGroup = "Scale";
  auto* estimate = command.add_flag(
      "--estimate-scale", [&options](std::int64_t) { options.scale_mode = ScaleMode::Estimated; },
      "Search for the scale too (default: it is known)");
  estimate->group(kGroup);
  command.add_option("--scale", options.scale, "Known scale, target / source")
      ->capture_default_str()
      ->excludes(estimate)
      ->group(kGroup);
  command.add_option("--scale-range", range, "Smallest and largest scale to search")
      ->expected(2)
      ->type_name("MIN MAX")
      ->needs(estimate)
      ->group(kGroup);
}

void add_answers(CLI::App& command, Options& options) {
  constexpr const char* kGroup = "Answers";
  command
      .add_flag("--certify", options.certify,
                "Spend what is left of the time limit on proving that no pose is better")
      ->group(kGroup);
  command
      .add_flag("--least-squares", options.least_squares,
                "Return the least-squares fit to the inliers, not the pose that holds the most")
      ->group(kGroup);
  command
      .add_option("--hypotheses", options.num_hypotheses,
                  "Poses to return: the best and its alternatives")
      ->check(at_least(1))
      ->type_name("K")
      ->capture_default_str()
      ->group(kGroup);
}

void add_search(CLI::App& command, Options& options) {
  constexpr const char* kGroup = "Search";
  add_choice<Method>(command, "--method", options.method,
                     {{"gmcr", Method::Gmcr}, {"paper", Method::Paper}},
                     "Many candidates with a certificate, or the stages of the paper")
      ->group(kGroup);
  add_choice<Evidence>(command, "--evidence", options.evidence,
                       {{"distinct", Evidence::Distinct}, {"count", Evidence::Count}},
                       "What is maximised: distinct evidence, or the number of inliers")
      ->group(kGroup);
  command
      .add_flag("--one-to-one", options.one_to_one,
                "Search for poses with one inlier of those that share a point")
      ->group(kGroup);
}

void add_limits(CLI::App& command, Options& options) {
  constexpr const char* kGroup = "Limits";
  command.add_option("--threads", options.num_threads, "Threads; 0 uses every core")
      ->capture_default_str()
      ->group(kGroup);
  command.add_option("--time-limit", options.budget.time, "Seconds for the search")
      ->type_name("S")
      ->capture_default_str()
      ->group(kGroup);
  command.add_option("--memory-limit", options.budget.memory, "Bytes for graphs, such as 512MB")
      ->check(not_negative())
      ->transform(CLI::AsSizeValue(false))
      ->type_name("BYTES")
      ->capture_default_str()
      ->group(kGroup);
}

}  // namespace

void SolverArguments::add_to(CLI::App& command) {
  command
      .add_option("--threshold", options.threshold,
                  "Inlier threshold c: residual <= noise bound / c")
      ->capture_default_str()
      ->group("Noise");
  add_scale(command, options, scale_range);
  priors.add_to(command);
  add_answers(command, options);
  add_search(command, options);
  add_limits(command, options);
}

Options SolverArguments::resolved() const {
  Options resolved = options;
  resolved.noise_mode = noise.mode;
  resolved.noise_bound = noise.bound.value_or(resolved.noise_bound);
  if (!scale_range.empty()) resolved.scale_range = ScaleRange{scale_range[0], scale_range[1]};
  resolved.priors = priors.resolved();
  return resolved;
}

void CloudArguments::add_to(CLI::App& command) {
  command.add_option("SOURCE", source, "Cloud to move")->required();
  command.add_option("TARGET", target, "Cloud to move it onto")->required();
  constexpr const char* kGroup = "Matching";
  command.add_option("--voxel", frontend.voxel_size, "Voxel size, metres; 0: from the clouds")
      ->capture_default_str()
      ->group(kGroup);
  command
      .add_option("--source-voxel", frontend.source_voxel_size,
                  "Voxel size of the source, where its scale differs; 0: derived")
      ->capture_default_str()
      ->group(kGroup);
  command.add_option("--normal-radius", frontend.normal_radius, "Radius for normals, voxels")
      ->capture_default_str()
      ->group(kGroup);
  command.add_option("--feature-radius", frontend.feature_radius, "Radius for FPFH, voxels")
      ->capture_default_str()
      ->group(kGroup);
  add_choice<NormalOrientation>(command, "--orientation", frontend.orientation,
                                {{"auto", NormalOrientation::Automatic},
                                 {"viewpoint", NormalOrientation::TowardViewpoint},
                                 {"outward", NormalOrientation::Outward}},
                                "Where normals point")
      ->group(kGroup);
  command.add_option("--source-viewpoint", source_viewpoint, "Sensor position, source frame")
      ->expected(3)
      ->type_name("X Y Z")
      ->group(kGroup);
  command.add_option("--target-viewpoint", target_viewpoint, "Sensor position, target frame")
      ->expected(3)
      ->type_name("X Y Z")
      ->group(kGroup);
  command
      .add_flag("--mutual,!--no-mutual", frontend.mutual,
                "Keep a match only where it is the best both ways (default)")
      ->group(kGroup);
  command
      .add_option("--max-ratio", frontend.max_ratio,
                  "Largest feature distance over that of the second best")
      ->capture_default_str()
      ->group(kGroup);
}

FrontendOptions CloudArguments::resolved() const {
  FrontendOptions resolved = frontend;
  if (!source_viewpoint.empty()) {
    resolved.source_viewpoint = Eigen::Vector3d(source_viewpoint.data());
  }
  if (!target_viewpoint.empty()) {
    resolved.target_viewpoint = Eigen::Vector3d(target_viewpoint.data());
  }
  return resolved;
}

}  // namespace gmcr::cli
