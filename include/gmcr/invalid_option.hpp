#pragma once

#include <stdexcept>
#include <string>
#include <utility>

#include "gmcr/visibility.hpp"

namespace GMCR_PUBLIC gmcr {

/// An option is out of range, or does not fit the others. `what()` is "option: problem".
class InvalidOption : public std::invalid_argument {
 public:
  /// @param option   its name, such as "time_limit" or "gravity.max_tilt"
  /// @param problem  what is wrong with its value, such as "0 is not positive"
  InvalidOption(std::string option, std::string problem)
      : std::invalid_argument(option + ": " + problem),
        option_(std::move(option)),
        problem_(std::move(problem)) {}

  const std::string& option() const { return option_; }    ///< as given to the constructor
  const std::string& problem() const { return problem_; }  ///< as given to the constructor

 private:
  std::string option_;
  std::string problem_;
};

}  // namespace gmcr
