#include <nanobind/stl/filesystem.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/vector.h>

#include <optional>

#include "bindings.hpp"
#include "conversion/arrays.hpp"
#include "gmcr/io.hpp"

namespace gmcr::python {
namespace {

namespace fs = std::filesystem;

nb::object rows_of(const Points& points) {
  return copy(points.data(), {static_cast<std::size_t>(points.cols()), 3});
}

nb::tuple read_cloud_file(const fs::path& path, std::optional<Index> mesh_points,
                          std::optional<Index> bin_columns) {
  CloudOptions options;
  options.mesh_points = mesh_points.value_or(options.mesh_points);
  options.bin_columns = bin_columns.value_or(options.bin_columns);
  const Cloud cloud = [&] {
    const nb::gil_scoped_release no_gil;
    return read_cloud(path, options);
  }();
  return nb::make_tuple(rows_of(cloud.points), cloud.num_dropped, cloud.notes);
}

nb::tuple read_matches_file(const fs::path& path) {
  const Matches matches = [&] {
    const nb::gil_scoped_release no_gil;
    return read_matches(path);
  }();
  const nb::object bounds = matches.noise_bounds.empty()
                                ? nb::none()
                                : copy(matches.noise_bounds.data(), {matches.noise_bounds.size()});
  return nb::make_tuple(rows_of(matches.source), rows_of(matches.target), bounds, matches.notes);
}

}  // namespace

void bind_files(nb::module_& module) {
  // NOLINTNEXTLINE(bugprone-throw-keyword-missing,bugprone-unused-raii): it registers the class
  nb::exception<IoError>(module, "CloudFileError", PyExc_OSError);
  module.def("cloud_extensions", &cloud_extensions, "Extensions of the files that are read.");
  module.def("written_cloud_extensions", &written_cloud_extensions,
             "Extensions of the files that are written.");
  module.def("read_cloud", &read_cloud_file, nb::arg("path"), nb::arg("mesh_points").none(),
             nb::arg("bin_columns").none(),
             nb::sig("def read_cloud(path: os.PathLike[str], mesh_points: int | None, "
                     "bin_columns: int | None) -> tuple[numpy.typing.NDArray[numpy.float64], int, "
                     "list[str]]"),
             "Points, how many of the file were dropped, and notes.");
  module.def(
      "write_cloud",
      [](const fs::path& path, const PointsArray& points) { write_cloud(path, points_of(points)); },
      nb::arg("path"), nb::arg("points"),
      nb::sig("def write_cloud(path: os.PathLike[str], "
              "points: numpy.typing.NDArray[numpy.float64]) -> None"));
  module.def("read_matches", &read_matches_file, nb::arg("path"),
             nb::sig("def read_matches(path: os.PathLike[str]) -> "
                     "tuple[numpy.typing.NDArray[numpy.float64], "
                     "numpy.typing.NDArray[numpy.float64], "
                     "numpy.typing.NDArray[numpy.float64] | None, list[str]]"),
             "Source, target, noise bounds and notes.");
}

}  // namespace gmcr::python
