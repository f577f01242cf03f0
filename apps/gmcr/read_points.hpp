#pragma once

#include <filesystem>

#include "gmcr/types.hpp"

namespace gmcr::cli {

/// Reads a cloud; a warning on stderr says how many points were not finite.
Points read_points(const std::filesystem::path& path);

}  // namespace gmcr::cli
