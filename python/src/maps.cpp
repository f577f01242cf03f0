#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/string.h>

#include "bindings.hpp"
#include "conversion/arrays.hpp"
#include "conversion/interruptible.hpp"
#include "conversion/prepared_file.hpp"
#include "gmcr/localisation.hpp"

namespace gmcr::python {
namespace {

PreparedMap prepare_map(const PointsArray& points, const FrontendOptions& frontend, nb::handle up,
                        int num_threads) {
  const auto direction = Convert<Eigen::Vector3d>::from_python(up, "up");
  const nb::gil_scoped_release no_gil;
  return PreparedMap(points_of(points), frontend, direction, num_threads);
}

PreparedMap load(const std::filesystem::path& path, nb::handle up) {
  const auto direction = Convert<Eigen::Vector3d>::from_python(up, "up");
  return load_prepared(
      path, [&](const std::string& bytes) { return PreparedMap::from_bytes(bytes, direction); });
}

}  // namespace

void bind_maps(nb::module_& module) {
  nb::class_<PreparedMap>(module, "PreparedMap",
                          "A large cloud that scans are sought in, with what that needs: see "
                          "`gmcr.prepare_map`.")
      .def_prop_ro(
          "points",
          [](nb::handle self) {
            const Points& points = nb::cast<const PreparedMap&>(self).points();
            return view(points.data(), {static_cast<std::size_t>(points.cols()), 3}, self);
          },
          nb::sig("def points(self) -> numpy.typing.NDArray[numpy.float64]"),
          "(M, 3), metres, read-only: the map on voxels of half the size.")
      .def_prop_ro("voxel_size", &PreparedMap::voxel_size, "Metres: what scans are matched at.")
      .def_prop_ro(
          "up",
          [](const PreparedMap& self) {
            return Convert<Eigen::Vector3d>::to_python(self.up(), {});
          },
          nb::sig("def up(self) -> numpy.typing.NDArray[numpy.float64]"), "(3,), unit.")
      .def("save", &save_prepared<PreparedMap>, nb::arg("path"),
           nb::sig("def save(self, path: str | os.PathLike[str]) -> None"),
           "Writes the file, whole or not at all: a PLY that reads as a cloud.")
      .def_static("load", &load, nb::arg("path"), nb::arg("up") = nb::make_tuple(0.0, 0.0, 1.0),
                  nb::sig("def load(path: str | os.PathLike[str], up: numpy.typing.ArrayLike = (0, "
                          "0, 1)) -> PreparedMap"),
                  "Reads such a file, which does not say which way is up. Raises OSError where it "
                  "is missing, of another version, cut or changed.")
      .def("__repr__", [](const PreparedMap& self) {
        const nb::str format("PreparedMap({} points, voxel_size={:.4g})");
        return nb::cast<std::string>(
            format.attr("format")(self.points().cols(), self.voxel_size()));
      });
  module.def("prepare_map", &prepare_map,
             nb::sig("def prepare_map(points: numpy.typing.NDArray[numpy.float64], frontend: "
                     "FrontendOptions, up: numpy.typing.ArrayLike, num_threads: int) -> "
                     "PreparedMap"));
  module.def("localise_scan", [](const PointsArray& scan, const PreparedMap& map,
                                 const FrontendOptions& frontend, const Options& options) {
    return interruptible(options, [&](const Options& watched) {
      return localise_scan(points_of(scan), map, frontend, watched);
    });
  });
}

}  // namespace gmcr::python
