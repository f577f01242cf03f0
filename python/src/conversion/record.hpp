#pragma once

#include <nanobind/nanobind.h>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "conversion/convert.hpp"

namespace gmcr::python {

/// A C++ struct of plain fields as a Python class: its fields are properties, it can be pickled and
/// copied, and where it is settable it is made from keywords, whose defaults are those of T{}.
///
///   Record<InstanceOptions>(module, "InstanceOptions", "...")
///       .field("max_instances", &InstanceOptions::max_instances, "Most instances, >= 1.")
///       .settable();
template <class T>
class Record {
 public:
  Record(nb::module_& module, const char* name, const char* doc)
      : class_(module, name, doc), name_(name) {}

  /// @param place  pointer to the member, or a function from T& to a reference.
  template <class Place>
  Record& field(const char* name, Place place, const std::string& doc) {
    using Value = std::remove_cvref_t<std::invoke_result_t<Place, T&>>;
    fields_->push_back({name, doc, Convert<Value>::type(), Convert<Value>::accepted(),
                        [place](const T& self, nb::handle owner) {
                          return Convert<Value>::to_python(std::invoke(place, const_cast<T&>(self)),
                                                           owner);
                        },
                        [place, name](T& self, nb::handle value) {
                          std::invoke(place, self) = Convert<Value>::from_python(value, name);
                        }});
    return *this;
  }

  /// A keyword that is none any more, and what to do instead.
  Record& gone(const std::string& name, const std::string& advice) {
    (*gone_)[name] = advice;
    return *this;
  }

  /// Fields can be set, and given as keywords.
  nb::class_<T>& settable() {
    for (std::size_t i = 0; i < fields_->size(); ++i) {
      const Field& field = (*fields_)[i];
      const std::string set = "def " + field.name + "(self, value: " + field.accepted + ") -> None";
      class_.def_prop_rw(
          field.name.c_str(), getter(i),
          [fields = fields_, i](T& self, const nb::object& value) {
            (*fields)[i].set(self, value);
          },
          nb::for_getter(nb::sig(getter_signature(field).c_str())),
          nb::for_setter(nb::sig(set.c_str())), field.doc.c_str());
    }
    class_.def("__init__", initialiser(), nb::sig(init_signature().c_str()));
    class_.def("__repr__", [fields = fields_, name = name_](nb::handle self) {
      return describe(*fields, name, self, true);
    });
    return with_state();
  }

  /// Fields can be read only.
  /// @param text  of `repr`; by default all fields.
  nb::class_<T>& read_only(std::function<std::string(const T&)> text = nullptr) {
    class_.def(
        "__repr__", [fields = fields_, name = name_, text = std::move(text)](nb::handle self) {
          return text ? text(nb::cast<const T&>(self)) : describe(*fields, name, self, false);
        });
    for (std::size_t i = 0; i < fields_->size(); ++i) {
      const Field& field = (*fields_)[i];
      class_.def_prop_ro(field.name.c_str(), getter(i), nb::sig(getter_signature(field).c_str()),
                         field.doc.c_str());
    }
    return with_state();
  }

 private:
  struct Field {
    std::string name, doc, type, accepted;
    std::function<nb::object(const T&, nb::handle)> get;
    std::function<void(T&, nb::handle)> set;
  };
  using Fields = std::vector<Field>;

  static std::string repr(const nb::object& value) {
    return nb::cast<std::string>(nb::repr(value));
  }

  /// "Name(field=value, ...)".
  static std::string describe(const Fields& fields, const std::string& name, nb::handle self,
                              bool skip_defaults) {
    const T defaults{};
    std::string text;
    for (const Field& field : fields) {
      const std::string value = repr(field.get(nb::cast<const T&>(self), self));
      if (skip_defaults && value == repr(field.get(defaults, self))) continue;
      text += (text.empty() ? "" : ", ") + field.name + "=" + value;
    }
    return name + "(" + text + ")";
  }

  /// "; did you mean 'num_threads'?" of 'threads'.
  static std::string advice(const Fields& fields, const std::map<std::string, std::string>& gone,
                            const std::string& word) {
    if (const auto found = gone.find(word); found != gone.end()) return ": " + found->second;
    nb::list names;
    for (const Field& field : fields) names.append(field.name);
    return nb::cast<std::string>(nb::module_::import_("gmcr._hints").attr("advice")(word, names));
  }

  static std::string getter_signature(const Field& field) {
    return "def " + field.name + "(self) -> " + field.type;
  }

  std::string init_signature() const {
    const T defaults{};
    std::string text = "def __init__(self, *";
    for (const Field& field : *fields_) {
      const nb::object value = field.get(defaults, nb::none());
      const bool is_plain = !nb::hasattr(value, "__array__") && !nb::isinstance<Similarity>(value);
      std::string shown = is_plain ? repr(value) : "...";
      if (shown == "inf") shown = "float('inf')";
      text += ", " + field.name + ": " + field.accepted + " = " + shown;
    }
    return text + ") -> None";
  }

  auto getter(std::size_t i) const {
    return [fields = fields_, i](nb::handle self) {
      return (*fields)[i].get(nb::cast<const T&>(self), self);
    };
  }

  auto initialiser() const {
    return [fields = fields_, gone = gone_, name = name_](T* self, const nb::args& unnamed,
                                                          const nb::kwargs& keywords) {
      if (!unnamed.empty()) {
        throw nb::type_error(
            (name + "() takes keywords only; write gmcr." + made_like(name)).c_str());
      }
      T value{};
      for (auto [keyword, given] : keywords) {
        const auto word = nb::cast<std::string>(keyword);
        const auto field = std::find_if(fields->begin(), fields->end(),
                                        [&](const Field& known) { return known.name == word; });
        if (field == fields->end()) {
          throw nb::type_error((name + "() got an unexpected keyword argument '" + word + "'" +
                                advice(*fields, *gone, word))
                                   .c_str());
        }
        field->set(value, given);
      }
      new (self) T(std::move(value));
    };
  }

  nb::class_<T>& with_state() {
    class_.def(
        "__getstate__",
        [fields = fields_](nb::handle self) {
          nb::dict state;
          for (const Field& field : *fields) {
            state[field.name.c_str()] = field.get(nb::cast<const T&>(self), self);
          }
          return state;
        },
        nb::sig("def __getstate__(self) -> dict[str, typing.Any]"));
    class_.def(
        "__setstate__",
        [fields = fields_](T& self, const nb::dict& state) {
          T value{};
          for (const Field& field : *fields) field.set(value, state[field.name.c_str()]);
          new (&self) T(std::move(value));
        },
        nb::sig("def __setstate__(self, state: dict[str, typing.Any]) -> None"));
    return class_;
  }

  nb::class_<T> class_;
  std::string name_;
  std::shared_ptr<Fields> fields_ = std::make_shared<Fields>();
  std::shared_ptr<std::map<std::string, std::string>> gone_ =
      std::make_shared<std::map<std::string, std::string>>();
};

}  // namespace gmcr::python
