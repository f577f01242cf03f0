#include "support/method.hpp"

#include <algorithm>
#include <stdexcept>

namespace gmcr::bench {

const std::vector<NamedMethod>& all_methods() {
  static const std::vector<NamedMethod> methods{
      {"gmcr", Method::Gmcr, Evidence::Distinct},
      {"gmcr-count", Method::Gmcr, Evidence::Count},
      {"paper", Method::Paper, Evidence::Count},
  };
  return methods;
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
