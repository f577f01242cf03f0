#include <cmath>
#include <limits>
#include <span>
#include <string_view>
#include <type_traits>
#include <variant>

#include "c/objects.hpp"
#include "options/table.hpp"
#include "options/words.hpp"

namespace gmcr::c {
namespace {

using Numbers = std::span<const double>;
using Given = std::variant<double, std::string_view, Numbers>;

/// What the caller gave, where it is what the option takes.
template <class Wanted>
Wanted take(const Given& given, const std::string& name, const char* what) {
  const Wanted* value = std::get_if<Wanted>(&given);
  if (value == nullptr) throw InvalidOption(name, std::string("takes ") + what);
  return *value;
}

Numbers take_numbers(const Given& given, const std::string& name, std::size_t count) {
  const Numbers numbers = take<Numbers>(given, name, "numbers");
  if (numbers.size() != count) {
    throw InvalidOption(
        name, "takes " + std::to_string(count) + " numbers, not " + std::to_string(numbers.size()));
  }
  return numbers;
}

/// A whole number that `Value` can hold.
template <class Value>
Value whole(double number, const std::string& name) {
  const double least = static_cast<double>(std::numeric_limits<Value>::min());
  // exact, where the largest value itself may be no double
  const double end = std::ldexp(1.0, std::numeric_limits<Value>::digits);
  if (!(number >= least && number < end && std::trunc(number) == number)) {
    throw InvalidOption(name, std::to_string(number) + " is not a whole number that it can hold");
  }
  return static_cast<Value>(number);
}

template <class Value>
void assign(Value& place, const Given& given, const std::string& name) {
  if constexpr (std::is_enum_v<Value>) {
    const auto word = take<std::string_view>(given, name, "a word");
    const std::optional<Value> value = options::value_of<Value>(word);
    if (!value) {
      throw InvalidOption(name,
                          std::string(word) + " is not one of " + options::list_words<Value>());
    }
    place = *value;
  } else if constexpr (std::is_same_v<Value, double>) {
    place = take<double>(given, name, "a number");
  } else if constexpr (std::is_arithmetic_v<Value>) {
    place = whole<Value>(take<double>(given, name, "a number"), name);
  } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
    const auto numbers = take<Numbers>(given, name, "numbers");
    place.assign(numbers.begin(), numbers.end());
  } else if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
    place = Eigen::Map<const Eigen::Vector3d>(take_numbers(given, name, 3).data());
  } else if constexpr (std::is_same_v<Value, std::optional<ScaleRange>>) {
    const Numbers range = take_numbers(given, name, 2);
    place = ScaleRange{range[0], range[1]};
  } else if constexpr (std::is_same_v<Value, Similarity>) {
    using RowMajor = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
    place =
        Similarity::from_matrix(Eigen::Map<const RowMajor>(take_numbers(given, name, 16).data()));
  } else {
    throw InvalidOption(name, "has a call of its own");
  }
}

template <class Struct>
bool set(Struct& values, std::string_view name, const Given& given, const std::string& prefix = "");

/// A struct of options that may be absent: "name.option" sets one of its own.
template <class Value>
bool set_inside(std::optional<Value>& place, std::string_view rest, const Given& given,
                const std::string& prefix) {
  Value values = place.value_or(Value{});
  if (!set(values, rest, given, prefix)) return false;
  place = std::move(values);
  return true;
}

template <class Value>
constexpr bool kIsOptionalStruct = false;
template <class Value>
constexpr bool kIsOptionalStruct<std::optional<Value>> = options::HasTable<Value>;

/// @return whether there is an option of that name.
template <class Struct>
bool set(Struct& values, std::string_view name, const Given& given, const std::string& prefix) {
  bool found = false;
  options::for_each_option<Struct>([&](const auto& option) {
    auto& place = std::invoke(option.place, values);
    const std::string own = option.about.name;
    if constexpr (kIsOptionalStruct<std::remove_cvref_t<decltype(place)>>) {
      if (name.starts_with(own + ".")) {
        found = set_inside(place, name.substr(own.size() + 1), given, prefix + own + ".");
      }
    } else if (name == own) {
      assign(place, given, prefix + own);
      found = true;
    }
  });
  return found;
}

gmcr_error set_option(gmcr_options* options, const char* name, const Given& given) {
  if (options == nullptr) return GMCR_INVALID_ARGUMENT;
  return guarded(options->message, [&] {
    if (name == nullptr) throw std::invalid_argument("name: is null");
    if (!set(options->options, name, given) && !set(options->frontend, name, given)) {
      throw InvalidOption(name, "there is no such option");
    }
  });
}

}  // namespace
}  // namespace gmcr::c

gmcr_options* gmcr_options_new(void) {
  try {
    return new gmcr_options;
  } catch (...) {
    return nullptr;
  }
}

void gmcr_options_free(gmcr_options* options) { delete options; }

gmcr_error gmcr_options_set_number(gmcr_options* options, const char* name, double value) {
  return gmcr::c::set_option(options, name, value);
}

gmcr_error gmcr_options_set_word(gmcr_options* options, const char* name, const char* word) {
  return gmcr::c::set_option(options, name, std::string_view(word == nullptr ? "" : word));
}

gmcr_error gmcr_options_set_numbers(gmcr_options* options, const char* name, const double* values,
                                    size_t count) {
  return gmcr::c::set_option(options, name,
                             gmcr::c::Numbers(values, values == nullptr ? 0 : count));
}

gmcr_error gmcr_options_set_progress(gmcr_options* options, gmcr_progress progress, void* user) {
  if (options == nullptr) return GMCR_INVALID_ARGUMENT;
  return gmcr::c::guarded(options->message, [&] {
    if (progress == nullptr) {
      options->options.progress = nullptr;
      return;
    }
    options->options.progress = [progress, user](const gmcr::Progress& state) {
      return progress(state.stage, state.fraction, user) != 0;
    };
  });
}

const char* gmcr_options_message(const gmcr_options* options) {
  return options == nullptr ? "options: is null" : options->message.c_str();
}
