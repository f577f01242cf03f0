#include "output/terminal.hpp"

#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace gmcr::cli {
namespace {

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

bool obeys_codes(int descriptor) {
  return isatty(descriptor) != 0 && environment("TERM") != "dumb";
}

bool takes_colours(int descriptor) {
  return obeys_codes(descriptor) && environment("NO_COLOR").empty();
}

}  // namespace gmcr::cli
