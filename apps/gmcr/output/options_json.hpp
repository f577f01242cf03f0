#pragma once

#include "gmcr/frontend.hpp"
#include "gmcr/options.hpp"
#include "gmcr/registration.hpp"
#include "output/json.hpp"

namespace gmcr::cli {

/// Every choice that has a say, by the name of its field; an infinite number is null.
Json to_json(const Options& options);
Json to_json(const FrontendOptions& options);
Json to_json(const InstanceOptions& options);

}  // namespace gmcr::cli
