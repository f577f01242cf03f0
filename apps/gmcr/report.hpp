#pragma once

#include <fmt/color.h>

#include <string>
#include <string_view>

#include "gmcr/types.hpp"

namespace gmcr::cli {

/// Lines "label  text" of a report for people; colours only on a terminal.
class Report {
 public:
  Report();

  void line(std::string_view label, std::string_view text);

  /// A line in a colour that says how good it is.
  enum class Tone { Good, Fair, Bad };
  void line(std::string_view label, std::string_view text, Tone tone);

  /// Prints it on stdout.
  void print() const;

 private:
  bool is_terminal_;
  std::string text_;
};

/// "44 of 5344 (0.8 %)".
std::string share(Index part, Index whole);

/// "1.23 ms", "45.6 s".
std::string duration(double seconds);

}  // namespace gmcr::cli
