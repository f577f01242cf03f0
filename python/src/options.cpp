#include "gmcr/options.hpp"

#include "bindings.hpp"
#include "conversion/option_record.hpp"

namespace gmcr::python {

namespace {

constexpr const char* kOptionsDoc =
    R"(Every choice of a registration. Keywords only; the defaults are those of the C++ library.

>>> options = gmcr.Options(noise_bound=0.02, scale_mode="estimated")
>>> options.time_limit = 10)";

}  // namespace

void bind_options(nb::module_& module) {
  bind_options_of<GravityPrior>(
      module, "GravityPrior",
      "The direction of gravity, or of any other known axis, in both frames: the rotation turns\n"
      "one onto the other, up to a tilt.");
  bind_options_of<InitialPose>(
      module, "InitialPose",
      "A pose that the transform is known to be near. Its scale is not used.");
  bind_checked_options<Options>(module, "Options", kOptionsDoc)
      .def(
          "admit",
          [](const Options& options, const Similarity& pose) { return options.admit(pose); },
          nb::arg("target_from_source"),
          "Whether gravity, initial_pose and max_translation admit a transform, to rounding.");
  bind_checked_options<FrontendOptions>(
      module, "FrontendOptions",
      "How clouds become correspondences. Lengths are in voxels, so that one\n"
      "set of defaults serves objects and cities.");
  bind_checked_options<InstanceOptions>(module, "InstanceOptions",
                                        "When the search for further instances ends.");
}

}  // namespace gmcr::python
