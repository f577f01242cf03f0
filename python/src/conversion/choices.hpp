#pragma once

#include <stdexcept>
#include <string>

#include "gmcr/invalid_option.hpp"
#include "options/words.hpp"

namespace gmcr::python {

/// The word for a value, which is that of the member of the class in gmcr/_enums.py.
template <class T>
const char* name_of(T value) {
  return options::word_of(value);
}

/// @throws InvalidOption naming the field, the word and the words there are.
template <class T>
T parse_choice(const std::string& word, const char* field) {
  if (const auto value = options::value_of<T>(word)) return *value;
  throw InvalidOption(field,
                      "'" + word + "' is not one of '" + options::list_words<T>("', '") + "'");
}

}  // namespace gmcr::python
