#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "options/words.hpp"

namespace gmcr::cli {

/// Adds `--name WORD` with one of the words of an enumeration, or an alias of one; help shows the
/// current value as the default.
template <class Enum>
CLI::Option* add_choice(CLI::App& command, const std::string& flags, Enum& value,
                        const std::string& help) {
  const std::string words = options::list_words<Enum>();
  const std::string flag = flags.substr(0, flags.find(','));
  const auto parse = [&value, words, flag](const CLI::results_t& given) {
    const auto found = options::value_of<Enum>(given.front(), true);
    if (!found) throw CLI::ValidationError(flag, "'" + given.front() + "' is none of " + words);
    value = *found;
    return true;
  };
  return command.add_option(flags, parse, help)
      ->type_name(words)
      ->default_str(options::word_of(value))
      ->expected(1);
}

}  // namespace gmcr::cli
