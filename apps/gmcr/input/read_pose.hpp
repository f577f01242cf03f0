#pragma once

#include <string>

#include "gmcr/similarity.hpp"

namespace gmcr::cli {

/// The pose of what `read_estimate` reads at a path, also of a pipe or, for "-", from stdin.
/// @throws IoError as it, and where the result has no pose.
Similarity read_pose(const std::string& path);

}  // namespace gmcr::cli
