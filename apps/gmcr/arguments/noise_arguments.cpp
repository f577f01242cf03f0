#include "arguments/noise_arguments.hpp"

#include <stdexcept>

#include "arguments/choice.hpp"
#include "arguments/validators.hpp"

namespace gmcr::cli {
namespace {

constexpr const char* kName = "--noise-bound";

}  // namespace

CLI::Option* NoiseArguments::add_to(CLI::App& command, const std::string& help) {
  const auto parse = [this](const CLI::results_t& given) {
    const std::string& text = given.front();
    if (text == "auto") {
      mode = NoiseMode::Estimated;
      return true;
    }
    bound = to_number(text);
    if (!bound) throw CLI::ValidationError(kName, "'" + text + "' is neither a number nor auto");
    return true;
  };
  add_choice(command, "--noise-mode", mode, "Whether the noise is given, or estimated as by auto")
      ->group("Noise");
  return command.add_option(kName, parse, help)->type_name("B|auto")->expected(1)->group("Noise");
}

void NoiseArguments::check_against(const Matches& matches, Options& options) const {
  if (matches.source.cols() == 0 && !is_given()) {
    options.noise_bound = 1;  // of no matches any is right
    return;
  }
  if (matches.noise_bounds.empty() && !is_given()) {
    throw std::invalid_argument(
        "the noise is not given: add --noise-bound B (metres) or --noise-bound auto, or a 7th "
        "column noise_bound to the matches");
  }
  if (matches.noise_bounds.empty()) return;
  if (is_given()) {
    throw std::invalid_argument(
        "--noise-bound: the matches have a noise bound of their own in the 7th column; give one of "
        "the two");
  }
  options.noise_bounds = matches.noise_bounds;
}

}  // namespace gmcr::cli
