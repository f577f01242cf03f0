#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/string.h>

#include <Eigen/Core>
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::python {

namespace nb = nanobind;

/// (N, 3), float64, C order: what binds to `PointsRef` without a copy.
using PointsArray =
    nb::ndarray<const double, nb::numpy, nb::shape<-1, 3>, nb::c_contig, nb::device::cpu>;

inline Eigen::Map<const Points> points_of(const PointsArray& array) {
  return {array.data(), 3, static_cast<Index>(array.shape(0))};
}

/// @throws std::invalid_argument "name: expected SHAPE" where it does not hold.
inline void require_shape(bool holds, const char* name, const char* shape) {
  if (!holds) throw std::invalid_argument(std::string(name) + ": expected " + shape);
}

/// Read-only array of `data` that keeps `owner` alive.
template <class Scalar>
nb::object view(const Scalar* data, std::initializer_list<std::size_t> shape, nb::handle owner) {
  return nb::cast(nb::ndarray<nb::numpy, const Scalar>(data, shape, owner));
}

/// New array with the values of `data`, in C order.
template <class Scalar>
nb::object copy(const Scalar* data, std::initializer_list<std::size_t> shape) {
  std::size_t size = 1;
  for (const std::size_t extent : shape) size *= extent;
  auto* values = new Scalar[size];
  std::copy_n(data, size, values);
  const nb::capsule owner(values,
                          [](void* memory) noexcept { delete[] static_cast<Scalar*>(memory); });
  return nb::cast(nb::ndarray<nb::numpy, Scalar>(values, shape, owner));
}

/// Whatever numpy can read as numbers, as float64 in C order.
/// @throws std::invalid_argument naming the field where it cannot.
nb::ndarray<const double, nb::numpy, nb::c_contig> doubles_of(nb::handle value, const char* name);

/// The same as integers.
nb::ndarray<const Index, nb::numpy, nb::c_contig> indices_of(nb::handle value, const char* name);

template <class T, class>
struct Convert;

/// Points: (N, 3), a view.
template <>
struct Convert<Points, void> {
  static std::string type() { return "numpy.typing.NDArray[numpy.float64]"; }
  static std::string accepted() { return "numpy.typing.ArrayLike"; }
  static nb::object to_python(const Points& points, nb::handle owner) {
    return view(points.data(), {static_cast<std::size_t>(points.cols()), 3}, owner);
  }
  static Points from_python(nb::handle value, const char* name) {
    const auto array = doubles_of(value, name);
    require_shape(array.ndim() == 2 && array.shape(1) == 3, name, "shape (N, 3)");
    return Eigen::Map<const Points>(array.data(), 3, static_cast<Index>(array.shape(0)));
  }
};

/// Other matrices: rows and columns as they are, a copy. Vectors: (n,).
template <int Rows, int Columns>
struct Convert<Eigen::Matrix<double, Rows, Columns>, void> {
  using Matrix = Eigen::Matrix<double, Rows, Columns>;
  static constexpr bool kIsVector = Columns == 1;

  static std::string type() { return "numpy.typing.NDArray[numpy.float64]"; }
  static std::string accepted() { return "numpy.typing.ArrayLike"; }
  static nb::object to_python(const Matrix& matrix, nb::handle) {
    const auto rows = static_cast<std::size_t>(matrix.rows());
    const auto columns = static_cast<std::size_t>(matrix.cols());
    if constexpr (kIsVector) {
      return copy(matrix.data(), {rows});
    } else {
      const Eigen::Matrix<double, Rows, Columns, Eigen::RowMajor> by_rows = matrix;
      return copy(by_rows.data(), {rows, columns});
    }
  }
  static Matrix from_python(nb::handle value, const char* name) {
    const auto array = doubles_of(value, name);
    if constexpr (kIsVector) {
      const bool fits = array.ndim() == 1 && (Rows < 0 || array.shape(0) == std::size_t(Rows));
      require_shape(fits, name, Rows == 3 ? "shape (3,)" : "one dimension");
      return Eigen::Map<const Matrix>(array.data(), static_cast<Index>(array.shape(0)));
    } else {
      const bool fits = array.ndim() == 2 && (Rows < 0 || array.shape(0) == std::size_t(Rows)) &&
                        (Columns < 0 || array.shape(1) == std::size_t(Columns));
      require_shape(fits, name, Rows == 3 ? "shape (3, 3)" : "a matrix");
      return Eigen::Map<const Eigen::Matrix<double, Rows, Columns, Eigen::RowMajor>>(
          array.data(), static_cast<Index>(array.shape(0)), static_cast<Index>(array.shape(1)));
    }
  }
};

template <>
struct Convert<std::vector<double>, void> {
  static std::string type() { return "numpy.typing.NDArray[numpy.float64]"; }
  static std::string accepted() { return "numpy.typing.ArrayLike | None"; }
  static nb::object to_python(const std::vector<double>& values, nb::handle) {
    return copy(values.data(), {values.size()});
  }
  static std::vector<double> from_python(nb::handle value, const char* name) {
    if (value.is_none()) return {};
    const auto array = doubles_of(value, name);
    require_shape(array.ndim() == 1, name, "one dimension");
    return {array.data(), array.data() + array.size()};
  }
};

/// Indices: (n,) int64, a view.
template <>
struct Convert<std::vector<Index>, void> {
  static std::string type() { return "numpy.typing.NDArray[numpy.int64]"; }
  static std::string accepted() { return "numpy.typing.ArrayLike | None"; }
  static nb::object to_python(const std::vector<Index>& values, nb::handle owner) {
    return view(values.data(), {values.size()}, owner);
  }
  static std::vector<Index> from_python(nb::handle value, const char* name) {
    if (value.is_none()) return {};
    const auto array = indices_of(value, name);
    require_shape(array.ndim() == 1, name, "one dimension");
    return {array.data(), array.data() + array.size()};
  }
};

template <>
struct Convert<std::vector<bool>, void> {
  static std::string type() { return "numpy.typing.NDArray[numpy.bool_]"; }
  static std::string accepted() { return "numpy.typing.ArrayLike"; }
  static nb::object to_python(const std::vector<bool>& values, nb::handle) {
    const Eigen::Array<bool, Eigen::Dynamic, 1> bytes =
        Eigen::Array<bool, Eigen::Dynamic, 1>::NullaryExpr(
            static_cast<Index>(values.size()),
            [&](Index i) { return values[static_cast<std::size_t>(i)]; });
    return copy(bytes.data(), {values.size()});
  }
  static std::vector<bool> from_python(nb::handle value, const char* name) {
    const auto array = indices_of(value, name);
    require_shape(array.ndim() == 1, name, "one dimension");
    return std::vector<bool>(array.data(), array.data() + array.size());
  }
};

}  // namespace gmcr::python
