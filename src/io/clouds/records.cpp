#include "io/clouds/records.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

#include "io/bytes.hpp"
#include "io/tables/text.hpp"

namespace gmcr::io {
namespace {

/// The nearest number of an integer type; a plain cast is undefined outside of its range.
template <typename Number>
Number nearest(double value) {
  if constexpr (std::is_floating_point_v<Number>) {
    return static_cast<Number>(value);
  } else {
    if (std::isnan(value)) return 0;
    const double low = static_cast<double>(std::numeric_limits<Number>::min());
    const double high = static_cast<double>(std::numeric_limits<Number>::max());
    if (value <= low) return std::numeric_limits<Number>::min();
    if (value >= high) return std::numeric_limits<Number>::max();
    return static_cast<Number>(std::nearbyint(value));
  }
}

/// Calls `function` with a value of the C++ type of `type`.
template <typename Function>
auto with_type(Scalar type, Function function) {
  switch (type) {
    case Scalar::Int8:
      return function(std::int8_t{});
    case Scalar::UInt8:
      return function(std::uint8_t{});
    case Scalar::Int16:
      return function(std::int16_t{});
    case Scalar::UInt16:
      return function(std::uint16_t{});
    case Scalar::Int32:
      return function(std::int32_t{});
    case Scalar::UInt32:
      return function(std::uint32_t{});
    case Scalar::Int64:
      return function(std::int64_t{});
    case Scalar::UInt64:
      return function(std::uint64_t{});
    case Scalar::Float32:
      return function(float{});
    default:
      return function(double{});
  }
}

using Names = std::array<std::string_view, 3>;

bool is_named(const Field& field, std::string_view name, bool exactly) {
  return (exactly ? field.name : to_lower(field.name)) == name;
}

/// Indices of the single fields of these names; of a name that is there twice, `num_fields`.
std::optional<std::array<std::size_t, 3>> find_three(const std::vector<Field>& fields,
                                                     const Names& names, bool exactly) {
  std::array<std::size_t, 3> found;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto matches = [&](const Field& field) { return is_named(field, names[i], exactly); };
    const auto at = std::find_if(fields.begin(), fields.end(), matches);
    if (at == fields.end()) return std::nullopt;
    if (std::find_if(at + 1, fields.end(), matches) != fields.end()) {
      throw std::invalid_argument(io::quoted(names[i]) + " is there twice");
    }
    if (at->count != 1) throw std::invalid_argument(io::quoted(names[i]) + " has several values");
    found[i] = static_cast<std::size_t>(at - fields.begin());
  }
  return found;
}

std::string listed(const std::vector<Field>& fields) {
  std::string text;
  for (const Field& field : fields) text += (text.empty() ? "" : " ") + field.name;
  return io::quoted(text);
}

}  // namespace

bool is_float(Scalar type) { return type == Scalar::Float32 || type == Scalar::Float64; }

std::size_t size_of(Scalar type) {
  return with_type(type, [](auto number) { return sizeof(number); });
}

double load_scalar(const char* bytes, Scalar type, std::endian order) {
  return with_type(
      type, [&](auto number) { return static_cast<double>(load<decltype(number)>(bytes, order)); });
}

void append_scalar(std::string& bytes, Scalar type, double value) {
  with_type(type, [&](auto number) { append_bytes(bytes, nearest<decltype(number)>(value)); });
}

std::size_t row_bytes(const std::vector<Field>& fields) { return offset_of(fields, fields.size()); }

std::size_t offset_of(const std::vector<Field>& fields, std::size_t field) {
  std::size_t offset = 0;
  for (std::size_t i = 0; i < field; ++i) offset += size_of(fields[i].type) * fields[i].count;
  return offset;
}

std::array<std::size_t, 3> find_coordinates(const std::vector<Field>& fields) {
  constexpr Names kNames = {"x", "y", "z"};
  for (const bool exactly : {true, false}) {
    if (const auto found = find_three(fields, kNames, exactly)) return *found;
  }
  throw std::invalid_argument("no x, y and z among " + listed(fields));
}

std::optional<std::array<std::size_t, 3>> find_normal(const std::vector<Field>& fields) {
  constexpr Names kKnown[] = {{"nx", "ny", "nz"}, {"normal_x", "normal_y", "normal_z"}};
  // what is there twice, or has several values, is no normal, and no reason to refuse the points
  const auto is_one = [&](std::string_view name) {
    const auto has_name = [&](const Field& field) { return field.name == name; };
    const auto at = std::find_if(fields.begin(), fields.end(), has_name);
    return at != fields.end() && at->count == 1 && std::none_of(at + 1, fields.end(), has_name);
  };
  for (const Names& names : kKnown) {
    if (std::all_of(names.begin(), names.end(), is_one)) return find_three(fields, names, true);
  }
  return std::nullopt;
}

Points columns_of(const Records& records, const std::array<std::size_t, 3>& fields) {
  Points points(3, records.num_rows);
  const std::size_t stride = row_bytes(records.fields);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const char* at = records.bytes.data() + offset_of(records.fields, fields[axis]);
    with_type(records.fields[fields[axis]].type, [&](auto number) {
      for (Index i = 0; i < records.num_rows; ++i, at += stride) {
        points(static_cast<Index>(axis), i) = static_cast<double>(load<decltype(number)>(at));
      }
    });
  }
  return points;
}

Records records_of(const PointsRef& points) {
  Records records;
  for (const char* name : {"x", "y", "z"}) records.fields.push_back({name, Scalar::Float64, 1});
  records.num_rows = points.cols();
  for (Index i = 0; i < points.cols(); ++i) {
    for (Index j = 0; j < 3; ++j) append_bytes(records.bytes, points(j, i));
  }
  return records;
}

}  // namespace gmcr::io
