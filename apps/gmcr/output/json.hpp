#pragma once

#include <Eigen/Core>
#include <nlohmann/json.hpp>

namespace gmcr::cli {

/// Fields in the order in which they were set. A number that is not finite is printed as null.
using Json = nlohmann::ordered_json;

/// Rows of rows.
Json rows_of(const Eigen::Ref<const Eigen::MatrixXd>& matrix);

/// Prints the object on stdout, with full precision.
void print(const Json& json);

}  // namespace gmcr::cli
