#include "gmcr/synthetic.hpp"

#include "bindings.hpp"
#include "conversion/option_record.hpp"
#include "conversion/pose_properties.hpp"

namespace gmcr::python {

void bind_synthetic(nb::module_& module) {
  bind_checked_options<SyntheticOptions>(module, "SyntheticOptions",
                                         "A random registration problem, up to its seed.");
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
