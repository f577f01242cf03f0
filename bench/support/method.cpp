#include "support/method.hpp"

#include <algorithm>
#include <stdexcept>

namespace gmcr::bench {
namespace {

void use_gravity(Options& options, const Problem& problem) {
  if (!problem.gravity) throw std::invalid_argument("gravity: not known for this problem");
  options.gravity = problem.gravity;
}

void estimate_noise(Options& options) {
  options.noise_mode = NoiseMode::Estimated;
  options.noise_bound = 0;
}

}  // namespace

const std::vector<NamedMethod>& all_methods() {
  static const std::vector<NamedMethod> methods{
      {"gmcr", [](Options&, const Problem&) {}},
      {"gmcr-count", [](Options& options, const Problem&) { options.evidence = Evidence::Count; }},
      {"paper",
       [](Options& options, const Problem&) {
         options.method = Method::Paper;
         options.evidence = Evidence::Count;
       }},
      {"gmcr-certify", [](Options& options, const Problem&) { options.certify = true; }},
      {"gmcr-gravity", use_gravity},
      {"gmcr-auto-noise", [](Options& options, const Problem&) { estimate_noise(options); }},
  };
  return methods;
}

std::string method_names() {
  std::string names;
  for (const NamedMethod& method : all_methods()) {
    names += (names.empty() ? "" : ", ") + method.name;
  }
  return names;
}

std::vector<NamedMethod> methods_named(const std::vector<std::string>& names) {
  std::vector<NamedMethod> chosen;
  for (const std::string& name : names) {
    const auto method = std::find_if(all_methods().begin(), all_methods().end(),
                                     [&](const NamedMethod& m) { return m.name == name; });
    if (method == all_methods().end()) throw std::invalid_argument("methods: unknown " + name);
    chosen.push_back(*method);
  }
  return chosen;
}

}  // namespace gmcr::bench
