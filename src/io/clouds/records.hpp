#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gmcr/types.hpp"

namespace gmcr::io {

/// Types of numbers that point files hold.
enum class Scalar { Int8, UInt8, Int16, UInt16, Int32, UInt32, Int64, UInt64, Float32, Float64 };

bool is_float(Scalar type);
std::size_t size_of(Scalar type);

/// The number of that type at `bytes`, which hold it.
double load_scalar(const char* bytes, Scalar type, std::endian order = std::endian::little);

/// Appends the number of that type that is nearest to `value`, little-endian; NaN is 0 as an
/// integer.
void append_scalar(std::string& bytes, Scalar type, double value);

/// A named value of each point, or `count` of them.
struct Field {
  std::string name;
  Scalar type = Scalar::Float32;
  std::size_t count = 1;
};

/// The points of a file with all that it says of each, as a table of bytes.
struct Records {
  std::vector<Field> fields;
  Index num_rows = 0;
  Index height = 1;   ///< rows of the sensor's image; 1: not organised
  std::string bytes;  ///< the rows one after the other, their fields in order, little-endian
};

/// Bytes of one row.
std::size_t row_bytes(const std::vector<Field>& fields);

/// Where x, y and z stand among the fields, by name, in lower case or else in any.
/// @throws std::invalid_argument where one is missing, there twice, or of several values.
std::array<std::size_t, 3> find_coordinates(const std::vector<Field>& fields);

/// Where the three components of a normal stand, or nullopt.
std::optional<std::array<std::size_t, 3>> find_normal(const std::vector<Field>& fields);

/// Byte of a row at which a field starts.
std::size_t offset_of(const std::vector<Field>& fields, std::size_t field);

/// Three single fields of every row, 3 x num_rows.
Points columns_of(const Records& records, const std::array<std::size_t, 3>& fields);

/// Records of points alone, float64.
Records records_of(const PointsRef& points);

}  // namespace gmcr::io
