#pragma once

#include <nanobind/stl/optional.h>

#include <optional>
#include <stdexcept>
#include <string>

#include "conversion/convert.hpp"
#include "gmcr/registration.hpp"

namespace gmcr::python {

/// scale, rotation, translation and matrix() of a transform of the struct.
/// @param pose_of  from T to its Similarity.
template <class T, class PoseOf>
void add_pose(nb::class_<T>& bound, PoseOf pose_of) {
  constexpr const char* kArray = "-> numpy.typing.NDArray[numpy.float64]";
  bound
      .def_prop_ro(
          "scale", [pose_of](const T& self) { return pose_of(self).scale; },
          "Scale of the transform, no unit.")
      .def_prop_ro(
          "rotation",
          [pose_of](const T& self) {
            return Convert<Eigen::Matrix3d>::to_python(pose_of(self).rotation, {});
          },
          nb::sig((std::string("def rotation(self) ") + kArray).c_str()),
          "Rotation of the transform, (3, 3).")
      .def_prop_ro(
          "translation",
          [pose_of](const T& self) {
            return Convert<Eigen::Vector3d>::to_python(pose_of(self).translation, {});
          },
          nb::sig((std::string("def translation(self) ") + kArray).c_str()),
          "Translation of the transform, (3,), metres, target frame.")
      .def(
          "matrix",
          [pose_of](const T& self) {
            return Convert<Eigen::Matrix4d>::to_python(pose_of(self).matrix(), {});
          },
          nb::sig((std::string("def matrix(self) ") + kArray).c_str()),
          "Homogeneous matrix [s R, t; 0 0 0 1] of the transform, (4, 4).");
}

/// The same of the struct's transform itself.
template <class T>
void add_pose(nb::class_<T>& bound) {
  add_pose(bound, [](const T& self) -> const Similarity& { return self.target_from_source; });
}

/// runner_up_ratio and pose_graph_covariance() of a result of the struct.
/// @param result_of  from T to its Result.
template <class T, class ResultOf>
void add_pose_graph(nb::class_<T>& bound, ResultOf result_of) {
  bound.def_prop_ro(
      "runner_up_ratio", [result_of](const T& self) { return result_of(self).runner_up_ratio(); },
      "Evidence of the best alternative over that of the result; near 1: ambiguous.");
  bound.def(
      "pose_graph_covariance",
      [result_of](const T& self, const std::optional<std::string>& convention) -> nb::object {
        if (!convention) {
          throw nb::type_error(
              "pose_graph_covariance() needs the convention of the pose graph: 'gtsam' or 'ros'");
        }
        if (convention != "gtsam" && convention != "ros") {
          throw std::invalid_argument("convention: '" + *convention + "' is not 'gtsam' or 'ros'");
        }
        const Result& result = result_of(self);
        if (!result.covariance) return nb::none();
        const Eigen::MatrixXd matrix =
            pose_graph_covariance(*result.covariance, result.target_from_source,
                                  convention == "ros" ? PoseGraph::Ros : PoseGraph::Gtsam);
        return Convert<Eigen::MatrixXd>::to_python(matrix, nb::handle());
      },
      nb::arg("convention") = nb::none(),
      nb::sig("def pose_graph_covariance(self, convention: typing.Literal['gtsam', 'ros']) -> "
              "numpy.typing.NDArray[numpy.float64] | None"),
      "(6, 6) covariance of the rotation and the translation as a pose graph wants it, or None.\n\n"
      "'gtsam': of T in T Exp(xi), rotation first, in the frame of the source.\n"
      "'ros': geometry_msgs/PoseWithCovariance, translation first, axes of the target frame.");
}

}  // namespace gmcr::python
