#pragma once

#include <gmcr.h>

#include <exception>
#include <new>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/result.hpp"

/// What the pointers of gmcr.h point to.
struct gmcr_options {
  gmcr::Options options;
  gmcr::FrontendOptions frontend;
  std::string message;
};

struct gmcr_result {
  gmcr_error error = GMCR_SUCCESS;
  std::string message;
  gmcr::Options options;  ///< that it was computed with, but for what calls the caller
  gmcr::Result result;    ///< of matches; of two clouds empty
  std::optional<gmcr::CloudResult> clouds;

  const gmcr::Result& registration() const { return clouds ? clouds->registration : result; }
};

namespace gmcr::c {

/// Runs `work`; what it throws becomes an error and, where there is memory for it, a message.
template <class Work>
gmcr_error guarded(std::string& message, Work&& work) noexcept {
  const auto failed = [&](gmcr_error error, const char* text) noexcept {
    try {
      message = text;
    } catch (...) {
      message.clear();
    }
    return error;
  };
  try {
    message.clear();
    std::forward<Work>(work)();
    return GMCR_SUCCESS;
  } catch (const std::bad_alloc&) {
    return failed(GMCR_OUT_OF_MEMORY, "out of memory");
  } catch (const std::invalid_argument& error) {
    return failed(GMCR_INVALID_ARGUMENT, error.what());
  } catch (const std::exception& error) {
    return failed(GMCR_FAILURE, error.what());
  } catch (...) {
    return failed(GMCR_FAILURE, "unknown");
  }
}

}  // namespace gmcr::c
