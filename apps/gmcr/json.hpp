#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>

#include "gmcr/result.hpp"

namespace gmcr::cli {

using Json = nlohmann::ordered_json;

/// Rows of rows.
Json rows_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// The fields of a result that are the contract of `--json`.
/// @param total_seconds  wall time of the work without reading files.
Json to_json(const Result& result, double total_seconds);

/// Prints the object on stdout, with full precision.
void print(const Json& json);

/// Writes the object to a file.
/// @throws IoError where that fails.
void write(const std::filesystem::path& path, const Json& json);

}  // namespace gmcr::cli
