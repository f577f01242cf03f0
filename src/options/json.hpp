#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options/table.hpp"
#include "options/words.hpp"

/// Options as JSON. `Json` is nlohmann's, which this header does not need itself.
namespace gmcr::options {

template <class Json, class Value>
Json value_to_json(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return word_of(value);
  } else if constexpr (std::is_same_v<Value, ScaleRange>) {
    return Json::array({value.min, value.max});
  } else if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
    return Json::array({value.x(), value.y(), value.z()});
  } else {
    return value;
  }
}

/// Sets the field `name` of `json`, or where the value has a table of its own or is a pose, the
/// fields "name.x". What is not given, such as an empty list, has no field.
template <class Json, class Value>
void set_field(Json& json, const std::string& name, const Value& value) {
  json[name] = value_to_json<Json>(value);
}

template <class Json, class Value>
void set_field(Json& json, const std::string& name, const std::vector<Value>& values) {
  if (!values.empty()) json[name] = values;
}

template <class Json>
void set_field(Json&, const std::string&, const ProgressCallback&) {}

template <class Json, class Struct>
void set_fields(Json& json, const Struct& values, const std::string& prefix = "");

template <class Json, class Value>
void set_field(Json& json, const std::string& name, const std::optional<Value>& value) {
  if (!value) return;
  if constexpr (HasTable<Value>) {
    set_fields(json, *value, name + ".");
  } else {
    json[name] = value_to_json<Json>(*value);
  }
}

/// "initial_pose.rotation" and "initial_pose.translation", since its scale is not used.
template <class Json>
void set_pose(Json& json, const std::string& prefix, const Similarity& pose) {
  Json rows = Json::array();
  for (Index i = 0; i < 3; ++i) {
    rows.push_back(value_to_json<Json>(Eigen::Vector3d(pose.rotation.row(i))));
  }
  json[prefix + "rotation"] = std::move(rows);
  json[prefix + "translation"] = value_to_json<Json>(pose.translation);
}

template <class Json, class Struct>
void set_fields(Json& json, const Struct& values, const std::string& prefix) {
  for_each_option<Struct>([&](const auto& option) {
    using Value = ValueOf<Struct, decltype(option.place)>;
    if (!Table<Struct>::is_used(values, option.about.name)) return;
    const Value& value = std::invoke(option.place, values);
    if constexpr (std::is_same_v<Value, Similarity>) {
      set_pose(json, prefix, value);
    } else {
      set_field(json, prefix + option.about.name, value);
    }
  });
}

/// The options that have a say, by name; an infinite number is printed as null.
template <class Json, class Struct>
Json to_json(const Struct& values) {
  Json json;
  set_fields(json, values);
  return json;
}

}  // namespace gmcr::options
