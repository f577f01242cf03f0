#pragma once

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <string_view>

namespace gmcr::fuzz {

/// Choices and numbers out of bytes; zeros where these are used up.
class Bytes {
 public:
  explicit Bytes(std::string_view bytes) : bytes_(bytes) {}

  bool empty() const { return bytes_.empty(); }

  template <typename Number>
  Number raw() {
    Number number{};
    const std::size_t count = std::min(sizeof number, bytes_.size());
    if (count > 0) std::memcpy(&number, bytes_.data(), count);
    bytes_.remove_prefix(count);
    return number;
  }

  std::size_t below(std::size_t limit) { return raw<std::uint8_t>() % limit; }
  bool flag() { return below(2) == 1; }

  /// Numbers of the kinds that programs stumble on, and plain ones.
  double number() {
    constexpr double kOdd[] = {0.0,
                               -0.0,
                               1e50,
                               -1e50,
                               1e-50,
                               9e-51,
                               1.1e50,
                               1e154,
                               1e-162,
                               1e-310,
                               DBL_MAX,
                               -DBL_MAX,
                               DBL_MIN,
                               FLT_MAX,
                               1e20,
                               DBL_EPSILON,
                               std::numeric_limits<double>::quiet_NaN(),
                               std::numeric_limits<double>::infinity(),
                               -std::numeric_limits<double>::infinity()};
    const auto whole = [&] { return static_cast<double>(raw<std::int8_t>()); };
    switch (below(8)) {
      case 0:
        return last_ = whole();
      case 1:
        return last_ = 0.001 * whole();
      case 2:
        return last_ = raw<float>();
      case 3:
        return last_ = raw<double>();
      case 4:
        return last_ = kOdd[below(std::size(kOdd))];
      case 5:
        return last_ = 0.01 * raw<std::int16_t>();
      case 6: {
        const double mantissa = whole();
        return last_ = mantissa * std::pow(10.0, whole() / 2);
      }
      default:
        return last_;
    }
  }

 private:
  std::string_view bytes_;
  double last_ = 1;
};

}  // namespace gmcr::fuzz
