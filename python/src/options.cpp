#include "gmcr/options.hpp"

#include "bindings.hpp"
#include "gmcr/frontend.hpp"
#include "gmcr/registration.hpp"
#include "progress.hpp"
#include "record.hpp"

namespace gmcr::python {

namespace {

constexpr const char* kOptionsDoc =
    R"(Every choice of a registration. Keywords only; the defaults are those of the C++ library.

>>> options = gmcr.Options(noise_bound=0.02, scale_mode="estimated")
>>> options.time_limit = 10)";

void bind_priors(nb::module_& module) {
  Record<GravityPrior>(
      module, "GravityPrior",
      "The direction of gravity, or of any other known axis, in both frames: the rotation turns\n"
      "one onto the other, up to a tilt.")
      .field("source", &GravityPrior::source,
             "Direction in the source frame, (3,), any length > 0.")
      .field("target", &GravityPrior::target,
             "Direction in the target frame, (3,), any length > 0.")
      .field("max_tilt", &GravityPrior::max_tilt, "Largest angle between the two, radians.")
      .settable();
  Record<InitialPose>(module, "InitialPose",
                      "A pose that the transform is known to be near. Its scale is not used.")
      .field("target_from_source", &InitialPose::target_from_source, "The pose, a Similarity.")
      .field("max_rotation", &InitialPose::max_rotation,
             "Largest angle of the rotation between the two, radians in [0, pi].")
      .field("max_translation", &InitialPose::max_translation,
             "Largest distance of the two translations, metres; inf for any.")
      .settable();
}

void bind_solver_options(nb::module_& module) {
  Record<Options>(module, "Options", kOptionsDoc)
      .field("noise_mode", &Options::noise_mode,
             "'given', or 'estimated': one noise bound is chosen from the data.")
      .field(
          "noise_bound", &Options::noise_bound,
          "Bound on the noise of a target point, metres, > 0. Required where the noise is given,\n"
          "unless noise_bounds is.")
      .field("noise_bounds", &Options::noise_bounds,
             "One bound per correspondence, (N,), metres, each > 0, instead of noise_bound.")
      .field("threshold", &Options::threshold,
             "Inlier threshold c, > 0: i is an inlier iff its residual <= noise_bound_i / c.")
      .field("scale_mode", &Options::scale_mode, "'known' or 'estimated'.")
      .field("scale", &Options::scale, "The scale when known, > 0.")
      .field("scale_range", &Options::scale_range,
             "(min, max) where to search when the scale is estimated; None: from the data.")
      .field("method", &Options::method,
             "'gmcr', many candidates and a certificate, or 'paper', the stages of the paper.")
      .field("evidence", &Options::evidence,
             "'distinct': correspondences that say the same thing twice share one vote; 'count':\n"
             "every inlier counts 1.")
      .field(
          "gravity", [](Options & o) -> auto& { return o.priors.gravity; },
          "What is known of the direction of gravity, a GravityPrior, or None.")
      .field(
          "initial_pose", [](Options & o) -> auto& { return o.priors.initial_pose; },
          "A pose that the transform is near, an InitialPose, or None.")
      .field(
          "max_translation", [](Options & o) -> auto& { return o.priors.max_translation; },
          "Largest norm of the translation, metres, > 0.")
      .field("one_to_one", &Options::one_to_one,
             "Search for poses with at most one inlier of those that share a point.")
      .field(
          "least_squares", &Options::least_squares,
          "Return the least-squares fit to the inliers instead of the pose that holds the most:\n"
          "closer to the truth where the bound is several times the noise, less often certified.")
      .field("num_hypotheses", &Options::num_hypotheses,
             "Poses to return, >= 1: the best one and alternatives.")
      .field("certify", &Options::certify,
             "Spend what is left of the time limit on proving the consensus a maximum one.")
      .field("num_threads", &Options::num_threads,
             "Threads, >= 0; 0 uses every core. The result does not depend on it.")
      .field(
          "time_limit", [](Options & o) -> auto& { return o.budget.time; },
          "Seconds of wall time, > 0; inf for no limit.")
      .field(
          "memory_limit", [](Options & o) -> auto& { return o.budget.memory; },
          "Bytes for graphs, > 0.")
      .field(
          "progress", &Options::progress,
          "Called now and then as progress(stage, fraction); False stops the search, which then\n"
          "ends as if its time were up.")
      .settable()
      .def(
          "admit",
          [](const Options& options, const Similarity& pose) { return options.priors.admit(pose); },
          nb::arg("target_from_source"),
          "Whether gravity, initial_pose and max_translation admit a transform, to rounding.")
      .def("validate", &Options::validate,
           "Raises ValueError naming the field and its value where one is out of range.");
}

void bind_frontend_options(nb::module_& module) {
  Record<FrontendOptions>(module, "FrontendOptions",
                          "How clouds become correspondences. Lengths are in voxels, so that one\n"
                          "set of defaults serves objects and cities.")
      .field("voxel_size", &FrontendOptions::voxel_size,
             "Edge of a voxel, metres of the target frame; 0 chooses it from the clouds.")
      .field("source_voxel_size", &FrontendOptions::source_voxel_size,
             "Edge of a voxel, metres of the source frame; 0 derives it.")
      .field("normal_radius", &FrontendOptions::normal_radius, "Voxels, > 0.")
      .field("feature_radius", &FrontendOptions::feature_radius, "Voxels, >= normal_radius.")
      .field("noise_bound_voxels", &FrontendOptions::noise_bound_voxels,
             "Noise bound, voxels of the target, > 0; used where Options.noise_bound is 0.")
      .field("orientation", &FrontendOptions::orientation,
             "Sides of the normals: 'automatic', 'toward_viewpoint' or 'outward'.")
      .field("source_viewpoint", &FrontendOptions::source_viewpoint, "(3,), metres, source frame.")
      .field("target_viewpoint", &FrontendOptions::target_viewpoint, "(3,), metres, target frame.")
      .field("mutual", &FrontendOptions::mutual,
             "Keep a match only where each point is the other's nearest in feature space.")
      .field("max_ratio", &FrontendOptions::max_ratio,
             "Largest feature distance as a share of that to the second best, in (0, 1].")
      .field("one_to_one", &FrontendOptions::one_to_one,
             "Of the matches that share a target, keep the one closest in feature space.")
      .field("max_attempts", &FrontendOptions::max_attempts,
             "Settings to try before register_clouds settles for the best result, >= 1.")
      .settable()
      .def("validate", &FrontendOptions::validate,
           "Raises ValueError naming the field and its value where one is out of range.");
}

}  // namespace

void bind_options(nb::module_& module) {
  bind_priors(module);
  bind_solver_options(module);
  bind_frontend_options(module);
  Record<InstanceOptions>(module, "InstanceOptions", "When the search for further instances ends.")
      .field("max_instances", &InstanceOptions::max_instances, "Most instances, >= 1.")
      .field("min_inliers", &InstanceOptions::min_inliers, "Inliers that an instance needs, >= 3.")
      .field("min_share", &InstanceOptions::min_share,
             "Share of the evidence of the first one that an instance needs, in [0, 1].")
      .settable()
      .def("validate", &InstanceOptions::validate,
           "Raises ValueError naming the field and its value where one is out of range.");
}

}  // namespace gmcr::python
