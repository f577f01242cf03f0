#include "output/options_json.hpp"

#include "options/json.hpp"

namespace gmcr::cli {

Json to_json(const Options& options) { return options::to_json<Json>(options); }
Json to_json(const FrontendOptions& options) { return options::to_json<Json>(options); }
Json to_json(const InstanceOptions& options) { return options::to_json<Json>(options); }

}  // namespace gmcr::cli
