#pragma once

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <string>
#include <tuple>
#include <type_traits>
#include <utility>

#include "geometry/angles.hpp"
#include "gmcr/options.hpp"

namespace gmcr::options {

/// Which numbers an option may be: itself, the elements of a list, or the length of a vector.
struct Range {
  bool (*holds)(double) = nullptr;  ///< null: any; of a vector that is not finite it gets NaN
  const char* words = "";           ///< as in "0 is not ..."
};

inline constexpr double kInfinity = std::numeric_limits<double>::infinity();

inline constexpr Range kAny{};
inline constexpr Range kPositive{[](double v) { return v > 0 && std::isfinite(v); },
                                 "positive and finite"};
/// What a solve computes with; see `kLeastMagnitude`.
constexpr bool is_magnitude(double v) { return v >= kLeastMagnitude && v <= kLargestMagnitude; }
inline constexpr Range kMagnitude{is_magnitude, "in [1e-50, 1e50]"};
inline constexpr Range kPlace{[](double v) { return v == 0 || is_magnitude(v); },
                              "0 or in [1e-50, 1e50]"};
inline constexpr Range kReach{[](double v) { return is_magnitude(v) || v == kInfinity; },
                              "positive, in [1e-50, 1e50] or infinite"};
inline constexpr Range kReachOrNone{
    [](double v) { return v == 0 || is_magnitude(v) || v == kInfinity; },
    "at least 0, in [1e-50, 1e50] or infinite"};
inline constexpr Range kNotNegative{[](double v) { return v >= 0 && std::isfinite(v); },
                                    "at least 0 and finite"};
inline constexpr Range kAboveZero{[](double v) { return v > 0; }, "positive"};
inline constexpr Range kZeroOrMore{[](double v) { return v >= 0; }, "at least 0"};
inline constexpr Range kOneOrMore{[](double v) { return v >= 1; }, "at least 1"};
inline constexpr Range kThreeOrMore{[](double v) { return v >= 3; }, "at least 3"};
inline constexpr Range kShare{[](double v) { return v >= 0 && v <= 1; }, "in [0, 1]"};
inline constexpr Range kRatio{[](double v) { return v > 0 && v <= 1; }, "in (0, 1]"};
inline constexpr Range kThreads{[](double v) { return v >= 0 && v <= 1024; }, "in [0, 1024]"};
/// pi itself may come rounded.
inline constexpr Range kAngle{
    [](double v) { return v >= 0 && v <= std::numbers::pi + geometry::kAngleSlack; }, "in [0, pi]"};
inline constexpr Range kDirection{is_magnitude, "a vector of a length in [1e-50, 1e50]"};
inline constexpr Range kFinite{[](double v) { return std::isfinite(v); }, "finite"};

/// What is known of an option, but for its place.
struct About {
  /// That of the member in C++ and of the field in Python and JSON; `--name`, with dashes for
  /// underscores and dots, on the command line.
  const char* name;
  const char* help;        ///< a sentence or two without a full stop, for Python and --help
  const char* unit = "";   ///< "metres", "radians", "seconds", "bytes" or "voxels"
  const char* group = "";  ///< headline in --help
  Range range = kAny;
  const char* alias = "";  ///< of the command line, without its two dashes
};

/// An option of a struct: a pointer to the member, and what is known of it.
template <class Place>
struct Option {
  Place place;
  About about;
};
template <class Place>
Option(Place, About) -> Option<Place>;

/// The options of a struct, as `options`, a tuple of `Option`; see table.hpp.
template <class Struct>
struct Table;

template <class T>
concept HasTable = requires {
  Table<T>::options;
};

/// A name that is an option no more, and what to do instead.
struct Gone {
  const char* name;
  const char* advice;
};

/// What a table has unless it says otherwise.
struct TableDefaults {
  static constexpr Gone gone[] = {{"", ""}};

  /// Whether an option has a say beside the others.
  template <class Struct>
  static bool is_used(const Struct&, const std::string&) {
    return true;
  }
};

/// Calls `visit(option)` for each option of `Struct`, in order.
template <class Struct, class Visitor>
void for_each_option(Visitor&& visit) {
  std::apply([&](const auto&... option) { (visit(option), ...); }, Table<Struct>::options);
}

template <class Struct, class Place>
using ValueOf = std::remove_cvref_t<std::invoke_result_t<Place, Struct&>>;

/// "Seconds for the search (seconds, positive)".
inline std::string describe(const About& about) {
  const std::string unit = about.unit, range = about.range.words;
  const std::string remark = unit + (unit.empty() || range.empty() ? "" : ", ") + range;
  return about.help + (remark.empty() ? "" : " (" + remark + ")");
}

}  // namespace gmcr::options
