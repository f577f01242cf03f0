#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <limits>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "gmcr/invalid_option.hpp"
#include "gmcr/similarity.hpp"
#include "options/table.hpp"

namespace gmcr::options {

/// "VALUE RULE", such as "0 is not positive", where it does not hold.
template <class Value>
void require(bool holds, const std::string& name, const Value& value, const std::string& rule) {
  if (holds) return;
  std::ostringstream problem;
  problem << value << ' ' << rule;
  throw InvalidOption(name, problem.str());
}

template <class Value>
void check(const std::string& name, const Value& value, const Range& range) {
  if constexpr (std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>) {
    if (!range.holds) return;
    require(range.holds(static_cast<double>(value)), name, value,
            std::string("is not ") + range.words);
  }
}

template <class Value>
void check(const std::string& name, const std::vector<Value>& values, const Range& range) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    check(name + "[" + std::to_string(i) + "]", values[i], range);
  }
}

inline void check(const std::string& name, const Eigen::Vector3d& vector, const Range& range) {
  const double length = vector.allFinite()
                            ? std::min(vector.stableNorm(), std::numeric_limits<double>::max())
                            : std::numeric_limits<double>::quiet_NaN();
  if (!range.holds) return;
  require(range.holds(length), name, vector.transpose(), std::string("is not ") + range.words);
}

void check(const std::string& name, const ScaleRange& range, const Range&);
void check(const std::string& name, const Similarity& pose, const Range&);

template <class Struct>
void check_ranges(const Struct& values, const std::string& prefix = "");

template <class Value>
void check(const std::string& name, const std::optional<Value>& value, const Range& range) {
  if (!value) return;
  if constexpr (HasTable<Value>) {
    check_ranges(*value, name + ".");
  } else {
    check(name, *value, range);
  }
}

/// That each option by itself is in its range.
/// @param prefix  of the names.
/// @throws InvalidOption where one is not.
template <class Struct>
void check_ranges(const Struct& values, const std::string& prefix) {
  for_each_option<Struct>([&](const auto& option) {
    check(prefix + option.about.name, std::invoke(option.place, values), option.about.range);
  });
}

}  // namespace gmcr::options
