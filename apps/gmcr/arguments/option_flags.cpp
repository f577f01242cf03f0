#include "arguments/option_flags.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "arguments/choice.hpp"
#include "arguments/validators.hpp"
#include "options/table.hpp"

namespace gmcr::cli {
namespace {

using options::About;

std::string metavar_of_unit(const std::string& unit) {
  if (unit == "metres") return "M";
  if (unit == "seconds") return "S";
  if (unit == "bytes") return "BYTES";
  if (unit == "voxels") return "VOXELS";
  return "";
}

/// A default as people read it.
template <class Value>
std::string default_of(Value value) {
  if (value == std::numeric_limits<Value>::max() || value == options::kInfinity) return "no limit";
  return fmt::format("{}", value);
}

/// Bytes in the largest unit of which they are a whole number.
std::string bytes_of(std::size_t bytes) {
  constexpr const char* kUnits[] = {"", "KB", "MB", "GB"};
  std::size_t unit = 0;
  for (; unit + 1 < std::size(kUnits) && bytes > 0 && bytes % 1024 == 0; ++unit) bytes /= 1024;
  return fmt::format("{}{}", bytes, kUnits[unit]);
}

template <class Value>
constexpr bool kIsNumber = std::is_arithmetic_v<Value> && !std::is_same_v<Value, bool>;

template <class Value>
CLI::Option* add_number(CLI::App& command, const About& about, Value& value) {
  CLI::Option* flag =
      command.add_option(flags_of(about.name, about.alias), value, options::describe(about))
          ->default_str(default_of(value));
  if constexpr (std::is_unsigned_v<Value>) flag->check(not_negative());
  const std::string metavar = metavar_of_unit(about.unit);
  if constexpr (std::is_same_v<Value, std::size_t>) {
    if (metavar == "BYTES") {
      flag->transform(CLI::AsSizeValue(false));
      flag->default_str(bytes_of(value));
    }
  }
  const char* number = std::is_integral_v<Value> ? "N" : "X";
  flag->type_name(metavar.empty() ? number : metavar);  // after the transform, which has its own
  return flag;
}

/// A switch; one that is on can be turned off.
CLI::Option* add_switch(CLI::App& command, const About& about, bool& value) {
  const std::string flag = flag_of(about.name);
  return command.add_flag(value ? flag + ",!--no-" + flag.substr(2) : flag, value,
                          options::describe(about) + (value ? " (default)" : ""));
}

CLI::Option* add_vector(CLI::App& command, const About& about, Eigen::Vector3d& vector) {
  const auto parse = [&vector](const std::vector<double>& given) {
    vector = Eigen::Vector3d(given.data());
  };
  return command
      .add_option_function<std::vector<double>>(flags_of(about.name, about.alias), parse,
                                                options::describe(about))
      ->expected(3)
      ->type_name("X Y Z");
}

/// @param range  a `ScaleRange`, optional or not.
template <class Range>
CLI::Option* add_range(CLI::App& command, const About& about, Range& range) {
  const auto parse = [&range](const std::vector<double>& given) {
    range = ScaleRange{given[0], given[1]};
  };
  return command
      .add_option_function<std::vector<double>>(flags_of(about.name, about.alias), parse,
                                                options::describe(about))
      ->expected(2)
      ->type_name("MIN MAX");
}

/// null where the value is not of a kind that a line of text can give.
template <class Value>
CLI::Option* add_flag(CLI::App& command, const About& about, Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return add_choice(command, flags_of(about.name, about.alias), value, options::describe(about));
  } else if constexpr (std::is_same_v<Value, bool>) {
    return add_switch(command, about, value);
  } else if constexpr (kIsNumber<Value>) {
    return add_number(command, about, value);
  } else if constexpr (std::is_same_v<Value, Eigen::Vector3d>) {
    return add_vector(command, about, value);
  } else if constexpr (std::is_same_v<Value, ScaleRange> ||
                       std::is_same_v<Value, std::optional<ScaleRange>>) {
    return add_range(command, about, value);
  } else {
    return nullptr;
  }
}

template <class Struct>
void add_all(CLI::App& command, Struct& values, const Selection& selection) {
  options::for_each_option<Struct>([&](const auto& option) {
    if (selection && !selection(option.about.name)) return;
    CLI::Option* flag = add_flag(command, option.about, std::invoke(option.place, values));
    if (flag && *option.about.group) flag->group(option.about.group);
  });
}

bool is_written(const std::string& flag, int argc, char** argv) {
  return std::any_of(argv, argv + argc, [&](const std::string& word) {
    return word == flag || word.starts_with(flag + "=");
  });
}

/// Replaces `from` where it stands as a whole word.
void replace_word(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at)) {
    const std::size_t end = at + from.size();
    const bool is_whole =
        end == text.size() ||
        !(std::isalnum(static_cast<unsigned char>(text[end])) || text[end] == '-');
    if (is_whole) text.replace(at, from.size(), to);
    at += is_whole ? to.size() : from.size();
  }
}

}  // namespace

std::string flag_of(const std::string& option) {
  std::string flag = "--" + option;
  std::replace_if(
      flag.begin(), flag.end(), [](char c) { return c == '_' || c == '.'; }, '-');
  return flag;
}

std::string flags_of(const std::string& option, const std::string& alias) {
  return flag_of(option) + (alias.empty() ? "" : ",--" + alias);
}

void add_flags(CLI::App& command, Options& values, const Selection& selection) {
  add_all(command, values, selection);
}

void add_flags(CLI::App& command, FrontendOptions& values, const Selection& selection) {
  add_all(command, values, selection);
}

void add_flags(CLI::App& command, InstanceOptions& values, const Selection& selection) {
  add_all(command, values, selection);
}

void add_flags(CLI::App& command, CliqueOptions& values, const Selection& selection) {
  add_all(command, values, selection);
}

void add_flags(CLI::App& command, SyntheticOptions& values, const Selection& selection) {
  add_all(command, values, selection);
}

std::string as_written(std::string message, const CLI::App& app, int argc, char** argv) {
  const std::string name = argc > 1 ? argv[1] : "";
  const auto is_named = [&](const CLI::App* command) { return command->get_name() == name; };
  for (const CLI::App* command : app.get_subcommands(is_named)) {
    for (const CLI::Option* option : command->get_options()) {
      const std::vector<std::string>& names = option->get_lnames();
      for (std::size_t i = 1; i < names.size(); ++i) {
        const std::string alias = "--" + names[i];
        if (is_written(alias, argc, argv)) replace_word(message, "--" + names[0], alias);
      }
    }
  }
  return message;
}

}  // namespace gmcr::cli
