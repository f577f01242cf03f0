#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "conversion/arrays.hpp"
#include "conversion/interruptible.hpp"
#include "conversion/prepared_file.hpp"
#include "gmcr/prepared_cloud.hpp"

namespace gmcr::python {
namespace {

PreparedCloud prepare(const PointsArray& points, const FrontendOptions& frontend, int num_threads) {
  const nb::gil_scoped_release no_gil;
  return PreparedCloud(points_of(points), frontend, num_threads);
}

PreparedCloud from_bytes(const nb::bytes& bytes) {
  return PreparedCloud::from_bytes({bytes.c_str(), bytes.size()});
}

PreparedCloud load(const std::filesystem::path& path) {
  return load_prepared(path, &PreparedCloud::from_bytes);
}

}  // namespace

void bind_prepared(nb::module_& module) {
  nb::class_<PreparedCloud>(module, "PreparedCloud",
                            "A cloud with what matching it needs, made once and used often: see "
                            "`gmcr.prepare`.")
      .def_prop_ro(
          "points",
          [](nb::handle self) {
            const Points& points = nb::cast<const PreparedCloud&>(self).points();
            return view(points.data(), {static_cast<std::size_t>(points.cols()), 3}, self);
          },
          nb::sig("def points(self) -> numpy.typing.NDArray[numpy.float64]"),
          "(N, 3), metres, read-only.")
      .def_prop_ro("voxel_size", &PreparedCloud::voxel_size,
                   "Metres: what the cloud is matched at unless the other cloud or the options say "
                   "otherwise.")
      .def_prop_ro("normal_radius", &PreparedCloud::normal_radius, "Voxels.")
      .def_prop_ro("feature_radius", &PreparedCloud::feature_radius, "Voxels.")
      .def("beside",
           [](const PreparedCloud& self, const PointsArray& points, const FrontendOptions& frontend,
              bool is_source) {
             const nb::gil_scoped_release no_gil;
             return self.beside(points_of(points),
                                is_source ? frontend.source_viewpoint : frontend.target_viewpoint);
           })
      .def_static(
          "is_prepared",
          [](const nb::bytes& content) {
            return PreparedCloud::is_prepared({content.c_str(), content.size()});
          },
          nb::arg("content"), "Whether a content is, or begins, such a file, of whatever version.")
      .def("to_bytes", &bytes_of<PreparedCloud>, "The content of its file.")
      .def_static("from_bytes", &from_bytes, nb::arg("content"),
                  "The cloud of such a content. Raises ValueError where it does not fit.")
      .def("save", &save_prepared<PreparedCloud>, nb::arg("path"),
           nb::sig("def save(self, path: str | os.PathLike[str]) -> None"),
           "Writes the file, whole or not at all: a PLY with more in it, which reads as a cloud.")
      .def_static("load", &load, nb::arg("path"),
                  nb::sig("def load(path: str | os.PathLike[str]) -> PreparedCloud"),
                  "Reads such a file. Raises OSError where it is missing, of another version, cut "
                  "or changed.")
      .def("__getstate__", &bytes_of<PreparedCloud>)
      .def("__setstate__",
           [](PreparedCloud& self, const nb::bytes& state) {
             new (&self) PreparedCloud(from_bytes(state));
           })
      .def("__repr__", [](const PreparedCloud& self) {
        const nb::str format("PreparedCloud({} points, voxel_size={:.4g})");
        return nb::cast<std::string>(
            format.attr("format")(self.points().cols(), self.voxel_size()));
      });
  module.def("prepare", &prepare,
             nb::sig("def prepare(points: numpy.typing.NDArray[numpy.float64], "
                     "frontend: FrontendOptions, num_threads: int) -> PreparedCloud"));
  module.def("match_prepared", [](const PreparedCloud& source, const PreparedCloud& target,
                                  const FrontendOptions& frontend, const Options& options) {
    return interruptible(options, [&](const Options& watched) {
      return match_clouds(source, target, frontend, watched);
    });
  });
  module.def("register_prepared", [](const PreparedCloud& source, const PreparedCloud& target,
                                     const FrontendOptions& frontend, const Options& options) {
    return interruptible(options, [&](const Options& watched) {
      return register_clouds(source, target, frontend, watched);
    });
  });
}

}  // namespace gmcr::python
