#pragma once

#include <optional>
#include <string>

#include "conversion/convert.hpp"

namespace gmcr::python {

/// The noise bound as Python takes it: metres, or 'auto', which has it estimated.
struct NoiseBound {
  Options& options;

  void operator=(std::optional<double> metres) {
    if (!metres) options.noise_mode = NoiseMode::Estimated;
    options.noise_bound = metres.value_or(0);
  }
};

template <>
struct Convert<NoiseBound> {
  static std::string type() { return Convert<double>::type(); }
  static std::string accepted() { return type() + " | typing.Literal['auto']"; }
  static nb::object to_python(const NoiseBound& bound, nb::handle) {
    return nb::cast(bound.options.noise_bound);
  }
  static std::optional<double> from_python(nb::handle value, const char* name) {
    double metres = 0;
    if (nb::try_cast(value, metres)) return metres;
    std::string word;
    if (nb::try_cast(value, word) && word == "auto") return std::nullopt;
    refuse(name, value, "a number of metres or 'auto'");
  }
};

}  // namespace gmcr::python
