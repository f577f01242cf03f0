#pragma once

#include <filesystem>
#include <string>

#include "gmcr/similarity.hpp"

namespace gmcr::cli {

/// A result that was written before.
struct Estimate {
  std::string status = "ok";
  Similarity pose;
};

/// Reads a 4 x 4 text file, or the JSON of `solve` or `register`, which a brace starts.
/// @throws IoError where it is neither.
Estimate read_estimate(const std::filesystem::path& path);

}  // namespace gmcr::cli
