#include "arguments.hpp"

namespace gmcr::cli {

CLI::Validator not_negative() {
  return CLI::Validator(
      [](std::string& text) {
        return text.starts_with('-') ? "'" + text + "' is negative" : std::string();
      },
      "");
}

void SolverArguments::add_to(CLI::App& command) {
  auto* estimate = command.add_flag(
      "--estimate-scale", [this](std::int64_t) { options.scale_mode = ScaleMode::Estimated; },
      "Search for the scale too (default: it is known)");
  command.add_option("--scale", options.scale, "Known scale, target / source")
      ->capture_default_str()
      ->excludes(estimate);
  command.add_option("--scale-range", scale_range, "Smallest and largest scale to search")
      ->expected(2)
      ->type_name("MIN MAX")
      ->needs(estimate);
  add_choice<Method>(command, "--method", options.method,
                     {{"gmcr", Method::Gmcr}, {"paper", Method::Paper}},
                     "Many candidates with a certificate, or the stages of the paper");
  add_choice<Evidence>(command, "--evidence", options.evidence,
                       {{"distinct", Evidence::Distinct}, {"count", Evidence::Count}},
                       "What is maximised: distinct evidence, or the number of inliers");
  command
      .add_option("--threshold", options.threshold,
                  "Inlier threshold c: residual <= noise bound / c")
      ->capture_default_str();
  command.add_flag("--one-to-one", options.one_to_one,
                   "Keep the first of the matches that share a point");
  command.add_option("--threads", options.num_threads, "Threads; 0 uses every core")
      ->capture_default_str();
  command.add_option("--time-limit", options.budget.time, "Seconds for the search")
      ->type_name("S")
      ->capture_default_str();
  command.add_option("--memory-limit", options.budget.memory, "Bytes for graphs, such as 512MB")
      ->check(not_negative())
      ->transform(CLI::AsSizeValue(false))
      ->type_name("BYTES")
      ->capture_default_str();
}

Options SolverArguments::resolved() const {
  Options resolved = options;
  if (!scale_range.empty()) resolved.scale_range = ScaleRange{scale_range[0], scale_range[1]};
  return resolved;
}

void CloudArguments::add_to(CLI::App& command) {
  command.add_option("SOURCE", source, "Cloud to move")->required();
  command.add_option("TARGET", target, "Cloud to move it onto")->required();
  command.add_option("--voxel", frontend.voxel_size, "Voxel size, metres; 0: from the clouds")
      ->capture_default_str();
  command
      .add_option("--source-voxel", frontend.source_voxel_size,
                  "Voxel size of the source, where its scale differs; 0: derived")
      ->capture_default_str();
  command.add_option("--normal-radius", frontend.normal_radius, "Radius for normals, voxels")
      ->capture_default_str();
  command.add_option("--feature-radius", frontend.feature_radius, "Radius for FPFH, voxels")
      ->capture_default_str();
  add_choice<NormalOrientation>(command, "--orientation", frontend.orientation,
                                {{"auto", NormalOrientation::Automatic},
                                 {"viewpoint", NormalOrientation::TowardViewpoint},
                                 {"outward", NormalOrientation::Outward}},
                                "Where normals point");
  command.add_option("--source-viewpoint", source_viewpoint, "Sensor position, source frame")
      ->expected(3)
      ->type_name("X Y Z");
  command.add_option("--target-viewpoint", target_viewpoint, "Sensor position, target frame")
      ->expected(3)
      ->type_name("X Y Z");
  command.add_flag("--mutual,!--no-mutual", frontend.mutual,
                   "Keep a match only where it is the best both ways (default)");
  command
      .add_option("--max-ratio", frontend.max_ratio,
                  "Largest feature distance over that of the second best")
      ->capture_default_str();
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
