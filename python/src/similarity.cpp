#include "gmcr/similarity.hpp"

#include "bindings.hpp"
#include "conversion/record.hpp"
#include "gmcr/metrics.hpp"

namespace gmcr::python {
namespace {

constexpr const char* kDoc =
    R"(Similarity transform: x_target = scale * rotation @ x_source + translation.

Composition reads ``c_from_a = c_from_b @ b_from_a``.)";

nb::object apply(const Similarity& self, nb::handle points) {
  const Points images = self.apply(Convert<Points>::from_python(points, "points"));
  return copy(images.data(), {static_cast<std::size_t>(images.cols()), 3});
}

void bind_metrics(nb::module_& module) {
  module.def("rotation_error_deg", [](const Similarity& estimate, const Similarity& truth) {
    return rotation_error_deg(estimate.rotation, truth.rotation);
  });
  module.def("translation_error", [](const Similarity& estimate, const Similarity& truth) {
    return translation_error(estimate.translation, truth.translation);
  });
  module.def("scale_error", [](const Similarity& estimate, const Similarity& truth) {
    return scale_error(estimate.scale, truth.scale);
  });
  module.def("mean_point_error",
             [](const Similarity& estimate, const Similarity& truth, const PointsArray& points) {
               return mean_point_error(estimate, truth, points_of(points));
             });
}

}  // namespace

void bind_similarity(nb::module_& module) {
  Record<Similarity>(module, "Similarity", kDoc)
      .field("scale", &Similarity::scale, "Scale, > 0, no unit.")
      .field("rotation", &Similarity::rotation, "Rotation, (3, 3), orthonormal, determinant +1.")
      .field("translation", &Similarity::translation, "Translation, (3,), metres, target frame.")
      .settable()
      .def(
          "matrix",
          [](const Similarity& self) {
            return Convert<Eigen::Matrix4d>::to_python(self.matrix(), {});
          },
          nb::sig("def matrix(self) -> numpy.typing.NDArray[numpy.float64]"),
          "Homogeneous matrix [scale * rotation, translation; 0 0 0 1], (4, 4).")
      .def_static(
          "from_matrix",
          [](nb::handle matrix) {
            return Similarity::from_matrix(Convert<Eigen::Matrix4d>::from_python(matrix, "matrix"));
          },
          nb::sig("def from_matrix(matrix: numpy.typing.ArrayLike) -> Similarity"),
          "Reads a homogeneous matrix, (4, 4). ValueError where it is not a similarity to 1e-3; "
          "the\n"
          "rotation that is kept is the closest exact one.")
      .def("inverse", &Similarity::inverse, "The transform back: source from target.")
      .def("apply", &apply,
           nb::sig("def apply(self, points: numpy.typing.ArrayLike) -> "
                   "numpy.typing.NDArray[numpy.float64]"),
           "Images of points, (N, 3), metres.")
      .def(
          "__matmul__",
          [](const Similarity& self, nb::handle other) {
            Similarity b_from_a;
            if (nb::try_cast(other, b_from_a)) return self * b_from_a;
            throw nb::type_error(
                "a transform is composed by @ with a transform; write pose.apply(points) for "
                "points "
                "and gmcr.Similarity.from_matrix(matrix) for a matrix (4, 4)");
          },
          nb::sig("def __matmul__(self, other: Similarity) -> Similarity"));
  bind_metrics(module);
}

}  // namespace gmcr::python
