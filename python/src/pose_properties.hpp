#pragma once

#include <string>

#include "convert.hpp"

namespace gmcr::python {

/// scale, rotation, translation and matrix() of the struct's transform itself.
template <class T>
void add_pose(nb::class_<T>& bound) {
  constexpr const char* kArray = "-> numpy.typing.NDArray[numpy.float64]";
  bound
      .def_prop_ro(
          "scale", [](const T& self) { return self.target_from_source.scale; },
          "Scale of the transform, no unit.")
      .def_prop_ro(
          "rotation",
          [](const T& self) {
            return Convert<Eigen::Matrix3d>::to_python(self.target_from_source.rotation, {});
          },
          nb::sig((std::string("def rotation(self) ") + kArray).c_str()),
          "Rotation of the transform, (3, 3).")
      .def_prop_ro(
          "translation",
          [](const T& self) {
            return Convert<Eigen::Vector3d>::to_python(self.target_from_source.translation, {});
          },
          nb::sig((std::string("def translation(self) ") + kArray).c_str()),
          "Translation of the transform, (3,), metres, target frame.")
      .def(
          "matrix",
          [](const T& self) {
            return Convert<Eigen::Matrix4d>::to_python(self.target_from_source.matrix(), {});
          },
          nb::sig((std::string("def matrix(self) ") + kArray).c_str()),
          "Homogeneous matrix [s R, t; 0 0 0 1] of the transform, (4, 4).");
}

}  // namespace gmcr::python
