#pragma once

#include <nanobind/nanobind.h>

#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include "conversion/arrays.hpp"
#include "conversion/choices.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"

namespace gmcr::python {

/// "name: 'x' is not a number" and the like, for values of a wrong type.
[[noreturn]] inline void refuse(const char* name, nb::handle value, const std::string& expected) {
  constexpr std::size_t kLongest = 60;
  auto shown = nb::cast<std::string>(nb::repr(value));
  if (shown.size() > kLongest) {
    shown = "a value of type " + nb::cast<std::string>(value.type().attr("__name__"));
  }
  throw nb::type_error((std::string(name) + ": " + shown + " is not " + expected).c_str());
}

/// How an object of a class is made, as one would write it: "Similarity(scale=1, ...)".
inline std::string made_like(const std::string& class_name) {
  return nb::cast<std::string>(nb::module_::import_("gmcr._hints").attr("made_like")(class_name));
}

/// How a field of type T looks in Python: its type in the stub, the value of a field, and the field
/// from a value. `owner` is the Python object that the field belongs to; large arrays are views
/// that keep it alive.
///
/// This one: numbers, texts, and structs that are bound themselves.
template <class T, class = void>
struct Convert {
  static std::string type() {
    if constexpr (std::is_same_v<T, bool>) return "bool";
    if constexpr (std::is_floating_point_v<T>) return "float";
    if constexpr (std::is_integral_v<T>) return "int";
    if constexpr (std::is_same_v<T, std::string>) return "str";
    if constexpr (std::is_class_v<T> && !std::is_same_v<T, std::string>) {
      return nb::cast<std::string>(nb::type<T>().attr("__name__"));
    }
  }
  static std::string accepted() { return type(); }
  static nb::object to_python(const T& value, nb::handle) {
    return nb::cast(value, nb::rv_policy::copy);
  }
  static T from_python(nb::handle value, const char* name) {
    T out;
    if (!nb::try_cast(value, out)) refuse(name, value, expected());
    return out;
  }

 private:
  /// The type in words, for messages.
  static std::string expected() {
    if constexpr (std::is_same_v<T, bool>) return "True or False";
    if constexpr (std::is_floating_point_v<T>) return "a number";
    if constexpr (std::is_unsigned_v<T>) return "a whole number >= 0";
    if constexpr (std::is_integral_v<T>) return "a whole number";
    if constexpr (std::is_same_v<T, std::string>) return "a str";
    if constexpr (!std::is_arithmetic_v<T>)
      return "a gmcr." + type() + "; write gmcr." + made_like(type());
  }
};

/// A transform may be given as whatever holds one, such as a homogeneous matrix.
template <>
struct Convert<Similarity> {
  static std::string type() { return "Similarity"; }
  static std::string accepted() { return "gmcr._arguments.PoseLike"; }
  static nb::object to_python(const Similarity& value, nb::handle) {
    return nb::cast(value, nb::rv_policy::copy);
  }
  static Similarity from_python(nb::handle value, const char* name) {
    Similarity pose;
    if (nb::try_cast(value, pose)) return pose;
    return nb::cast<Similarity>(
        nb::module_::import_("gmcr._arguments").attr("as_pose")(value, name));
  }
};

/// A fixed choice of words.
template <class T>
struct Convert<T, std::enable_if_t<std::is_enum_v<T>>> {
  static std::string type() { return std::string("gmcr._enums.") + options::Words<T>::name; }
  static std::string accepted() {
    std::string words;
    for (const auto& word : options::Words<T>::words) {
      words += (words.empty() ? "'" : ", '") + std::string(word.word) + "'";
    }
    return "typing.Literal[" + words + "] | " + type();
  }
  static nb::object to_python(T value, nb::handle) {
    return nb::module_::import_("gmcr._enums").attr(options::Words<T>::name)(name_of(value));
  }
  static T from_python(nb::handle value, const char* name) {
    std::string word;
    if (!nb::try_cast(value, word)) refuse(name, value, "a str");
    return parse_choice<T>(word, name);
  }
};

template <class T>
struct Convert<std::optional<T>> {
  static std::string type() { return Convert<T>::type() + " | None"; }
  static std::string accepted() { return Convert<T>::accepted() + " | None"; }
  static nb::object to_python(const std::optional<T>& value, nb::handle owner) {
    return value ? Convert<T>::to_python(*value, owner) : nb::none();
  }
  static std::optional<T> from_python(nb::handle value, const char* name) {
    if (value.is_none()) return std::nullopt;
    return Convert<T>::from_python(value, name);
  }
};

/// Lists of texts and of bound structs.
template <class T>
struct Convert<std::vector<T>, std::enable_if_t<!std::is_arithmetic_v<T>>> {
  static std::string type() { return "list[" + Convert<T>::type() + "]"; }
  static std::string accepted() { return type(); }
  static nb::object to_python(const std::vector<T>& values, nb::handle owner) {
    nb::list list;
    for (const T& value : values) list.append(Convert<T>::to_python(value, owner));
    return list;
  }
  static std::vector<T> from_python(nb::handle list, const char* name) {
    std::vector<T> values;
    for (nb::handle value : list) values.push_back(Convert<T>::from_python(value, name));
    return values;
  }
};

/// (min, max)
template <>
struct Convert<ScaleRange> {
  static std::string type() { return "tuple[float, float]"; }
  static std::string accepted() { return "collections.abc.Sequence[float]"; }
  static nb::object to_python(const ScaleRange& range, nb::handle) {
    return nb::make_tuple(range.min, range.max);
  }
  static ScaleRange from_python(nb::handle value, const char* name) {
    const auto ends = Convert<Eigen::VectorXd>::from_python(value, name);
    require_shape(ends.size() == 2, name, "2 values, min and max");
    return {ends[0], ends[1]};
  }
};

/// Stage name -> seconds, in order of first use.
template <>
struct Convert<std::vector<StageTime>> {
  static std::string type() { return "dict[str, float]"; }
  static std::string accepted() { return type(); }
  static nb::object to_python(const std::vector<StageTime>& stages, nb::handle) {
    nb::dict seconds;
    for (const StageTime& stage : stages) seconds[stage.name.c_str()] = stage.seconds;
    return seconds;
  }
  static std::vector<StageTime> from_python(nb::handle value, const char*) {
    std::vector<StageTime> stages;
    for (auto [name, seconds] : nb::borrow<nb::dict>(value)) {
      stages.push_back({nb::cast<std::string>(name), nb::cast<double>(seconds)});
    }
    return stages;
  }
};

}  // namespace gmcr::python
