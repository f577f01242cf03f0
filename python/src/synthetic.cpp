#include "gmcr/synthetic.hpp"

#include "bindings.hpp"
#include "pose_properties.hpp"
#include "record.hpp"

namespace gmcr::python {

void bind_synthetic(nb::module_& module) {
  Record<SyntheticOptions>(module, "SyntheticOptions",
                           "A random registration problem, up to its seed.")
      .field("kind", &SyntheticOptions::kind, "'ball', 'random' or 'structured'.")
      .field("num_correspondences", &SyntheticOptions::num_correspondences, ">= 0.")
      .field("outlier_rate", &SyntheticOptions::outlier_rate, "In [0, 1].")
      .field("seed", &SyntheticOptions::seed, ">= 0.")
      .field("noise_shape", &SyntheticOptions::noise_shape, "'ball', 'gaussian' or 'cube'.")
      .field("noise_extent", &SyntheticOptions::noise_extent,
             "Metres, >= 0: radius of the ball, three standard deviations, or half an edge.")
      .field("noise_bound", &SyntheticOptions::noise_bound,
             "Bound of the error of every inlier, metres, at least the largest noise.")
      .field("scale_range", &SyntheticOptions::scale_range, "(min, max) to draw the scale from.")
      .field("max_translation", &SyntheticOptions::max_translation, "Metres, an axis, >= 0.")
      .field("num_cloud_points", &SyntheticOptions::num_cloud_points,
             "Points of the source cloud ('random', 'structured').")
      .field("num_sphere_points", &SyntheticOptions::num_sphere_points,
             "Points without a partner, on the sphere around the target.")
      .field("num_bases", &SyntheticOptions::num_bases,
             "Clusters of outliers ('structured'); 0: from the outlier rate.")
      .field("source_neighbours", &SyntheticOptions::source_neighbours,
             "A cluster's sources: the base and its nearest points.")
      .field("target_neighbours", &SyntheticOptions::target_neighbours,
             "A cluster's targets, >= source_neighbours.")
      .field("association_neighbours", &SyntheticOptions::association_neighbours,
             "An inlier's target is one of that many points near the true one; 0: the true one.")
      .settable()
      .def("validate", &SyntheticOptions::validate,
           "Raises ValueError naming the field and its value where one is out of range.");
  auto problem =
      Record<SyntheticProblem>(module, "SyntheticProblem", "Correspondences with their truth.")
          .field("source", &SyntheticProblem::source, "(N, 3), metres, read only.")
          .field("target", &SyntheticProblem::target, "(N, 3), metres, read only.")
          .field("target_from_source", &SyntheticProblem::target_from_source, "The truth.")
          .field("is_inlier", &SyntheticProblem::is_inlier,
                 "(N,) bool: the target is within the noise bound of the truth.")
          .field("noise_bound", &SyntheticProblem::noise_bound, "Metres.")
          .read_only();
  add_pose(problem);
  module.def("paper_random_options", &paper_random_options,
             "Options of the paper's random benchmark: N = 80, noise bound 0.02 m, scales 1 to 5.");
  module.def("paper_structured_options", &paper_structured_options,
             "Options of the paper's structured benchmark: N = 90, noise bound 0.07 m.");
  module.def("make_synthetic", [](const SyntheticOptions& options) {
    const nb::gil_scoped_release no_gil;
    return make_synthetic(options);
  });
  module.def("make_synthetic", [](const SyntheticOptions& options, const PointsArray& model) {
    const nb::gil_scoped_release no_gil;
    return make_synthetic(options, points_of(model));
  });
}

}  // namespace gmcr::python
