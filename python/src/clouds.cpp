#include <nanobind/stl/vector.h>

#include "bindings.hpp"
#include "conversion/interruptible.hpp"
#include "conversion/pose_properties.hpp"
#include "conversion/record.hpp"
#include "conversion/report_methods.hpp"
#include "gmcr/frontend.hpp"

namespace gmcr::python {
namespace {

std::string describe(const CloudResult& result) {
  const auto registration = nb::cast<std::string>(nb::repr(nb::cast(result.registration)));
  const nb::str format("CloudResult({!r}, fitness={:.3f}, {} matches, {})");
  return nb::cast<std::string>(format.attr("format")(name_of(result.verdict), result.fitness,
                                                     result.matches.source.cols(), registration));
}

/// A property that is a field of the registration, described as there.
template <class Value>
void forward(nb::class_<CloudResult>& result, const char* name, Value Result::*member) {
  const std::string signature = "def " + std::string(name) + "(self) -> " + Convert<Value>::type();
  const auto doc = nb::cast<std::string>(nb::type<Result>().attr(name).attr("__doc__"));
  result.def_prop_ro(
      name,
      [member](nb::handle self) {
        return Convert<Value>::to_python(nb::cast<const CloudResult&>(self).registration.*member,
                                         self);
      },
      nb::sig(signature.c_str()), doc.c_str());
}

/// What the registration holds, so that one need not know where a result keeps it; the verdict is
/// the one of the clouds.
void forward_registration(nb::class_<CloudResult>& result) {
  forward(result, "status", &Result::status);
  forward(result, "status_reason", &Result::status_reason);
  forward(result, "inliers", &Result::inliers);
  forward(result, "evidence", &Result::evidence);
  forward(result, "log10_false_alarms", &Result::log10_false_alarms);
  forward(result, "certificate", &Result::certificate);
  forward(result, "consistent_scales", &Result::consistent_scales);
  forward(result, "covariance", &Result::covariance);
  forward(result, "alternatives", &Result::alternatives);
  forward(result, "noise_estimate", &Result::noise_estimate);
  forward(result, "diagnostics", &Result::diagnostics);
}

void bind_matches(nb::module_& module) {
  Record<CloudMatches>(module, "CloudMatches", "Putative correspondences between two clouds.")
      .field("source", &CloudMatches::source, "(M, 3), matched points of the source, metres.")
      .field("target", &CloudMatches::target, "(M, 3), matched points of the target, metres.")
      .field("source_indices", &CloudMatches::source_indices,
             "(M,) int64, rows of source_voxels, ascending.")
      .field("target_indices", &CloudMatches::target_indices, "(M,) int64, rows of target_voxels.")
      .field("source_voxels", &CloudMatches::source_voxels,
             "(P, 3), the source after the voxel grid.")
      .field("target_voxels", &CloudMatches::target_voxels,
             "(Q, 3), the target after the voxel grid.")
      .field("source_voxel_size", &CloudMatches::source_voxel_size, "Metres, source frame.")
      .field("target_voxel_size", &CloudMatches::target_voxel_size, "Metres, target frame.")
      .field("noise_bound", &CloudMatches::noise_bound, "Metres, for the registration.")
      .field("filtered", &CloudMatches::filtered,
             "Whether the mutual and the ratio test were applied.")
      .field("num_radii", &CloudMatches::num_radii,
             "Feature radii whose matches were pooled: a point may have one of each.")
      .field("share_compared", &CloudMatches::share_compared,
             "Share of the source whose matches were sought before the time for it was up.")
      .field("stages", &CloudMatches::stages, "Stage -> seconds.")
      .read_only();
}

void bind_refinement(nb::module_& module) {
  Record<Refinement>(module, "Refinement", "What the refinement did to the pose of two clouds.")
      .field("method", &Refinement::method, "'icp' or 'none'.")
      .field("is_applied", &Refinement::is_applied, "Whether the pose is the refined one.")
      .field("note", &Refinement::note, "One sentence.")
      .field("noise", &Refinement::noise,
             "Standard deviation of the distance of the surfaces that meet, metres; 0 where the "
             "pose was not refined.")
      .read_only();
}

void bind_surfaces(nb::module_& module) {
  Record<WeakDirection>(module, "WeakDirection",
                        "A small motion of the source that the surfaces hardly resist.")
      .field("turn", &WeakDirection::turn, "(3,), unit axis, target frame; 0: no turn.")
      .field("shift", &WeakDirection::shift, "(3,), unit, target frame; 0 where it is a turn.")
      .field("stiffness", &WeakDirection::stiffness,
             "Mean square of the motion along the normals over that of the motion, in [0, 1].")
      .read_only();
  Record<SurfaceFit>(module, "SurfaceFit", "How the surfaces of two clouds meet under a pose.")
      .field("source_share", &SurfaceFit::source_share,
             "Share of the source that the target covers, with its normals, in [0, 1].")
      .field("target_share", &SurfaceFit::target_share,
             "Share of the target that the source covers, with its normals, in [0, 1].")
      .field("contradicted", &SurfaceFit::contradicted,
             "Share of a cloud that lies where the other sensor saw through; 0: not known.")
      .field("agreement", &SurfaceFit::agreement,
             "Share of the voxels that meet whose normals are within 26 degrees.")
      .field("noise", &SurfaceFit::noise,
             "Standard deviation of the distance along the normals, metres.")
      .field("weak_directions", &SurfaceFit::weak_directions,
             "List of WeakDirection: what the surfaces leave open, weakest first.")
      .read_only();
  Record<RivalPose>(module, "RivalPose", "Another pose at which the surfaces meet about as well.")
      .field("target_from_source", &RivalPose::target_from_source, "Similarity.")
      .field("overlap", &RivalPose::overlap, "Over that of the pose that is returned.")
      .field("is_symmetry", &RivalPose::is_symmetry,
             "Whether the source lies where it lies at the pose that is returned, to 1.5 voxels.")
      .read_only();
}

void bind_voxels(nb::module_& module) {
  Record<JudgedVoxels>(module, "JudgedVoxels", "The voxels by which all poses are judged.")
      .field("source", &JudgedVoxels::source, "(P, 3), metres.")
      .field("target", &JudgedVoxels::target, "(Q, 3), metres.")
      .field("source_voxel_size", &JudgedVoxels::source_voxel_size, "Metres, source frame.")
      .field("target_voxel_size", &JudgedVoxels::target_voxel_size, "Metres, target frame.")
      .read_only();
}

void bind_cloud_result(nb::module_& module) {
  auto result =
      Record<CloudResult>(module, "CloudResult", "Pose of two clouds, and how far to rely on it.")
          .field("registration", &CloudResult::registration,
                 "Result; its inliers are rows of matches.source.")
          .field("matches", &CloudResult::matches, "CloudMatches of the pose.")
          .field("num_source_points", &CloudResult::num_source_points, "As given.")
          .field("num_target_points", &CloudResult::num_target_points, "As given.")
          .field("voxels", &CloudResult::voxels, "JudgedVoxels: of the surfaces.")
          .field("fitness", &CloudResult::fitness,
                 "Share of the source voxels that meet the target after the transform, in [0, 1].")
          .field("distinct_evidence", &CloudResult::distinct_evidence,
                 "Distinct evidence of the inliers, whatever was maximised.")
          .field("overlap_rmse", &CloudResult::overlap_rmse,
                 "RMS distance of the voxels that meet, metres.")
          .field("target_fitness", &CloudResult::target_fitness,
                 "Share of the target voxels that meet the source, in [0, 1].")
          .field("verdict", &CloudResult::verdict, "'trusted', 'doubtful' or 'untrusted'.")
          .field("verdict_reason", &CloudResult::verdict_reason, "One sentence.")
          .field("num_attempts", &CloudResult::num_attempts, "Settings that were tried.")
          .field("refinement", &CloudResult::refinement, "What the refinement did to the pose.")
          .field("surfaces", &CloudResult::surfaces, "SurfaceFit of the pose.")
          .field("mirrored_is_better", &CloudResult::mirrored_is_better,
                 "Whether the mirrored source meets the target better: left-handed data.")
          .field("mirrored_is_worse", &CloudResult::mirrored_is_worse,
                 "Whether the mirrored source was tried and has clearly less evidence, or overlap.")
          .field("found_by_turning", &CloudResult::found_by_turning,
                 "Whether the source was turned all around, as an object that the target shows.")
          .field("rivals", &CloudResult::rivals,
                 "List of RivalPose: symmetry or repetition, best first.")
          .field("notes", &CloudResult::notes, "What is odd about the clouds, in sentences.")
          .read_only(&describe);
  result.def_prop_ro(
      "target_from_source",
      [](const CloudResult& self) { return self.registration.target_from_source; },
      "The transform of the registration.");
  add_pose(result, [](const CloudResult& self) -> const Similarity& {
    return self.registration.target_from_source;
  });
  add_pose_graph(result,
                 [](const CloudResult& self) -> const Result& { return self.registration; });
  forward_registration(result);
  add_report(result);
}

}  // namespace

void bind_clouds(nb::module_& module) {
  bind_matches(module);
  bind_refinement(module);
  bind_surfaces(module);
  bind_voxels(module);
  bind_cloud_result(module);
  module.def("match_clouds", [](const PointsArray& source, const PointsArray& target,
                                const FrontendOptions& frontend, const Options& options) {
    return interruptible(options, [&](const Options& watched) {
      return match_clouds(points_of(source), points_of(target), frontend, watched);
    });
  });
  module.def("register_clouds", [](const PointsArray& source, const PointsArray& target,
                                   const FrontendOptions& frontend, const Options& options) {
    return interruptible(options, [&](const Options& watched) {
      return register_clouds(points_of(source), points_of(target), frontend, watched);
    });
  });
  module.def("register_cloud_instances", [](const PointsArray& source, const PointsArray& target,
                                            const FrontendOptions& frontend, const Options& options,
                                            const InstanceOptions& instances) {
    return interruptible(options, [&](const Options& watched) {
      return register_cloud_instances(points_of(source), points_of(target), frontend, watched,
                                      instances);
    });
  });
  module.def("refine_clouds", [](const CloudResult& result, const PointsArray& source,
                                 const PointsArray& target, const Options& options) {
    return interruptible(options, [&](const Options& watched) {
      return refine_clouds(result, points_of(source), points_of(target), watched);
    });
  });
  module.def("with_pose", [](const CloudResult& result, const Similarity& target_from_source,
                             const Options& options) {
    const nb::gil_scoped_release no_gil;
    return with_pose(result, target_from_source, options);
  });
  module.def(
      "voxel_grid",
      [](const PointsArray& points, double voxel_size) {
        const Points means = [&] {
          const nb::gil_scoped_release no_gil;
          return voxel_grid(points_of(points), voxel_size);
        }();
        return copy(means.data(), {static_cast<std::size_t>(means.cols()), 3});
      },
      nb::sig("def voxel_grid(points: numpy.typing.NDArray[numpy.float64], voxel_size: float) -> "
              "numpy.typing.NDArray[numpy.float64]"));
  module.def(
      "fpfh",
      [](const PointsArray& points, const FrontendOptions& frontend, double voxel_size,
         int num_threads) {
        const auto features = [&] {
          const nb::gil_scoped_release no_gil;
          return fpfh(points_of(points), frontend, voxel_size, num_threads);
        }();
        return copy(features.data(), {static_cast<std::size_t>(features.cols()), features.rows()});
      },
      nb::sig("def fpfh(points: numpy.typing.NDArray[numpy.float64], frontend: FrontendOptions, "
              "voxel_size: float, "
              "num_threads: int) -> numpy.typing.NDArray[numpy.float32]"));
}

}  // namespace gmcr::python
