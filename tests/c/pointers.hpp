#pragma once

#include <gmcr.h>

#include <memory>

namespace gmcr::c {

struct Free {
  void operator()(gmcr_options* options) const { gmcr_options_free(options); }
  void operator()(gmcr_result* result) const { gmcr_result_free(result); }
  void operator()(char* string) const { gmcr_string_free(string); }
};
using OptionsPointer = std::unique_ptr<gmcr_options, Free>;
using ResultPointer = std::unique_ptr<gmcr_result, Free>;

}  // namespace gmcr::c
